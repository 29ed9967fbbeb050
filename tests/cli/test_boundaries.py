# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Walls, gates, pistons, open ends and loads from scene files. Units: grain diameter, grain mass, gravity."""

import math
from pathlib import Path

import h5py
import numpy as np
import pytest
from conftest import Grains, assert_same_bits, datasets, summary

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
STIFF = "[contact]\nnormal = { law = 'hooke', stiffness = 1e4 }\ntangential = { law = 'linear', stiffness = 5e3, damping = 0.2 }\n"


def example(lab, name, *options, out="out"):
    result = lab("run", EXAMPLES / f"{name}.toml", "--out", out, "--quiet", *options)
    assert result.returncode == 0, result.stderr
    return lab.path / out


def wall_names(out):
    with h5py.File(out / "run.h5") as file:
        return [name.decode() if isinstance(name, bytes) else name for name in file["walls/name"][()]]


# A disc rolls from rest with the acceleration 2/3 g sin(20 deg), so by 1/3 g sin t^2 after t; the step adds a part in 3000.
def test_incline(lab):
    grains = Grains(example(lab, "incline") / "run.h5")
    displacement = np.hypot(*(grains.position[0] - [60.0, 22.3695]))
    assert displacement == pytest.approx(math.sin(math.radians(20)) / 3 * 15.0**2, rel=1e-3)


# Slip ends at V = 3 mu g t with v = V / 3 (see the unit test). Friction dissipates half of the work of the belt; the other
# half is kinetic energy.
def test_belt(lab):
    out = example(lab, "belt")
    assert Grains(out / "run.h5").velocity[0, 0] == pytest.approx(1.0, abs=2e-3)
    energy = {name.removeprefix("/energy/"): x[-1] for name, x in datasets(out / "run.h5").items() if "/energy/" in name}
    assert energy["walls_work"] == pytest.approx(3.0, abs=1e-2)
    assert energy["walls"] == pytest.approx(1.5, abs=1e-2)
    assert energy["kinetic"] == pytest.approx(1.5, abs=1e-2)
    assert abs(energy["error"]) < 1e-6


# At rest the piston carries its force, the side walls balance, and floor and sides carry the weight and the piston force.
def test_piston(lab):
    out = example(lab, "piston")
    found = datasets(out / "run.h5")
    assert wall_names(out) == ["base", "left", "right", "piston"]
    base, left, right, piston = np.stack([found["/series/wall_force_x"][-1], found["/series/wall_force_y"][-1]], axis=1)
    weight = Grains(out / "run.h5").mass.sum()
    assert piston[1] == pytest.approx(160.0, abs=1e-3)
    assert -(base + left + right)[1] == pytest.approx(weight + 160.0, abs=1e-3)
    assert abs((base + left + right + piston)[0]) < 1e-3
    assert left[0] < -20.0 and right[0] > 20.0
    displacement = found["/series/wall_displacement"]
    assert (displacement[:, :3] == 0.0).all()
    assert (displacement[found["/series/time"] <= 60.0, 3] == 0.0).all() and 40.0 < displacement[-1, 3] < 55.0


# The energy budget closes to second order in the step (docs/physics/soft.md): half the step leaves a quarter of the error.
# Impacts differ in detail between the two runs, so the test accepts between an eighth and a half.
def test_energy_closes_to_second_order(lab):
    error = []
    for k, step in enumerate((0.0016, 0.0008)):
        out = example(lab, "piston", "--set", f"method.time_step={step}", out=f"out{k}")
        found = datasets(out / "run.h5")
        put_in = found["/energy/sources"] + found["/energy/walls_work"]
        there = found["/energy/kinetic"] + found["/energy/gravitational"] + found["/energy/elastic"]
        gone = found["/energy/damping"] + found["/energy/friction"] + found["/energy/walls"]
        assert np.allclose(there + gone - put_in, found["/energy/error"], atol=1e-6)
        error.append(abs(found["/energy/error"][-1]) / put_in[-1])
    assert error[0] < 0.01
    assert 0.125 < error[1] / error[0] < 0.5


# The energy budget changes no bit of the run.
def test_the_energy_budget_does_not_change_the_run(lab):
    short = ("--set", "stop.time=30")
    with_account, without = (
        datasets(example(lab, "piston", "--set", f"output.energy={flag}", *short, out=flag) / "run.h5")
        for flag in ("true", "false")
    )
    assert {name for name in with_account if name not in without} == {
        f"/energy/{name}" for name in ("time kinetic gravitational elastic sources lost walls_work loads_work damping "
                                       "friction walls drag error").split()
    }
    for name, values in without.items():
        assert name == "/scene" or values.tobytes() == with_account[name].tobytes(), name


# No grain falls before the gate opens, and all fall after.
def test_hopper(lab):
    out = example(lab, "hopper", "--set", "source.count=400", "--set", "stop.time=150")
    found = datasets(out / "run.h5")
    lost, time = found["/series/lost"], found["/series/time"]
    assert (lost[time <= 92.0] == 0).all()
    assert lost[-1] == 400 and summary(out)["grains_lost"] == 400
    assert (np.diff(lost) >= 0).all()
    # The gate carries the grains until it opens, and nothing afterwards.
    gate = wall_names(out).index("gate")
    before, after = (time > 80.0) & (time <= 90.0), time > 91.0
    assert (found["/series/wall_force_y"][before, gate] < -10.0).all()
    assert (found["/series/wall_force_y"][after, gate] == 0.0).all()


