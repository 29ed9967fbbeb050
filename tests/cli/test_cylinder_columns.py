# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Columns of spheres in an upright cylinder through the program, against numpy and against what statics demands."""

import json
import shutil
from pathlib import Path

import h5py
import numpy as np
import pytest
from conftest import Laboratory, assert_same_bits, number_in, summary

EXAMPLES = Path(__file__).parents[2] / "examples"
RADIUS = 2.0
FRICTION = 0.4
AXIS = (0.5, -0.25)

PIPE = """
dimension = 3
seed = 4
[grains]
polydispersity = 0.15
[[material]]
name = "grain"
[[material]]
name = "wall"
{method}
[contact]
friction = 0.4
{laws}
[[pair]]
first = "grain"
second = "wall"
friction = {wall_friction}
[[plane]]
name = "floor"
point = [0, 0, 0]
normal = [0, 0, 1]
{floor}
[[wall]]
name = "pipe"
material = "wall"
shape = "cylinder"
from = [0.5, -0.25, -3]
to = [0.5, -0.25, 30]
radius = 2.0
{cylinder}
[source]
kind = "pour"
count = {count}
rate = 12
height = 2
height_above = "apex"
x = 0.5
y = -0.25
radius = 1.2
[box]
half_width = 10
[stop]
{stop}
[output]
frames = 0
slices = 6
{output}
"""


SOFT = """normal = { law = "hooke", stiffness = 2e3, damping = 0.5 }
tangential = { law = "linear", stiffness = 1e3, damping = 0.2 }"""
RIGID = dict(method='[method]\nkind = "contact-dynamics"\ntime_step = 0.04', laws="restitution = 0")
LET_DOWN = 'motion = "velocity"\nvelocity = [0, 0, -0.05]\nstart = 20\nstop = 30'


def pipe(stop, method="", laws=SOFT, wall_friction=FRICTION, count=100, floor="", cylinder="", output=""):
    return PIPE.format(stop=stop, method=method, laws=laws, wall_friction=wall_friction, count=count, floor=floor,
                       cylinder=cylinder, output=output)


def tables(path, group):
    with h5py.File(path) as file:
        return {name: data[()] for name, data in file[group].items()}, dict(file[group].attrs)


def unit_of(path, dataset):
    with h5py.File(path) as file:
        unit = file[dataset].attrs["unit"]
    return unit.decode() if isinstance(unit, bytes) else unit


@pytest.fixture(scope="module")
def at_rest(tmp_path_factory):
    """The folder of a column at rest, and what the program said. The floor goes down by 0.5 before, which mobilises the
    friction of the cylinder."""
    lab = Laboratory(tmp_path_factory.mktemp("pipe"))
    result = lab("run", lab.scene(pipe("time = 100", floor=LET_DOWN)), "--out", "out")
    assert result.returncode == 0, result.stderr
    return lab.path / "out", result.stdout


def floor_of(out):
    """z of the floor where it is at the end. Its displacement is along its motion, downwards."""
    return -tables(out / "run.h5", "series")[0]["wall_displacement"][-1, 0]


def volume_below(level, z, radius):
    """Of spheres below a level."""
    h = np.clip(level - z + radius, 0.0, 2.0 * radius)
    return np.sum(np.pi * h**2 * (3.0 * radius - h) / 3.0)


# Levels by the volume of spheres below them, loads by the contacts across them, written from the definitions.
def test_the_slices_are_those_of_numpy(at_rest):
    out, _ = at_rest
    grains, _ = tables(out / "run.h5", "grains")
    contacts, _ = tables(out / "run.h5", "contacts")
    column, _ = tables(out / "run.h5", "column")
    series, _ = tables(out / "run.h5", "series")
    assert column["slice_top"].shape == (len(series["time"]), 6)
    z, radius, mass = grains["position"][:, 2] - floor_of(out), grains["radius"], grains["mass"]
    tops = column["slice_top"][-1]
    volume = 4 / 3 * np.pi * np.sum(radius**3)
    for k in range(5):
        assert volume_below(tops[k], z, radius) == pytest.approx((k + 1) / 6 * volume, rel=1e-9)
    assert tops[5] == pytest.approx(np.max(z + radius), rel=1e-12)
    upwards = contacts["normal"][:, 2] * contacts["normal_force"] + contacts["tangential_force"][:, 2]
    first, second = contacts["grains"].T
    side = second == -2
    below = np.array([z[i] if i >= 0 else -1.0 for i in second])
    for k, (low, high) in enumerate(zip(np.append(0.0, tops[:-1]), tops, strict=True)):
        inside = side & (z[first] >= low) & (z[first] < high)
        area = 2 * np.pi * RADIUS * (high - low)
        assert column["slice_pressure"][-1][k] == pytest.approx(contacts["normal_force"][inside].sum() / area)
        assert column["slice_shear"][-1][k] == pytest.approx(upwards[inside].sum() / area)
        assert column["slice_mass"][-1][k] == pytest.approx(mass[(z >= low) & (z < high)].sum())
        load = upwards[~side & (z[first] >= low) & (below < low)].sum()
        load -= upwards[~side & (z[first] < low) & (below >= low)].sum()
        assert column["slice_load"][-1][k] == pytest.approx(load, rel=1e-9)
    assert column["centre"][-1] == pytest.approx(np.sum(mass * z) / mass.sum(), rel=1e-12)


