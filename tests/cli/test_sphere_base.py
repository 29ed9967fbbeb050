# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Forces of heaps of spheres on their base, by cells and rings. Units: grain diameter, grain mass, gravity; z points upwards."""

import h5py
import numpy as np
import pytest
from conftest import datasets, summary

# A heap that falls from above onto the middle of a base and comes to rest.
HEAP = """dimension = 3
seed = 4
grains = { polydispersity = 0.2 }
box = { half_width = 12.0 }
source = { kind = "rain", count = 80, rate = 40.0, height = 8.0, opening = "disc", radius = 1.5 }
%s
[contact]
friction = 0.5
normal = { law = "hooke", stiffness = 2000, restitution = 0.4 }
tangential = { law = "linear", stiffness = 1000, damping = 0.5 }
rolling = { law = "spring", friction = 0.2, stiffness = 500 }
[stop]
at_rest = 1e-8
time = 50
[output]
frames = 0
window = 2.0
[analysis]
base_cell = 1.5
"""
BED = 'base = { kind = "bed", radius = 9.0, disorder = 0.1, roughness = 0.2 }\n'
DEPOSITED = 'base = { kind = "deposited", radius = 9.0 }\n'
PLANE = 'base = { kind = "plane" }\n'
FLOOR = "[[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\n"


def cells_of(out):
    """Columns and attributes of the cells."""
    with h5py.File(out / "analysis.h5") as file:
        group = file["base_cells"]
        return {name: values[()] for name, values in group.items()}, dict(group.attrs)


def weight_of(out):
    """Of all grains that move, which all lie in the heap."""
    found = datasets(out / "run.h5")
    return found["/grains/mass"][found["/grains/fixed"] == 0].sum()


# At rest the base carries the weight. Floors are read at one time, beds as means over the window.
@pytest.mark.parametrize("base", [BED, DEPOSITED, PLANE, FLOOR], ids=["bed", "deposited", "plane", "wall"])
def test_cells_carry_the_weight(lab, base):
    out = lab.run(HEAP % base)
    assert summary(out)["grains"] == 80 and summary(out)["grains_lost"] == 0
    cells, attributes = cells_of(out)
    area = attributes["side_x"] * attributes["side_y"]
    assert area == pytest.approx(1.5**2, rel=1e-12)
    load = cells["pressure"].sum() * area
    assert load == pytest.approx(attributes["load"], rel=1e-12)
    assert load == pytest.approx(weight_of(out), rel=1e-8)
    with h5py.File(out / "analysis.h5") as file:
        rings = file["base_rings"]
        assert rings.attrs["load"] == pytest.approx(load, rel=1e-12)
        assert np.sum(rings["count"]) == cells["count"].sum()
    for axis in "xy":
        assert cells[f"shear_{axis}"].sum() * area == pytest.approx(attributes[f"traction_{axis}"], abs=1e-10 * load)
        assert abs(attributes[f"traction_{axis}"]) < 1e-7 * load  # at rest nothing drives the heap along the base
    assert len(set(zip(cells["x"], cells["y"]))) == len(cells["x"])
    np.testing.assert_allclose(cells["x"] / 1.5, np.rint(cells["x"] / 1.5), atol=1e-12)


def test_cells_of_a_floor_are_those_of_its_contacts(lab):
    out = lab.run(HEAP % FLOOR)
    cells, _ = cells_of(out)
    with h5py.File(out / "run.h5") as run:
        contacts, grains = run["contacts"], run["grains"]
        on_floor = contacts["grains"][:, 1] == -1
        row = np.searchsorted(grains["id"][:], contacts["grains"][on_floor, 0])
        place, force = grains["position"][:][row, :2], contacts["normal_force"][on_floor]
    cell = np.floor(place / 1.5 + 0.5)
    assert len(np.unique(cell, axis=0)) == len(cells["x"])
    for x, y, count, pressure in zip(cells["x"], cells["y"], cells["count"], cells["pressure"]):
        inside = (np.rint(cell * 1.5 * 4) == np.rint(np.array([x, y]) * 4)).all(axis=1)
        assert count == inside.sum()
        assert pressure * 1.5**2 == pytest.approx(force[inside].sum(), rel=1e-9)


def test_analysing_again_gives_the_same_cells(lab):
    out = lab.run(HEAP % BED, "--set", "stop.time=6")
    before, _ = cells_of(out)
    assert lab("analyse", "out", "--quiet").returncode == 0
    after, _ = cells_of(out)
    for name, values in before.items():
        np.testing.assert_array_equal(after[name], values)


def test_a_deposited_base_is_that_of_its_seed(lab):
    """The same bits for any number of threads; another base for another seed."""
    scene = HEAP % DEPOSITED
    one = lab.run(scene, "--threads", "1", "--set", "stop.time=2", out="one")
    two = lab.run(scene, "--threads", "2", "--set", "stop.time=2", out="two")
    other = lab.run(scene, "--set", "stop.time=2", "--set", "seed=5", out="other")
    assert summary(one)["state_hash"] == summary(two)["state_hash"]
    bases = []
    for out in (one, two, other):
        with h5py.File(out / "run.h5") as run:
            bases.append(run["grains/position"][:][run["grains/base"][:] == 1])
    np.testing.assert_array_equal(bases[0], bases[1])
    assert bases[0][:, 2].max() == 0.0
    assert not np.isin(bases[2][:, 0], bases[0][:, 0]).any()


@pytest.mark.parametrize("text, message", [
    ("base = { kind = 'deposited' }\n", "base.radius: missing"),
    ("base = { kind = 'deposited', radius = 1.0 }\n", "base.radius = 1: must be at least two of the largest diameters"),
    ("base = { kind = 'plane' }\nanalysis = { base_cell = 0.001 }\n", "analysis.base_cell = 0.001: must be from 0.01"),
])
def test_bad_input(lab, text, message):
    lab.scene("dimension = 3\nstop = { time = 1 }\n" + text + "[[grain]]\nposition = [0.0, 0.0, 3.0]\n")
    lab.refused("check", "scene.toml", parts=[message])
