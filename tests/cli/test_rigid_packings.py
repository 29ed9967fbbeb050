# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Solid fractions at 40 degrees of packings by geometry, by geometry and then relaxed by contact dynamics, and deposited by
contact dynamics. Run by ./dev validate."""

import os
from pathlib import Path

import numpy as np
import pytest
from conftest import repose, summary

pytestmark = pytest.mark.skipif("REPOSE_SLOW" not in os.environ, reason="two minutes: for ./dev validate")

EXAMPLES = Path(__file__).parents[2] / "examples"
SIZE = ["--set", "base.count=32", "--set", "source.count=400", "--set", "method.critical_angle=40"]

RELAXED = """
[start]
from = "{start}"
[method]
kind = "contact-dynamics"
critical_angle = 40
tolerance = 1e-4
time_step = 0.2236
speed_limit = 0.2236
[box]
x = "periodic"
half_width = 16
[stop]
at_rest = 0.01
time = 400
"""


def solid_fraction(scene, out, *more):
    result = repose("run", scene, "--out", out, "--quiet", *more)
    assert result.returncode == 0, result.stderr
    return summary(out)["packing"]["solid_fraction"]["mean"]


# Bratberg 2003, paper one: a critical-angle packing becomes denser when it can relax, but less dense than one whose discs
# move while it grows. 400 discs on a width of 32, five seeds. Differences for the same seed are two standard errors from 0.
def test_order_of_densities(tmp_path):
    rows = []
    for seed in range(1, 6):
        held = tmp_path / f"held{seed}"
        scene = tmp_path / "relaxed.toml"
        scene.write_text(RELAXED.format(start=held))
        geometry = solid_fraction(EXAMPLES / "deposition.toml", held, *SIZE, "--seed", seed)
        relaxed = solid_fraction(scene, tmp_path / f"relaxed{seed}")
        rigid = solid_fraction(EXAMPLES / "deposition-cd.toml", tmp_path / f"rigid{seed}", *SIZE, "--seed", seed,
                               "--set", "method.tolerance=1e-3", "--set", "source.rest=0.02", "--set", "stop.time=6000")
        rows.append([geometry, relaxed, rigid])
    rows = np.array(rows)
    mean, error = rows.mean(axis=0), rows.std(axis=0, ddof=1) / np.sqrt(len(rows))
    print("solid fraction at 40 deg:", ", ".join(f"{m:.4f} +- {e:.4f}" for m, e in zip(mean, error)))
    for step in (rows[:, 1] - rows[:, 0], rows[:, 2] - rows[:, 1]):
        assert step.mean() > 2 * step.std(ddof=1) / np.sqrt(len(step))
