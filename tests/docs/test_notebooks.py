# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks of docs run, as scripts of their cells, and are stored without outputs. The front page lists them.

`./dev docs` runs them in Jupyter, which the tests do without."""

import json
import os
import subprocess
import sys

import pytest
from commands import ROOT
from test_commands import LIMIT, PACKAGE, PROGRAM

NOTEBOOKS = sorted((ROOT / "docs/notebooks").glob("*.ipynb"))

# Shows the value of the last expression of a cell, as a notebook does, and closes its figures.
RUNNER = """
import ast, json, sys
import matplotlib.pyplot as plt
cells, names = json.load(open(sys.argv[1])), {"__name__": "__main__"}
for number, cell in enumerate(cells):
    tree = ast.parse(cell)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, f"cell {number}", "exec"), names)
    shown = eval(compile(ast.Expression(last.value), f"cell {number}", "eval"), names) if last else None
    if shown is not None and not cell.rstrip().endswith(";"):
        print(getattr(shown, "_repr_html_", shown.__repr__)())
    plt.close("all")
"""


def run_cells(cells, folder):
    """Runs code cells in one process, as a notebook does."""
    (folder / "cells.json").write_text(json.dumps(cells))
    (folder / "tmp").mkdir()
    environment = {"PYTHONPATH": PACKAGE, "REPOSE_PROGRAM": PROGRAM, "MPLBACKEND": "agg", "TMPDIR": str(folder / "tmp")}
    return subprocess.run([sys.executable, "-c", RUNNER, "cells.json"], cwd=folder, env=os.environ | environment,
                          capture_output=True, text=True, timeout=LIMIT, check=False)  # fmt: skip


def cells_of(notebook, kind):
    """Sources of the cells of a kind."""
    return ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == kind]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.name)
def test_a_notebook_runs(path, tmp_path):
    notebook = json.loads(path.read_text(encoding="utf-8"))
    result = run_cells(cells_of(notebook, "code"), tmp_path)
    assert result.returncode == 0 and result.stderr == "", result.stderr
    assert len(result.stdout.splitlines()) > 3


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.name)
def test_a_notebook_is_stored_without_outputs(path):
    notebook = json.loads(path.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        assert cell["cell_type"] != "code" or (cell["outputs"] == [] and cell["execution_count"] is None)
    assert cells_of(notebook, "markdown")[0].startswith("# ")
    assert f"](notebooks/{path.name})" in (ROOT / "docs/index.md").read_text(encoding="utf-8")


def test_a_cell_that_fails_is_found(tmp_path):
    result = run_cells(["x = 1", "x + 1;", "print(x)\nnothing"], tmp_path)
    assert result.returncode != 0 and "nothing" in result.stderr and result.stdout == "1\n"


def test_there_are_notebooks():
    assert len(NOTEBOOKS) >= 2