# The base carries the weight and the load.
def test_point_load(lab):
    small = ("--set", "source.count=200", "--set", "stop.time=150", "--set", "output.window=10")
    out = example(lab, "point-load", *small)
    grains = Grains(out / "run.h5")
    weight = grains.mass[~grains.fixed.astype(bool)].sum()
    found = datasets(out / "run.h5")
    assert found["/base/normal"].sum() == pytest.approx(weight + 20.0, rel=2e-3)
    assert found["/energy/loads_work"][-1] > 0.0
    assert (found["/energy/loads_work"][found["/series/time"] <= 120.0] == 0.0).all()


def test_pushed_column_moves_with_its_spring(lab):
    out = example(lab, "pushed-column", "--set", "stop.time=160")
    found = datasets(out / "run.h5")
    displacement, time = found["/series/wall_displacement"][:, 2], found["/series/time"]
    late = time > 120.0
    # The far end has moved by 0.05 (t - 60); the spring is compressed by the push of the column.
    lag = 0.05 * (time - 60.0) - displacement
    assert np.allclose(500.0 * lag[late], -found["/series/wall_force_y"][late, 2], rtol=0.2, atol=10.0)
    assert (-found["/series/wall_force_y"][late, 2] > 1.05 * Grains(out / "run.h5").mass.sum()).all()


def test_walls_give_the_same_bits_for_any_threads(lab):
    short = ("--set", "stop.time=70")
    one, three = (example(lab, "piston", *short, "--threads", n, out=f"t{n}") for n in (1, 3))
    assert_same_bits(one / "run.h5", three / "run.h5")


def test_open_ends_and_floor(lab):
    text = STIFF + """[[grain]]
position = [0.0, 0.0]
velocity = [2.0, 0.0]
[[grain]]
position = [3.0, 0.0]
velocity = [0.0, 1.0]
[box]
half_width = 5.0
floor = -30.0
[stop]
time = 9.5
[output]
series = 0.5
"""
    found = datasets(lab.run(text) / "run.h5")
    # x = 5 after 2.5; y = t - t^2 / 2 = -30 after 8.81.
    lost_at = [found["/series/time"][np.argmax(found["/series/lost"] >= n)] for n in (1, 2)]
    assert lost_at[0] == pytest.approx(2.75, abs=0.3) and lost_at[1] == pytest.approx(9.0, abs=0.3)


MOVING = "[[grain]]\nposition = [0.0, 1.0]\n[stop]\ntime = 1\n[[wall]]\nfrom = [0, 0]\nto = [1, 0]\n"
WRONG = {
    "wall without length": (MOVING.replace("to = [1, 0]", "to = [0, 0]"), "scene.toml:7: wall[0].to = [0, 0]: is where the wall begins"),
    "unknown motion": (MOVING + "motion = 'magic'\n", "wall[0].motion = \"magic\""),
    "velocity without a value": (MOVING + "motion = 'velocity'\n", "wall[0].velocity: missing"),
    "velocity without a direction": (MOVING + "motion = 'velocity'\nvelocity = [0, 0]\n", "wall[0].velocity = [0, 0]: must have a direction"),
    "piston without mass": (MOVING + "motion = 'force'\nforce = [0, 1]\n", "wall[0].mass: missing"),
    "piston too light": (MOVING + "motion = 'force'\nforce = [0, 1]\nmass = 1e-6\n", "wall[0].mass = 1e-06: too light for the time step"),
    "spring without stiffness": (MOVING + "motion = 'spring'\nvelocity = [0, 1]\nmass = 1\n", "wall[0].stiffness: missing"),
    "mass of a fixed wall": (MOVING + "mass = 1\n", "wall[0].mass: unknown key"),
    "upright plane in a periodic box": ("[box]\nx = 'periodic'\n[[plane]]\npoint = [0, 0]\nnormal = [1, 1]\n" + MOVING,
                                        "plane[0].normal = [1, 1]: a plane must be level in a periodic box"),
    "name twice": (MOVING + "name = 'a'\n[[wall]]\nfrom = [0, 5]\nto = [1, 5]\nname = 'a'\n", "wall[1].name = \"a\": is used twice"),
    "load without force": (MOVING + "[[load]]\ngrain = 0\n", "load[0].force: missing"),
    "load of nothing": (MOVING + "[[load]]\nforce = [0, 0]\n", "load[0].force = [0, 0]: must have a direction"),
    "opening before the start": (MOVING + "opens_at = -1\n", "wall[0].opens_at = -1: must be >= 0"),
}


@pytest.mark.parametrize("name", WRONG)
def test_wrong_boundaries_are_refused(lab, name):
    text, part = WRONG[name]
    lab.scene(text)
    lab.refused("run", "scene.toml", parts=[part])


# A pair must not act on each other through both sides of a periodic box at once.
@pytest.mark.parametrize("cutoff, half_width", [(6.0, 5.0), (5.0, 5.0), (4.9, 5.0)])
def test_a_reach_beyond_half_the_box_is_refused(lab, cutoff, half_width):
    scene = (f"[contact]\nnormal = {{ law = 'continuous', cutoff = {cutoff} }}\n[base]\nkind = 'plane'\n[box]\nx = 'periodic'\n"
             f"half_width = {half_width}\n[[grain]]\nposition = [0, 1]\n[stop]\ntime = 1e-3\n")
    if cutoff < half_width:
        lab.run(scene)
    else:
        lab.refused("check", lab.scene(scene), parts=["scene.toml:7: box.half_width = 5: the largest grains act on each other up to"])