# At rest floor and cylinder bear the weight together, and so do the levels of each slice.
def test_floor_and_cylinder_bear_the_weight(at_rest):
    out, _ = at_rest
    found = summary(out)
    column, walls = found["column"], found["walls"]
    weight = column["mass"]
    assert weight == pytest.approx(tables(out / "run.h5", "grains")[0]["mass"].sum(), rel=1e-12)
    assert abs(column["balance"]) < 1e-6
    assert column["apparent_mass"] == pytest.approx(-walls["force_z"][0], rel=1e-12)
    assert column["wall_load"] == pytest.approx(-walls["force_z"][1], rel=1e-12)
    assert column["apparent_mass"] + column["wall_load"] == pytest.approx(weight, rel=1e-6)
    assert 0.4 < column["load_ratio"] < 0.9
    layers, _ = tables(out / "analysis.h5", "column")
    area = 2 * np.pi * RADIUS * (layers["top"] - layers["bottom"])
    above = np.append(layers["load"][1:], 0.0)
    assert np.abs(layers["load"] + layers["shear"] * area - above - layers["mass"]).max() < 1e-6 * weight
    assert layers["load"][0] == pytest.approx(column["apparent_mass"], rel=1e-6)
    assert np.sum(layers["shear"] * area) == pytest.approx(column["wall_load"], rel=1e-6)
    assert (layers["pressure"] > 0.0).all()
    assert abs(np.sum(layers["shear"] * area)) <= FRICTION * np.sum(layers["pressure"] * area)


# Attributes and measures by their definitions; Janssen's length in a cylinder is D/(4 K friction).
def test_what_is_derived_follows_the_definitions(at_rest):
    out, said = at_rest
    column = summary(out)["column"]
    layers, attributes = tables(out / "analysis.h5", "column")
    assert column["radius"] == attributes["radius"] == RADIUS and "width" not in column
    assert (attributes["axis_x"], attributes["axis_y"]) == AXIS
    assert attributes["floor"] == pytest.approx(floor_of(out), rel=1e-12) == pytest.approx(-0.5, abs=2e-3)
    assert attributes["floor_wall"] == 0
    assert unit_of(out / "analysis.h5", "column/pressure") == "M/(L T^2)"
    area = 2 * np.pi * RADIUS * (layers["top"] - layers["bottom"])
    friction = np.sum(layers["shear"] * area) / np.sum(layers["pressure"] * area)
    assert column["friction"] == pytest.approx(friction, rel=1e-6)
    section = np.pi * RADIUS**2
    stress = 0.5 * (layers["load"] + np.append(layers["load"][1:], 0.0)) / section
    np.testing.assert_allclose(layers["stress"], stress, rtol=1e-9)
    inner = slice(1, -1)
    ratio = np.sum(layers["pressure"][inner] * stress[inner]) / np.sum(stress[inner] ** 2)
    assert column["stress_ratio"]["mean"] == pytest.approx(ratio, rel=1e-9)
    assert 0.2 < ratio < 1.5
    length = 2 * RADIUS / (4 * ratio * friction)
    assert column["screening_length"] == pytest.approx(length, rel=1e-6)
    assert column["k_mu"] == pytest.approx(ratio * friction, rel=1e-6)
    x = column["height"] / length
    assert column["janssen_ratio"] == pytest.approx((1 - np.exp(-x)) / x, rel=1e-6)
    # Slices hold the same volume of spheres; all of it is known, but for the mean over the window.
    volume = layers["solid_fraction"] * section * (layers["top"] - layers["bottom"])
    np.testing.assert_allclose(volume, volume[0], rtol=1e-9)
    radius = tables(out / "run.h5", "grains")[0]["radius"]
    assert volume.sum() == pytest.approx(4 / 3 * np.pi * np.sum(radius**3), rel=1e-6)
    assert 0.45 < column["solid_fraction"] < 0.65
    assert number_in(said, "column           height") == pytest.approx(column["height"], abs=1e-3)
    assert number_in(said, "radius") == RADIUS
    assert number_in(said, "floor carries") == pytest.approx(column["load_ratio"], abs=1e-3)


