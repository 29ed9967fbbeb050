# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""A scene without gravity from check to plot: grains between four pistons, with forces in units of their mean."""

import json
import os
from pathlib import Path

import numpy as np
import pytest
from conftest import datasets, repose

EXAMPLE = Path(__file__).resolve().parents[2] / "examples/compress.toml"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("compress")
    checked = repose("check", EXAMPLE, cwd=folder)
    assert checked.returncode == 0, checked.stderr
    assert "nan" not in checked.stdout and "inf" not in checked.stdout
    done = repose("run", EXAMPLE, "--out", "run", cwd=folder)
    assert done.returncode == 0, done.stderr
    assert "nan" not in done.stdout
    return folder / "run"


@pytest.fixture(scope="module")
def summary(folder):
    return json.loads((folder / "summary.json").read_text())


# Balance of moments: the sum of force times branch along x is the force of a piston times the distance of the two that
# push along x, so that the mean stress is the force over the length of the piston. Tolerance: rest to 1e-4 of the forces.
def test_mean_stress_is_the_force_of_the_pistons_over_their_length(folder, summary):
    assert "at rest" in summary["stop_reason"]
    run = datasets(folder / "run.h5")
    place = dict(zip([name.decode() for name in run["/walls/name"]], run["/walls/position"]))
    width = place["right"][0] - place["left"][0]
    height = place["top"][1] - place["bottom"][1]
    walls = summary["walls"]
    for name, length, pressure in zip(walls["name"], walls["length"], walls["pressure"]):
        assert length == pytest.approx(width if name in ("top", "bottom") else height, rel=1e-9)
        assert pressure == pytest.approx(80.0 / length, rel=2e-3)
    area = run["/analysis/grain_stress/area"]
    cell = (run["/analysis/fields/x"][1] - run["/analysis/fields/x"][0]) ** 2
    for axis, length, other in (("xx", height, width), ("yy", width, height)):
        total = 80.0 / length * width * height
        assert (area * run[f"/analysis/grain_stress/stress_{axis}"]).sum() == pytest.approx(total, rel=2e-3)
        assert run[f"/analysis/fields/stress_{axis}"].sum() * cell == pytest.approx(total, rel=2e-3)


def test_numbers_have_their_meaning_without_a_weight(folder, summary):
    assert summary["force_scale"] == "mean" and summary["weight_error"] is None
    force = np.abs(datasets(folder / "run.h5")["/contacts/normal_force"])
    assert summary["force_unit"] == pytest.approx(force[force > 0.0].mean(), rel=1e-12)
    assert summary["contacts"] == (force > 0.05 * summary["force_unit"]).sum()
    assert summary["forces"]["mean"] == pytest.approx(force[force > 0.05 * summary["force_unit"]].mean(), rel=1e-9)
    assert 0.0 < summary["force_residual"] < 1e-3
    assert 3.0 < summary["coordination"] < 6.0


def test_analyse_changes_the_scale(folder, summary, tmp_path):
    scene = (folder / "scene.toml").read_text()
    try:
        (folder / "scene.toml").write_text(scene.replace('force_scale = "mean"', 'force_scale = "given"\nforce = 40.0'))
        assert repose("analyse", folder).returncode == 0
        found = json.loads((folder / "summary.json").read_text())
        force = np.abs(datasets(folder / "run.h5")["/contacts/normal_force"])
        assert found["force_unit"] == 40.0 and found["contacts"] == (force > 2.0).sum()
    finally:
        (folder / "scene.toml").write_text(scene)
        repose("analyse", folder)


@pytest.mark.skipif(not os.access("/usr/bin/python3", os.X_OK), reason="no Python")
def test_pictures(folder):
    done = repose("plot", folder, "--only", "forces,chains,stress,walls,force_distribution,energy", "--format", "png")
    assert done.returncode == 0, done.stderr
    assert done.stdout.count(".png") == 6, done.stdout


def test_a_weight_needs_gravity(tmp_path):
    done = repose("check", EXAMPLE, "--set", "analysis.force_scale=weight", cwd=tmp_path)
    assert done.returncode == 2 and "needs gravity > 0" in done.stderr
