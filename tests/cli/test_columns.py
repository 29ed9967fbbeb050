# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Columns between two upright walls through the program, against numpy and against what statics demands."""

import json
import re
from pathlib import Path

import h5py
import numpy as np
import pytest
import xxhash
from conftest import Laboratory, summary

EXAMPLES = Path(__file__).parents[2] / "examples"

PIPE = """
[grains]
polydispersity = 0.15
[[material]]
name = "grain"
[[material]]
name = "wall"
[contact]
friction = 0.4
{laws}
[[pair]]
first = "grain"
second = "wall"
friction = {wall_friction}
[[plane]]
name = "left"
material = "wall"
point = [-2.5, 0]
normal = [1, 0]
[[plane]]
name = "right"
material = "wall"
point = [2.5, 0]
normal = [-1, 0]
[[plane]]
name = "floor"
point = [0, 0]
normal = [0, 1]
{motion}
[source]
kind = "pour"
count = 50
rate = 4
height = 3
height_above = "apex"
half_width = 1.9
[box]
half_width = 10
[stop]
at_rest = 1e-8
time = 400
[output]
frames = 0
{output}
"""
SOFT = 'normal = { law = "hooke", stiffness = 1e4, damping = 0.5 }\ntangential = { law = "linear", stiffness = 5e3, damping = 0.2 }'


def pipe(wall_friction=0.4, laws=SOFT, motion="", output=""):
    return PIPE.format(wall_friction=wall_friction, laws=laws, motion=motion, output=output)


@pytest.fixture(scope="module")
def at_rest(tmp_path_factory):
    lab = Laboratory(tmp_path_factory.mktemp("pipe"))
    lab.scene(pipe(output="slices = 7\nenergy = true"))
    result = lab("run", "scene.toml", "--out", "out", "--quiet")
    assert result.returncode == 0, result.stderr
    return lab.path / "out"


def area_below(level, y, radius):
    h = np.clip(level - y, -radius, radius)
    return np.sum(radius**2 * (np.pi - np.arccos(h / radius)) + h * np.sqrt(radius**2 - h**2))


# Levels by the area of discs below them, loads by the contacts across them, written from the definitions.
def test_the_slices_are_those_of_numpy(at_rest):
    with h5py.File(at_rest / "run.h5") as file:
        grains = {name: data[()] for name, data in file["grains"].items()}
        contacts = {name: data[()] for name, data in file["contacts"].items()}
        column = {name: data[()] for name, data in file["column"].items()}
        assert file["column/slice_top"].shape == (len(file["series/time"]), 7)
    y, radius = grains["position"][:, 1], grains["radius"]
    tops = column["slice_top"][-1]
    for k in range(6):
        assert area_below(tops[k], y, radius) == pytest.approx((k + 1) / 7 * np.pi * np.sum(radius**2), rel=1e-9)
    assert tops[6] == pytest.approx(np.max(y + radius), rel=1e-12)
    normal = contacts["normal"]
    tangent = np.column_stack([-normal[:, 1], normal[:, 0]])
    force = normal * contacts["normal_force"][:, None] + tangent * contacts["tangential_force"][:, None]
    first, second = contacts["grains"].T
    side = (second == -1) | (second == -2)
    bottoms = np.concatenate([[0.0], tops[:-1]])
    for k, (low, high) in enumerate(zip(bottoms, tops, strict=True)):
        inside = side & (y[first] >= low) & (y[first] < high)
        length = 2 * (high - low)
        assert column["slice_pressure"][-1][k] == pytest.approx(contacts["normal_force"][inside].sum() / length)
        assert column["slice_shear"][-1][k] == pytest.approx(force[inside, 1].sum() / length)
        assert column["slice_mass"][-1][k] == pytest.approx(grains["mass"][(y >= low) & (y < high)].sum())
        height = [y[i] if i >= 0 else -1.0 for i in second]
        across = ~side & (y[first] >= low) & (np.array(height) < low)
        back = ~side & (y[first] < low) & (np.array(height) >= low)
        load = force[across, 1].sum() - force[back, 1].sum()
        assert column["slice_load"][-1][k] == pytest.approx(load, rel=1e-9)
    mass = grains["mass"]
    assert column["centre"][-1] == pytest.approx(np.sum(mass * y) / mass.sum(), rel=1e-12)


# At rest the floor and the walls bear the weight, and the energy put in is stored or dissipated.
def test_floor_and_walls_bear_the_weight(at_rest):
    found = summary(at_rest)["column"]
    assert abs(found["balance"]) < 1e-6
    assert found["load_ratio"] != pytest.approx(1.0, abs=0.01)  # friction bears or holds down a part
    assert abs(found["friction"]) < 0.4
    assert found["wall_load"] + found["apparent_mass"] == pytest.approx(found["mass"], rel=1e-6)
    with h5py.File(at_rest / "run.h5") as file:
        put_in = file["energy/sources"][-1]
        assert abs(file["energy/error"][-1]) < 3e-3 * put_in  # of first order in the step: 1e-3 at this one


