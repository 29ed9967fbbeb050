# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The measure of docs/how-to/add-a-measure.md, built by CMakeLists.txt here, appears wherever a run is read."""

import csv
import json
import os
import subprocess

import h5py
import numpy as np
import pytest

from repose.run_folder import RunFolder

PROGRAM = os.environ["REPOSE_PROGRAM"]

POURED = """
[grains]
polydispersity = 0.4
[contact]
normal = { law = "hooke", stiffness = 1e3, damping = 0.5 }
tangential = { law = "linear", stiffness = 500 }
[base]
kind = "row"
half_width = 6.0
[source]
kind = "pour"
count = 12
rate = 5.0
height = 6.0
half_width = 2.0
[stop]
time = 6.0
"""
DEPOSITED = """
[method]
kind = "deposition"
critical_angle = 30
[base]
kind = "contiguous"
count = 8
[grains]
polydispersity = {}
[source]
count = 40
"""


def run(folder, *arguments, program=PROGRAM):
    done = subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(params=[POURED, DEPOSITED.format(0.4)], ids=["poured", "deposited"])
def out(request, tmp_path):
    (tmp_path / "scene.toml").write_text(request.param)
    run(tmp_path, "run", "scene.toml", "--out", "out", "--quiet")
    return tmp_path / "out"


def grains_of(out):
    with h5py.File(out / "run.h5") as file:
        own = file["grains/base"][()] == 0
        return 2 * file["grains/radius"][()][own], file["grains/position"][()][own, 1]


def test_number_and_datasets_are_right(out):
    diameter, height = grains_of(out)
    summary = json.loads((out / "summary.json").read_text())
    assert summary["segregation"] == pytest.approx(np.corrcoef(diameter, height)[0, 1], abs=1e-9)
    with h5py.File(out / "analysis.h5") as file:
        layers = file["layers"]
        numbers = np.unique(np.floor(height))
        assert layers.attrs["count"] == len(numbers)
        np.testing.assert_allclose(layers["height"], numbers + 0.5)
        for row, number in enumerate(numbers):
            inside = np.floor(height) == number
            assert layers["grains"][row] == inside.sum()
            assert layers["diameter"][row] == pytest.approx(diameter[inside].mean())
        assert layers["diameter"].attrs["unit"] == "L" and layers["diameter"].attrs["meaning"]


def test_appears_in_tables_and_in_python(out):
    run(out.parent, "export", "out", "--to", "csv")
    summary = json.loads((out / "summary.json").read_text())

    def rows(name):
        lines = (out / "export/csv" / name).read_text().splitlines()
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))

    (own,) = (row for row in rows("analysis_measures.csv") if row["name"] == "segregation")
    assert float(own["value"]) == summary["segregation"] and "height" in own["meaning"]
    found = RunFolder(out)
    assert found.summary["segregation"] == summary["segregation"]
    layers = found.analysis["layers"]
    assert [float(row["diameter"]) for row in rows("analysis_layers.csv")] == layers["diameter"].tolist()
    assert layers.units["diameter"] == "L" and layers.units["grains"] == ""
    measures = dict(zip(found.analysis["measures"]["name"], found.analysis["measures"]["value"]))
    assert measures["segregation"] == summary["segregation"]


def test_is_analysed_again_and_null_where_undefined(tmp_path):
    (tmp_path / "scene.toml").write_text(DEPOSITED.format(0.0))
    run(tmp_path, "run", "scene.toml", "--out", "out", "--quiet", program=os.environ["REPOSE_WITHOUT"])
    assert "segregation" not in json.loads((tmp_path / "out/summary.json").read_text())
    run(tmp_path, "analyse", "out")
    assert json.loads((tmp_path / "out/summary.json").read_text())["segregation"] is None


def test_is_a_measure_of_sweeps(tmp_path):
    (tmp_path / "scene.toml").write_text(DEPOSITED.format(0.4))
    claim = '[[claim]]\ntext = "mixed"\nmeasure = "segregation"\npoint = "all"\nabove = -1\nbelow = 1\nsource = "here"\n'
    (tmp_path / "sweep.toml").write_text(f'scene = "scene.toml"\nseeds = 3\n[[point]]\nname = "all"\n{claim}')
    run(tmp_path, "sweep", "sweep.toml", "--out", "sweep", "--quiet")
    with open(tmp_path / "sweep/table.csv") as file:
        (row,) = csv.DictReader(file)
    assert -1 < float(row["segregation"]) < 1 and row["segregation:count"] == "3"
    assert "agrees" in (tmp_path / "sweep/claims.csv").read_text()


def test_is_in_the_reference(tmp_path):
    assert "| `segregation` | | correlation of the diameter and the height of grains | |" in run(
        tmp_path, "reference", "summary"
    )
    assert "| `diameter` | (layers) | L | mean of these grains |" in run(tmp_path, "reference", "analysis")
