# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""`repose theory` from outside: its list, its tables, refused settings, and the same numbers in Python to the bit."""

import csv
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import PROGRAM, repose

# Parameters that a model needs beside its defaults.
GIVEN = {"janssen-fit": ["file={table}", "mass_per_height=1"]}
TABLE = "height,apparent_mass\n1,0.6\n2,0.9\n3,0.95\n4,1.1\n"


def listed():
    """Names of all models."""
    out = repose("theory", "--list")
    assert out.returncode == 0 and not out.stderr
    return [line for line in out.stdout.splitlines() if line and not line.startswith(" ")]


def table_of(text):
    """(lines with #, names, rows) of a CSV text."""
    lines = text.splitlines()
    notes = [line for line in lines if line.startswith("#")]
    names, *rows = csv.reader(line for line in lines if not line.startswith("#"))
    return notes, names, rows


@pytest.fixture
def settings(tmp_path):
    """The settings that a model needs, as options."""
    table = tmp_path / "table.csv"
    table.write_text(TABLE)
    return lambda model: [word for one in GIVEN.get(model, []) for word in ("--set", one.format(table=table))]


def test_the_list_names_parameters_defaults_units_and_sources():
    text = repose("theory", "--list").stdout
    assert "slope_deg = 30 deg: slope of both flanks; must be > 0 and < 60" in text
    assert text.count("Source: ") == len(listed()) >= 12


def test_every_model_has_a_table(settings):
    for model in listed():
        out = repose("theory", model, *settings(model))
        assert out.returncode == 0, (model, out.stderr)
        notes, names, rows = table_of(out.stdout)
        assert rows and {len(row) for row in rows} == {len(names)}, model
        assert notes[0].startswith(f"# {model}: ") and notes[1].startswith("# source: ")
        assert [line.split()[2].split("[")[0].rstrip(":") for line in notes if line.startswith("# column")] == names
        assert "-0" not in {cell for row in rows for cell in row}, model


def in_python(code, **given):
    """The JSON output of a Python program with the package on its path."""
    root = Path(__file__).resolve().parents[2]
    path = f"{Path(PROGRAM).resolve().parent / 'python'}:{root / 'python'}"
    out = subprocess.run(
        [sys.executable, "-c", code, json.dumps(given)],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": path},
    )
    assert out.returncode == 0, out.stderr
    return json.loads(out.stdout)


COLUMNS = """
import json, sys
from repose import theory
given = json.loads(sys.argv[1])
out = {}
for model, settings in given["models"].items():
    columns = theory.predict(model, **settings).columns.values()
    out[model] = {c.name: [v if isinstance(v, str) else float(v).hex() for v in c.value] for c in columns}
print(json.dumps(out))
"""


def test_python_has_the_same_numbers_to_the_bit(settings):
    asked = {}
    for model in listed():
        asked[model] = dict(word.split("=", 1) for word in settings(model)[1::2])
    asked["pile-continuum"]["slope_deg"] = "32.6"
    got = in_python(COLUMNS, models=asked)
    for model, given in asked.items():
        words = [word for name, value in given.items() for word in ("--set", f"{name}={value}")]
        _, names, rows = table_of(repose("theory", model, *words).stdout)
        assert list(got[model]) == names, model
        for name, *cells in zip(names, *rows):
            of_model = got[model][name]
            is_hex = [value.lstrip("-").startswith("0x") for value in of_model]
            printed = [float(cell).hex() if is_number else cell for cell, is_number in zip(cells, is_hex)]
            assert [v if v != "nan" else "nan" for v in got[model][name]] == [
                "nan" if cell == "nan" else cell for cell in printed
            ], (model, name)


def test_python_reports_problems():
    code = """
import json
from repose import theory
try:
    theory.predict("pile-continuum", slope_deg=61, points=1)
except ValueError as error:
    print(json.dumps(str(error)))
"""
    assert in_python(code) == (
        "pile-continuum: slope_deg = 61: must be > 0 and < 60 (deg)\n"
        "pile-continuum: points = 1: must be from 2 to 1000000"
    )


def test_a_file_for_the_table(tmp_path):
    file = tmp_path / "pile.csv"
    out = repose("theory", "pile-continuum", "--csv", file)
    assert out.returncode == 0 and out.stdout == ""
    assert file.read_text() == repose("theory", "pile-continuum").stdout
    assert [path.name for path in tmp_path.iterdir()] == ["pile.csv"]


def test_every_model_has_a_picture(tmp_path, settings):
    for model in listed():
        out = repose("theory", model, *settings(model), "--plot", tmp_path / f"{model}.png")
        assert out.returncode == 0 and out.stdout == "", (model, out.stderr)
        assert (tmp_path / f"{model}.png").read_bytes().startswith(b"\x89PNG")


def test_other_formats(tmp_path):
    for kind, start in (("svg", b"<?xml"), ("pdf", b"%PDF")):
        file = tmp_path / f"pile.{kind}"
        assert repose("theory", "pile-continuum", "--plot", file).returncode == 0
        assert file.read_bytes().startswith(start)


@pytest.mark.parametrize(
    "words, complaints",
    [
        ([], ["repose theory: MODEL is missing"]),
        (["pyramid"], ["pyramid: no such model of theory; must be pile-lattice | pile-continuum"]),
        (["pile-continuum", "--set", "slope_deg"], ["--set slope_deg: must be key=value"]),
        (["pile-continuum", "--csv", "no/such/x.csv"], ["no/such/x.csv: no such folder"]),
        (["pile-continuum", "--plot", "x.gif"], ["x.gif: must end in .png, .svg, .pdf or .eps"]),
        (
            ["pile-continuum", "--set", "slope_deg=0", "--set", "slop=3"],
            ["pile-continuum: slope_deg = 0: must be > 0", "pile-continuum: slop: no such parameter"],
        ),
    ],
)
def test_refusals(tmp_path, words, complaints):
    out = repose("theory", *words, cwd=tmp_path)
    assert out.returncode == 2 and out.stdout == ""
    lines = out.stderr.splitlines()
    assert len(lines) == len(complaints) and all(map(str.startswith, lines, complaints)), lines
    assert list(tmp_path.iterdir()) == []