# `repose theory janssen` of the measured K and friction says of the same column what `janssen_ratio` says.
def test_the_law_is_that_of_the_theory(at_rest, lab):
    out, _ = at_rest
    column = summary(out)["column"]
    solid = column["mass"] / (np.pi * RADIUS**2 * column["height"])
    settings = dict(dimension=3, width=2 * RADIUS, height=column["height"], stress_ratio=column["stress_ratio"]["mean"],
                    friction=column["friction"], density=1.0, solid_fraction=solid, gravity=1.0, points=2)
    words = [f"{name}={value!r}" for name, value in settings.items()]
    result = lab("theory", "janssen", *(part for word in words for part in ("--set", word)))
    assert result.returncode == 0, result.stderr
    bottom = [float(x) for x in result.stdout.split("\n")[-2].replace(",", " ").split()]
    assert bottom[2] / column["mass"] == pytest.approx(column["janssen_ratio"], rel=1e-9)


def test_the_analysis_of_the_files_is_that_of_the_run(at_rest, lab):
    out, _ = at_rest
    shutil.copytree(out, lab.path / "again")
    result = lab("analyse", "again", "--quiet")
    assert result.returncode == 0, result.stderr
    assert_same_bits(out / "analysis.h5", lab.path / "again" / "analysis.h5")
    assert summary(lab.path / "again")["column"] == summary(out)["column"]


# A checkpoint keeps the rows and slices so far.
def test_an_interrupted_run_has_the_same_column(at_rest, lab):
    lab.scene(pipe("time = 100", floor=LET_DOWN))
    stopped = lab.shell("timeout --foreground -s INT 1 $REPOSE run scene.toml --out cut --quiet; echo $?")
    if stopped.stdout.strip() != "0":
        resumed = lab("resume", "cut", "--quiet")
        assert resumed.returncode == 0, resumed.stderr
    assert_same_bits(at_rest[0] / "analysis.h5", lab.path / "cut" / "analysis.h5")


# For soft spheres, and for rigid ones to the tolerance of the solver.
@pytest.mark.parametrize("more", [dict(count=60), dict(count=40, **RIGID)], ids=["soft", "rigid"])
def test_a_smooth_cylinder_carries_nothing(lab, more):
    found = summary(lab.run(pipe("at_rest = 1e-6\ntime = 60", wall_friction=0.0, **more)))["column"]
    assert abs(found["load_ratio"] - 1.0) < 1e-6
    assert abs(found["wall_load"]) < 1e-6 * found["mass"]
    assert abs(found["friction"]) < 1e-9
    assert found["stress_ratio"]["mean"] > 0.3  # the spheres press on it all the same