# Smooth walls carry nothing, for soft grains and for rigid ones.
@pytest.mark.parametrize("method", ["soft", "contact-dynamics"])
def test_smooth_walls_carry_nothing(lab, method):
    laws = SOFT if method == "soft" else "restitution = 0"
    extra = "" if method == "soft" else "\n[method]\ntolerance = 1e-8\nmost_sweeps = 20000\n"
    lab.scene(f'method.kind = "{method}"\n' + pipe(0.0, laws) if method == "soft" else
              f'{pipe(0.0, laws)}{extra}kind = "{method}"\n')
    result = lab("run", "scene.toml", "--out", "out", "--quiet")
    assert result.returncode == 0, result.stderr
    found = summary(lab.path / "out")["column"]
    assert abs(found["load_ratio"] - 1.0) < 1e-6
    assert abs(found["wall_load"]) < 1e-6 * found["mass"]
    assert found["stress_ratio"]["mean"] > 0.3  # they press on the walls all the same


# Pushed up, the walls hold the column down, within the limit of friction; let down, they bear a part of it. Nothing is fitted:
# the load follows from the measured K and the mobilised friction by Janssen's law.
@pytest.mark.parametrize(("speed", "low", "high"), [(0.05, 1.2, 6.0), (-0.05, 0.3, 0.85)])
def test_a_moving_column_follows_janssen(lab, speed, low, high):
    motion = f'motion = "velocity"\nvelocity = [0, {speed}]\nstart = 40'
    text = pipe(motion=motion, output="window = 60").replace("at_rest = 1e-8\ntime = 400", "time = 120")
    lab.scene(text)
    result = lab("run", "scene.toml", "--out", "out", "--quiet")
    assert result.returncode == 0, result.stderr
    found = summary(lab.path / "out")["column"]
    assert low < found["load_ratio"] < high
    assert 0.15 < -np.sign(speed) * found["friction"] < 0.4
    # K and friction vary along so short a column: eight seeds deviate by up to 0.25 pushed up and 0.11 let down.
    assert found["load_ratio"] == pytest.approx(found["janssen_ratio"], rel=0.3 if speed > 0.0 else 0.15)
    assert abs(found["balance"]) < 0.01  # not at rest: grains accelerate
    with h5py.File(lab.path / "out" / "analysis.h5") as file:
        motion = {name: data[()] for name, data in file["column_motion"].items()}
    np.testing.assert_allclose(motion["floor"], speed * (motion["time"] - 40), atol=2e-3)
    np.testing.assert_allclose(motion["top"], motion["floor"] - motion["shortening"], atol=1e-12)
    assert 0.0 < abs(found["top_follows"]) < 1.0


# Rigid columns: statics leaves the load of the floor open, at rest and while the floor moves slowly.
@pytest.mark.parametrize("speed", [0.0, 0.002])
def test_the_load_of_a_rigid_column_has_a_range(lab, speed):
    motion = f'motion = "velocity"\nvelocity = [0, {speed}]\nstart = 60' if speed else ""
    text = pipe(laws="restitution = 0", motion=motion).replace("at_rest = 1e-8\ntime = 400", "time = 110")
    lab.scene(text + '[method]\nkind = "contact-dynamics"\n')
    assert lab("run", "scene.toml", "--out", "out", "--quiet").returncode == 0
    assert lab("analyse", "out", "--force-range", "--quiet").returncode == 0
    found = summary(lab.path / "out")
    band = found["force_range"]["load_ratio"]
    assert found["force_range"]["problem"] == ""
    assert band["min"] < min(band["cold"], band["warm"]) <= max(band["cold"], band["warm"]) < band["max"]
    assert band["max"] > 1.2 * band["min"]


@pytest.mark.parametrize("kind", ["soft", "contact-dynamics"])
@pytest.mark.parametrize(
    "name", ["column-rest", "column-up", "column-down", "column-stick-slip", "silo-fill", "silo-discharge"]
)
def test_the_examples_are_sound_by_both_methods(lab, name, kind):
    result = lab("check", EXAMPLES / f"{name}.toml", "--set", f"method.kind={kind}")
    assert result.returncode == 0, result.stderr
    assert "warning" not in result.stdout


def test_the_planes_of_a_scene_are_set_by_name(lab):
    scene = EXAMPLES / "column-up.toml"
    short = ["--set", "stop.time=1", "--set", "source.count=5", "--set", "output.window=1"]
    result = lab("run", scene, "--out", "out", "--quiet", *short, "--set", "plane.piston.velocity=[0.0, 0.25]")
    assert result.returncode == 0, result.stderr
    assert "velocity = [0.0, 0.25]" in (lab.path / "out" / "scene.toml").read_text()
    result = lab("check", scene, "--set", "plane.pistn.velocity=[0.0, 0.25]")
    assert (result.returncode, result.stderr.count("\n")) == (2, 1)
    assert "plane.NAME.KEY" in result.stderr
    result = lab("check", scene, "--set", "plane.piston.velocity=3")
    assert result.returncode == 2
    assert "--set plane.piston.velocity=3" in result.stderr


