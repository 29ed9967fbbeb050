# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Slips of a driven wall through the program, against numpy."""

from pathlib import Path

import h5py
import numpy as np
import pytest
from conftest import Laboratory, summary

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def column(tmp_path_factory):
    lab = Laboratory(tmp_path_factory.mktemp("column"))
    settings = ["output.series=0.1", "source.count=60", "stop.time=250", "output.frames=0"]
    options = [word for setting in settings for word in ("--set", setting)]
    result = lab("run", EXAMPLES / "pushed-column.toml", "--out", "out", "--quiet", *options)
    assert result.returncode == 0, result.stderr
    result = lab("analyse", "out", "--slips")
    assert result.returncode == 0, result.stderr
    return lab.path / "out", result.stdout


# The force of the spring, written from the scene: k (v (t - start) - y). Slips by a plain search for turning points.
def test_slips_of_a_pushed_column_are_those_of_numpy(column):
    folder, said = column
    with h5py.File(folder / "run.h5") as file:
        time = file["series/time"][()]
        moved = file["series/wall_displacement"][:, 2]
        solid = file["column/solid_fraction"][()]
        mass = file["grains/mass"][()].sum()
    with h5py.File(folder / "analysis.h5") as file:
        drive = {name: data[()] for name, data in file["drive"].items()}
        slips = {name: data[()] for name, data in file["slips"].items()}
    found = summary(folder)["slips"]
    going = time >= 60.0
    first = time[going][0]
    kept = going & (time >= first + 0.2 * (time[-1] - first))
    force = 500.0 * (0.05 * (time[kept] - 60.0) - moved[kept])
    np.testing.assert_allclose(drive["force"], force, atol=1e-9)
    assert (found["wall"], found["problem"]) == ("piston", "")
    assert found["mean_force"] == pytest.approx(force.mean())
    least = 1e-3 * force.mean()
    begins, ends, top, bottom, falling = [], [], 0, 0, False
    for k in range(len(force)):
        if not falling:
            top = k if force[k] >= force[top] else top
            falling, bottom = force[k] < force[top] - least, k
        elif force[k] <= force[bottom]:
            bottom = k
        elif force[k] > force[bottom] + least:
            begins, ends, top, falling = [*begins, top], [*ends, bottom], k, False
    assert found["count"] == len(begins) > 3
    np.testing.assert_array_equal(slips["begin"], time[kept][begins])
    np.testing.assert_array_equal(slips["end"], time[kept][ends])
    np.testing.assert_allclose(slips["drop"], force[begins] - force[ends], atol=1e-9)
    np.testing.assert_allclose(slips["slide"], moved[kept][ends] - moved[kept][begins], atol=1e-12)
    np.testing.assert_allclose(slips["creep"][1:], moved[kept][begins[1:]] - moved[kept][ends[:-1]], atol=1e-12)
    assert found["mean_drop"] == pytest.approx(slips["drop"].mean())
    assert "power law      undecided" in said
    # The volume of the column goes as one over its solid fraction.
    volume = 1.0 / solid[kept]
    np.testing.assert_allclose(slips["dilation"], volume[ends] / volume[begins] - 1.0, atol=1e-12)
    np.testing.assert_allclose(slips["compaction"][1:], 1.0 - volume[begins[1:]] / volume[ends[:-1]], atol=1e-12)
    assert np.isnan(slips["compaction"][0])
    assert found["dilating"] == pytest.approx(np.mean(slips["dilation"] > 0))
    assert found["compacting"] == pytest.approx(np.mean(slips["compaction"][1:] > 0))
    assert found["mean_dilation"] == pytest.approx(slips["dilation"].mean())
    # Mass 50 of the piston, speed 0.05 of the drive: the wall stands where it goes slower than a tenth of that.
    assert found["steady_speed"] == pytest.approx(np.sqrt((50.0 + mass) / 500.0))
    assert found["relative_speed"] == pytest.approx(0.05 / found["steady_speed"])
    steps = np.diff(time[kept])
    slow = np.abs(np.diff(moved[kept])) < 0.005 * steps
    assert found["stuck"] == pytest.approx(steps[slow].sum() / steps.sum())
    assert found["deviation"] == pytest.approx(np.std(force, ddof=1) / force.mean())


def test_without_a_driven_wall_there_is_nothing_to_look_for(lab):
    lab.run("[[plane]]\npoint = [0, 0]\nnormal = [0, 1]\n[[grain]]\nposition = [0, 1]\n[stop]\ntime = 1\n")
    result = lab("analyse", "out", "--slips")
    assert "none: no wall is driven" in result.stdout
    assert summary(lab.path / "out")["slips"]["count"] == 0