# Pushed up, the cylinder holds the column down, within the limit of friction; let down, it bears a part of it. A
# cylinder that rises around a column on a floor at rest does what a floor does that is let down. Nothing is fitted: the
# load follows from the measured K and the mobilised friction by Janssen's law.
@pytest.mark.parametrize(("moves", "speed"), [("floor", 0.05), ("floor", -0.05), ("cylinder", 0.05)])
def test_a_moving_column_follows_janssen(lab, moves, speed):
    motion = f'motion = "velocity"\nvelocity = [0, 0, {speed}]\nstart = 45'
    out = lab.run(pipe("time = 75", count=200, output="window = 20", **{moves: motion}))
    found = summary(out)["column"]
    pushed_up = moves == "floor" and speed > 0.0
    low, high = (2.0, 15.0) if pushed_up else (0.1, 0.6)
    assert low < found["load_ratio"] < high
    assert 0.15 < (-1.0 if pushed_up else 1.0) * found["friction"] <= FRICTION
    # K and friction vary along the column: five seeds deviate by up to 0.30 pushed up, six by up to 0.18 let down.
    assert found["load_ratio"] == pytest.approx(found["janssen_ratio"], rel=0.35 if pushed_up else 0.25)
    assert abs(found["balance"]) < 0.01  # not at rest: grains accelerate
    with h5py.File(out / "analysis.h5") as file:
        assert ("column_motion" in file) == (moves == "floor")
    if moves == "cylinder":
        return
    motion, _ = tables(out / "analysis.h5", "column_motion")
    np.testing.assert_allclose(motion["floor"], speed * (motion["time"] - 45), atol=2e-3)
    np.testing.assert_allclose(motion["top"], motion["floor"] - motion["shortening"], atol=1e-12)
    assert pushed_up or 0.0 < -found["top_follows"] < 1.0
    # Heights count from the floor where it is, not from where it was.
    floor = tables(out / "analysis.h5", "column")[1]["floor"]
    grains, _ = tables(out / "run.h5", "grains")
    top = tables(out / "run.h5", "column")[0]["slice_top"][-1, -1]
    assert floor == pytest.approx(30 * speed, abs=2e-3)
    assert floor + top == pytest.approx(np.max(grains["position"][:, 2] + grains["radius"]), rel=1e-9)


# A hopper has a wall that slopes, a drum one that lies.
@pytest.mark.parametrize("name", ["hopper-3d", "drum-3d", "cone"])
def test_other_scenes_have_no_column(lab, name):
    result = lab("run", EXAMPLES / f"{name}.toml", "--out", "out", "--quiet", "--set", "stop.time=0.5")
    assert result.returncode == 0, result.stderr
    assert "column" not in summary(lab.path / "out")
    with h5py.File(lab.path / "out" / "run.h5") as file:
        assert "column" not in file


@pytest.mark.parametrize("kind", ["soft", "contact-dynamics"])
def test_the_example_is_sound_by_both_methods(lab, kind):
    result = lab("check", EXAMPLES / "column-3d.toml", "--set", f"method.kind={kind}")
    assert result.returncode == 0, result.stderr
    assert "warning" not in result.stdout


SWEEP = """
scene = "scene.toml"
seeds = 2
[vary]
source.count = [30, 60, 90]
[[fit]]
name = "down"
points = ["count=*"]
[[claim]]
text = "K of the spheres"
fit = "down"
measure = "stress_ratio"
above = 0.1
"""


# K by the fitted length takes the radius for what the width is between two walls.
def test_a_sweep_over_heights_has_columns_and_a_fit(lab):
    motion = 'motion = "velocity"\nvelocity = [0, 0, -0.05]\nstart = 10'
    lab.scene(pipe("time = 25", floor=motion, output="window = 10"))
    (lab.path / "sweep.toml").write_text(SWEEP)
    result = lab("sweep", "sweep.toml", "--out", "out")
    assert result.returncode == 0, result.stderr
    out = lab.path / "out"
    with h5py.File(out / "sweep.h5") as file:
        assert file.attrs["dimension"] == 3
        pressure = file["columns/0002/pressure"][()]
    members = [tables(path, "column")[0]["pressure"]
               for path in sorted((out / "members" / "count=90").glob("seed-*/analysis.h5"))]
    np.testing.assert_allclose(pressure, np.mean(members, axis=0), rtol=1e-12)
    assert unit_of(out / "sweep.h5", "columns/0002/pressure") == "M/(L T^2)"
    fit = json.loads((out / "heights.json").read_text())[0]
    assert fit["width"] == RADIUS
    claim = json.loads((out / "claims.json").read_text())["claims"][0]
    assert claim["value"] == pytest.approx(RADIUS / (2 * fit["friction"] * fit["lambda"]["mean"]), rel=1e-9)
    result = lab("plot", "out", "--only", "columns", "--format", "png")
    assert result.returncode == 0, result.stderr
    assert list((out / "pictures").glob("columns*.png"))


def test_the_pictures_are_drawn(at_rest, lab):
    out, _ = at_rest
    shutil.copytree(out, lab.path / "out")
    result = lab("plot", "out", "--only", "column,column_motion", "--format", "png")
    assert result.returncode == 0, result.stderr
    for name in ("column", "column_motion"):
        assert (lab.path / "out" / "pictures" / f"{name}.png").stat().st_size > 10000