SWEEP = """
scene = "scene.toml"
seeds = 4
[vary]
source.count = [20, 30, 40, 50]
[[fit]]
name = "down"
points = ["count=*"]
[[claim]]
text = "a length of 4 to 100"
fit = "down"
measure = "lambda"
above = 4
below = 100
[[claim]]
text = "a length below 3"
fit = "down"
measure = "lambda"
below = 3
"""


# Fit, table and verdicts of a sweep over heights; the fitted curve by numpy from the lengths that it states.
def test_a_sweep_over_heights_is_fitted(lab):
    motion = 'motion = "velocity"\nvelocity = [0, -0.05]\nstart = 40'
    lab.scene(pipe(motion=motion, output="window = 60").replace("at_rest = 1e-8\ntime = 400", "time = 120"))
    (lab.path / "sweep.toml").write_text(SWEEP)
    result = lab("sweep", "sweep.toml", "--out", "out")
    assert result.returncode == 0, result.stderr
    assert "fit down: lambda" in result.stdout
    fit = json.loads((lab.path / "out" / "heights.json").read_text())[0]
    rows = np.genfromtxt(lab.path / "out" / "heights.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
    one, two = fit["lambda"]["mean"], (fit["lambda_1"]["mean"], fit["lambda_2"]["mean"])
    unit = fit["mass_per_height"]
    np.testing.assert_allclose(rows["fitted_one"], unit * one * -np.expm1(-rows["height"] / one), rtol=1e-9)
    np.testing.assert_allclose(rows["fitted_two"], unit * two[0] * -np.expm1(-rows["height"] / two[1]), rtol=1e-9)
    claims = json.loads((lab.path / "out" / "claims.json").read_text())["claims"]
    assert [claim["verdict"] for claim in claims] == ["agrees", "disagrees"]
    with h5py.File(lab.path / "out" / "sweep.h5") as file:
        members = [h5py.File(path)["column/pressure"][()] for path in
                   sorted((lab.path / "out" / "members" / "count=50").glob("seed-*/analysis.h5"))]
        np.testing.assert_allclose(file["columns/0003/pressure"], np.mean(members, axis=0), rtol=1e-12)
        error = np.std(members, axis=0, ddof=1) / 2
        np.testing.assert_allclose(file["columns/0003/pressure_error"], error, rtol=1e-9)


# Verdicts follow the stored members: planted masses of columns with a length of two diameters turn both round.
def test_planted_masses_flip_the_verdicts(lab):
    motion = 'motion = "velocity"\nvelocity = [0, -0.05]\nstart = 40'
    lab.scene(pipe(motion=motion, output="window = 60").replace("at_rest = 1e-8\ntime = 400", "time = 120"))
    (lab.path / "sweep.toml").write_text(SWEEP.replace("seeds = 4", "seeds = 2"))
    assert lab("sweep", "sweep.toml", "--out", "out", "--quiet").returncode == 0

    def verdicts():
        claims = json.loads((lab.path / "out" / "claims.json").read_text())["claims"]
        return [claim["verdict"] for claim in claims]

    assert verdicts() == ["agrees", "disagrees"]
    for path in (lab.path / "out" / "members").glob("*/seed-*/summary.json"):
        text = path.read_text()
        column = json.loads(text)["column"]
        planted = 2.0 * column["mass"] / column["height"] * -np.expm1(-column["height"] / 2.0)
        planted *= 1.0 if path.parent.name == "seed-1" else 1.01
        text = re.sub(r'"apparent_mass": [^,]*', f'"apparent_mass": {planted}', text)
        body = text[: text.rindex(',\n  "checksum"')]
        path.write_text(f'{body},\n  "checksum": "{xxhash.xxh3_128_hexdigest(body.encode())}"\n}}\n')
    result = lab("sweep", "out/sweep.toml", "--quiet")
    assert result.returncode == 0, result.stderr
    assert verdicts() == ["disagrees", "agrees"]


def test_a_wrong_fit_is_refused(lab):
    lab.scene(pipe())
    text = SWEEP.replace('points = ["count=*"]', 'points = ["counts=*"]').replace('"lambda"', '"lamda"')
    (lab.path / "sweep.toml").write_text(text)
    result = lab("sweep", "sweep.toml", "--check")
    assert result.returncode == 2
    assert 'no point "counts=*"' in result.stderr
    assert "a fit has lambda, lambda_1" in result.stderr
