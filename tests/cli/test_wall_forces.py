# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pressure, shear and moment on walls: of a column of discs, and of a disc that a piston presses."""

import csv
import json

import pytest
from conftest import datasets, repose

HOOKE = "[contact]\nfriction = 0.0\nnormal = { law = 'hooke', stiffness = 1e4, damping = 0.5 }\n"
RIGID = "[method]\nkind = 'contact-dynamics'\n[contact]\nfriction = 0.0\n"
BIN = """
[[plane]]
name = "floor"
point = [0.0, 0.0]
normal = [0.0, 1.0]
[[plane]]
name = "left"
point = [-1.0, 0.0]
normal = [1.0, 0.0]
[[plane]]
name = "right"
point = [1.0, 0.0]
normal = [-1.0, 0.0]
"""
PRESS = """
gravity = 0.0
[contact]
friction = 0.3
normal = { law = 'hooke', stiffness = 1e4, damping = 0.5 }
[[wall]]
name = "table"
from = [-2.0, 0.0]
to = [2.0, 0.0]
[[plane]]
name = "piston"
point = [0.0, 1.02]
normal = [0.0, -1.0]
motion = "force"
force = [0.0, -5.0]
mass = 10.0
drag = 20.0
[[grain]]
position = [1.0, 0.51]
[stop]
at_rest = 1e-6
time = 100.0
[output]
window = 2.0
"""


def run(folder, text, *more):
    (folder / "scene.toml").write_text(text)
    done = repose("run", "scene.toml", "--out", "run", *more, cwd=folder)
    assert done.returncode == 0, done.stderr
    return json.loads((folder / "run/summary.json").read_text())


# Two columns of ten discs, without friction: the floor carries 20 grain weights over a length of 2, the sides nothing up
# to their length, the height of the column. Means over a window at rest; the tolerance is that of rest, and for rigid
# grains that of the solver.
@pytest.mark.parametrize("laws", [HOOKE, RIGID], ids=["soft", "rigid"])
def test_floor_under_columns(tmp_path, laws):
    grains = "".join(f"[[grain]]\nposition = [{x}, {0.5 + k}]\n" for x in (-0.5, 0.5) for k in range(10))
    found = run(tmp_path, laws + BIN + grains + "[stop]\ntime = 60\n[output]\nwindow = 20.0\nseries = 1.0\n")["walls"]
    assert found["name"] == ["floor", "left", "right"]
    assert found["length"][0] == pytest.approx(2.0, rel=1e-12)
    assert found["length"][1] == pytest.approx(10.0, rel=0.01)
    assert found["pressure"][0] == pytest.approx(10.0, rel=1e-4)
    assert found["shear"] == pytest.approx([0.0, 0.0, 0.0], abs=1e-4)
    assert found["moment"][0] == pytest.approx(0.0, abs=0.02)
    assert found["window"] == pytest.approx([40.0, 60.0], abs=1.01)  # by whole rows and steps
    tables = datasets(tmp_path / "run/run.h5")
    assert tables["/series/wall_pressure"][-1, 0] == pytest.approx(10.0, rel=1e-3)
    assert tables["/analysis/walls/pressure"][0] == found["pressure"][0]


# A piston presses a disc against a table. The disc lies a diameter to the right of the middle of the table, which is 4
# long; the piston is a plane that ends nowhere, so that its length is that of the disc.
def test_a_disc_that_a_piston_presses(tmp_path):
    summary = run(tmp_path, PRESS)
    assert "at rest" in summary["stop_reason"]
    walls = {name: k for k, name in enumerate(summary["walls"]["name"])}
    table, piston = walls["table"], walls["piston"]
    found = summary["walls"]
    assert found["length"][table] == 4.0 and found["length"][piston] == pytest.approx(1.0, rel=1e-12)
    assert found["pressure"][table] == pytest.approx(5.0 / 4.0, rel=1e-4)
    assert found["pressure"][piston] == pytest.approx(5.0, rel=1e-4)
    assert found["moment"][table] == pytest.approx(-5.0, rel=1e-3)
    assert found["moment"][piston] == pytest.approx(0.0, abs=1e-3)


def test_csv_has_the_walls_by_name(tmp_path):
    run(tmp_path, PRESS)
    assert repose("export", "run", "--to", "csv", "--out", "csv", cwd=tmp_path).returncode == 0
    lines = [line for line in (tmp_path / "csv/series.csv").read_text().splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    assert float(rows[-1]["wall_pressure_table"]) == pytest.approx(1.25, rel=1e-3)
    assert {"wall_shear_piston", "wall_length_piston", "wall_moment_table"} <= rows[0].keys()
    lines = [line for line in (tmp_path / "csv/analysis_walls.csv").read_text().splitlines() if not line.startswith("#")]
    assert {row["name"] for row in csv.DictReader(lines)} == {"table", "piston"}


# Moments are summed in the order of the contacts, which is that of ids.
def test_rows_of_walls_have_the_same_bits_for_two_threads(tmp_path):
    text = PRESS.replace("at_rest = 1e-6\ntime = 100.0", "time = 10.0")
    run(tmp_path, text)
    (tmp_path / "again").mkdir()
    (tmp_path / "again/scene.toml").write_text(text)
    whole = datasets(tmp_path / "run/run.h5")
    done = repose("run", "scene.toml", "--out", "run", "--threads", "2", cwd=tmp_path / "again")
    assert done.returncode == 0
    again = datasets(tmp_path / "again/run/run.h5")
    for name in ("length", "moment", "pressure", "shear", "force_y"):
        assert whole[f"/series/wall_{name}"].tobytes() == again[f"/series/wall_{name}"].tobytes()