ONE_GRAIN = """
[method]
kind = "contact-dynamics"
tolerance = 1e-8
[[material]]
name = "disc"
[[material]]
name = "floor"
[contact]
friction = 0.0
[[pair]]
first = "disc"
second = "floor"
friction = 0.4
dynamic_friction = 0.25
weakening_velocity = 1e-6
rolling_friction = inf
[[grain]]
position = [0.5, 0.5]
[[plane]]
material = "floor"
point = [0, 0]
normal = [0, 1]
[[plane]]
name = "piston"
point = [0, 0]
normal = [1, 0]
motion = "spring"
stiffness = 10.0
velocity = [0.02, 0.0]
mass = 1.0
[box]
half_width = 10
[stop]
time = 25
[output]
frames = 0
"""


# One disc on a floor with friction that weakens in a step, pushed by a spring: with a = 0.15/k and w^2 = k/2 the force swings
# about 0.25 by k (a^2 + (v/w)^2)^(1/2), and sticks for 2 a/v in each period of 2 a/v + (2 pi - 2 atan(a w/v))/w. It stays
# above 0, so the piston never leaves the disc. Errors fall at least as fast as the step.
def test_one_grain_on_a_spring_sticks_and_slips_as_the_theory(lab):
    lab.scene(ONE_GRAIN)
    a, k, v, w = 0.015, 10.0, 0.02, np.sqrt(5.0)
    drop = 2.0 * k * np.hypot(a, v / w)
    period = 2.0 * a / v + (2.0 * np.pi - 2.0 * np.arctan(a * w / v)) / w
    errors = []
    for step in (0.004, 0.001):
        out = f"step-{step}"
        settings = ["--set", f"method.time_step={step}", "--set", f"output.series={step}"]
        assert lab("run", "scene.toml", "--out", out, "--quiet", *settings).returncode == 0
        assert lab("analyse", out, "--slips", "--quiet").returncode == 0
        with h5py.File(lab.path / out / "analysis.h5") as file:
            begin, drops = file["slips/begin"][()], file["slips/drop"][()]
        assert len(begin) >= 4
        errors.append([abs(drops.mean() / drop - 1.0), abs(np.diff(begin).mean() / period - 1.0)])
    assert max(errors[1]) < 1e-3
    assert errors[0][0] > 4.0 * errors[1][0] and errors[0][1] > 4.0 * errors[1][1]


# The same grain on springs, 1e5 times as stiff as the drive. Before it slips it creeps by their stretching at 2e-7, a
# five-hundredth of the velocity within which friction weakens, so that it slips 2e-3 of 0.15 early.
ONE_SOFT_GRAIN = (
    ONE_GRAIN.replace('"contact-dynamics"\ntolerance = 1e-8', '"soft"\ntime_step = 5e-5')
    .replace(
        "friction = 0.0\n",
        'friction = 0.0\nnormal = { law = "hooke", stiffness = 1e5, damping = 0.5 }\n'
        'tangential = { law = "linear", stiffness = 1e5 }\n'
        'rolling = { law = "spring", friction = 100, stiffness = 1e5, damping = 1 }\n',
    )
    .replace(
        "dynamic_friction = 0.25\nweakening_velocity = 1e-6\nrolling_friction = inf\n",
        'tangential = { law = "weakening", stiffness = 1e6, damping = 0.5, dynamic_friction = 0.25, '
        "weakening_velocity = 1e-4 }\n",
    )
)


def test_one_soft_grain_on_a_spring_sticks_and_slips_as_the_theory(lab):
    lab.scene(ONE_SOFT_GRAIN)
    a, k, v, w = 0.015, 10.0, 0.02, np.sqrt(5.0)
    drop = 2.0 * k * np.hypot(a, v / w)
    period = 2.0 * a / v + (2.0 * np.pi - 2.0 * np.arctan(a * w / v)) / w
    result = lab("run", "scene.toml", "--out", "out", "--quiet", "--set", "output.series=0.001")
    assert result.returncode == 0, result.stderr
    assert lab("analyse", "out", "--slips", "--quiet").returncode == 0
    with h5py.File(lab.path / "out" / "analysis.h5") as file:
        begin, drops = file["slips/begin"][()], file["slips/drop"][()]
    assert len(begin) >= 4
    assert drops.mean() == pytest.approx(drop, rel=3e-3)
    assert np.diff(begin).mean() == pytest.approx(period, rel=3e-3)
