# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""What makes the results of a run doubtful is said once, and kept in summary.json. Units: diameter, mass, gravity."""

from conftest import summary
from wall_scenes import grain, wall

FLOOR = "[base]\nkind = 'plane'\n"
HOOKE = "[contact]\nnormal = { law = 'hooke', stiffness = %s, damping = 0.5 }\n"


def said(lab, scene, *options):
    """The warnings that a run prints, which are those of its summary."""
    result = lab("run", lab.scene(scene), "--out", "out", *options)
    assert result.returncode == 0, result.stderr
    warnings = summary(lab.path / "out")["warnings"]
    lines = result.stdout.splitlines() + result.stderr.splitlines()
    for warning in warnings:
        assert sum(warning in line for line in lines) == 1, warning
    return warnings


def test_a_sound_run_has_none(lab):
    assert said(lab, HOOKE % "1e4" + FLOOR + grain(0, 0.5) + "[stop]\ntime = 3\n") == []


# A spring of 10 m g/d holds a grain at an overlap of a tenth.
def test_deep_overlaps(lab):
    (warning,) = said(lab, HOOKE % "10" + FLOOR + grain(0, 0.5) + "[stop]\ntime = 3\n")
    assert "overlaps reach 0.1" in warning and "0.05" in warning


def test_grains_behind_a_wall_are_named(lab):
    shot = "gravity = 0.0\n[method]\ntime_step = 0.01\n" + HOOKE % "1.0" + (
        "[[plane]]\nname = 'door'\npoint = [5, 0]\nnormal = [-1, 0]\n") + grain(0, 0, 20.0) + "[stop]\ntime = 1\n"
    warnings = said(lab, shot)
    assert any('1 grain is behind wall "door", as grain 0' in warning for warning in warnings)


def test_a_run_that_loses_everything(lab):
    (warning,) = said(lab, "[box]\nfloor = -1\n" + grain(0, 0) + grain(3, 0) + "[stop]\ntime = 5\n")
    assert "all 2 grains have left" in warning


# A wall that throws a soft grain at a step near the limit of stability.
def test_an_open_energy_budget(lab):
    hammer = wall("hammer", (-2, 0), (2, 0), "motion = 'velocity'", "velocity = [0, 0.0001]")
    scene = "[method]\ntime_step = 0.0099\n" + HOOKE % "1e4" + hammer + grain(0, 0.5, 0.0, -1e-3) + "[stop]\ntime = 0.1\n"
    closed = said(lab, scene + "[output]\nenergy = true\n")
    assert all("budget" not in warning for warning in closed)
