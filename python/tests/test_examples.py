# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The examples in Python: they run, in a small form, and mypy accepts them and the package's types."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
EXAMPLES = sorted((ROOT / "examples/python").glob("*.py"))


def test_mypy_accepts_the_examples(tmp_path):
    pytest.importorskip("mypy")
    environment = os.environ | {"MYPYPATH": str(ROOT / "python")}
    result = subprocess.run(
        [sys.executable, "-m", "mypy", "--cache-dir", str(tmp_path), "--follow-imports=silent", "--ignore-missing-imports",
         *map(str, EXAMPLES)],
        env=environment, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout
    wrong = tmp_path / "wrong.py"
    wrong.write_text('import repose\nscene = repose.Scene()\nscene.contact.friction = "much"\nscene.contact.frictoin = 1.0\n')
    result = subprocess.run([sys.executable, "-m", "mypy", "--cache-dir", str(tmp_path), "--follow-imports=silent",
                             "--ignore-missing-imports", str(wrong)],
                            env=environment, capture_output=True, text=True, check=False)
    assert "wrong.py:3: error" in result.stdout and "wrong.py:4: error" in result.stdout, result.stdout


def test_the_friction_for_an_angle_in_a_small_form(capsys):
    sys.path.insert(0, str(ROOT / "examples/python"))
    import friction_for_angle as example

    example.FRICTIONS, example.SEEDS = [0.2, 0.8], range(1, 3)
    made = example.heap

    def small(friction, seed):
        scene = made(friction, seed)
        scene.source.count = 40
        return scene

    example.heap = small
    example.main()
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 3 and lines[0].startswith("friction 0.2: ") and "degrees at a friction of" in lines[2]


def test_the_line_of_the_readme_prints_what_it_says(tmp_path):
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    (said,) = re.findall(r"command prints `([^`]+)`", text)
    (line,) = re.findall(r"^python3 -c .*", text, re.MULTILINE)
    result = subprocess.run([sys.executable, *shlex.split(line)[1:]], cwd=tmp_path, capture_output=True, text=True,
                            check=False)
    assert result.stdout == said + "\n", result.stderr
