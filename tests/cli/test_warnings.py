# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""What makes the results of a run doubtful is reported once, and kept in summary.json. Units: diameter, mass, gravity."""

import h5py
from conftest import datasets, summary
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


# A load of 0.6 presses a grain with a spring of 1 by 0.6 into a wall, so that its centre is 0.1 behind it.
def test_grains_behind_a_wall_are_named(lab):
    pressed = "gravity = 0.0\n[method]\ntime_step = 0.01\nviscous_damping = 1.0\n" + HOOKE % "1.0" + (
        "[[plane]]\nname = 'door'\npoint = [0, 0]\nnormal = [-1, 0]\n") + grain(-0.5, 0) + (
        "[[load]]\ngrain = 0\nforce = [0.6, 0.0]\n[stop]\ntime = 30\n")
    warnings = said(lab, pressed)
    assert any('1 grain is behind wall "door", as grain 0' in warning for warning in warnings)
    assert any("overlaps reach 0.6" in warning for warning in warnings)


# Two grains as fast as the spring of a shelf cannot hold: m v^2 / 2 = 8 against k / 8 at most. One passes by its end.
def test_grains_that_go_through_a_wall_of_finite_length(lab):
    scene = "gravity = 0.0\n[method]\ntime_step = 0.002\n" + HOOKE % "10.0" + wall("shelf", (-2, 0), (2, 0)) + (
        grain(0, 3, 0, -4) + grain(1.2, 3.5, 0, -4) + grain(4, 3, 0, -4)) + "[stop]\ntime = 2\n"
    warnings = said(lab, scene)
    assert sum('went through wall "shelf" 2 times: first grain 0, by time 1.0' in warning for warning in warnings) == 1
    with h5py.File(lab.path / "out/run.h5") as file:
        assert [file[f"walls/{name}"][0] for name in ("crossed", "first_crossed")] == [2, 0]
    # They do so in any division of the run.
    lab.run(scene, "--set", "output.series=0.05", "--threads", "2", out="pieces")
    assert summary(lab.path / "pieces")["warnings"][-1] == warnings[-1]


# A rigid grain keeps to its side of the gate, whatever its speed.
def test_a_rigid_grain_does_not_go_through_a_wall(lab):
    scene = "gravity = 0.0\n[method]\nkind = 'contact-dynamics'\ntime_step = 0.05\n" + wall("gate", (0, -2), (0, 2)) + (
        grain(-2, 0, 9.0, 0)) + "[stop]\ntime = 2\n"
    assert said(lab, scene) == []
    assert datasets(lab.path / "out/run.h5")["/grains/position"][0, 0] < 0.0


def test_a_run_that_loses_everything(lab):
    (warning,) = said(lab, "[box]\nfloor = -1\n" + grain(0, 0) + grain(3, 0) + "[stop]\ntime = 5\n")
    assert "all 2 grains have left" in warning


# A fall from 5 hits the floor at time 3. At w dt = 0.99, near the longest step that is not refused, the budget misses a
# fifth of the energy within the impact; at a hundredth of that step it closes.
def test_an_open_energy_budget(lab):
    scene = "[method]\ntime_step = %s\n" + (HOOKE % "1e4").replace("0.5", "0.0") + FLOOR + (
        grain(0, 5.0) + "[stop]\ntime = 3.0096\n[output]\nenergy = true\n")
    (warning,) = [warning for warning in said(lab, scene % "0.0099") if "budget" in warning]
    assert "does not close: it misses" in warning and "of 5 supplied" in warning
    assert not any("budget" in warning for warning in said(lab, scene % "1e-4", "--overwrite"))


# Through the seam of two pieces that meet, and beside it: each passage counts once, for the piece that the path cuts.
def test_grains_that_go_through_a_seam_of_two_pieces(lab):
    pieces = wall("left", (-2, 0), (0, 0)) + wall("right", (0, 0), (2, 0))
    scene = "gravity = 0.0\n[method]\ntime_step = 0.002\n" + HOOKE % "10.0" + pieces + (
        grain(0.001, 3, 0, -6) + grain(-1.2, 3.5, 0, -6) + grain(3.5, 3, 0, -6)) + "[stop]\ntime = 2\n"
    crossed = [warning for warning in said(lab, scene) if "went through" in warning]
    assert len(crossed) == 2
    assert any('"left" once: first grain 1' in warning for warning in crossed), crossed
    assert any('"right" once: first grain 0' in warning for warning in crossed)
