# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Kernels compiled for instructions that not every processor has."""

import os
import platform
import subprocess
from pathlib import Path

import pytest
from conftest import HEAP, PROGRAM

OBJECTS = Path(PROGRAM).parent / "CMakeFiles" / "repose_kernels.dir"
ENTRIES = ("sweep_rows_avx", "kernels_avx")  # called where the processor has the instructions


def shared_functions(names):
    """Of the lines of nm, the functions of which the linker keeps one copy for all sources."""
    kinds = [(line.split(maxsplit=2)[1:]) for line in names.splitlines() if len(line.split(maxsplit=2)) == 3]
    return [name for kind, name in kinds if kind in "WTu" and not any(entry in name for entry in ENTRIES)]


# A copy that the linker keeps for all must not contain instructions that the machine lacks.
@pytest.mark.skipif(platform.machine() != "x86_64", reason="the sets are those of x86-64")
def test_kernels_share_no_function():
    assert shared_functions("0 W std::max\n0 T repose::soft::sweep_rows_avx2\n0 t local\n") == ["std::max"]
    objects = sorted(OBJECTS.rglob("*_avx*.o"))
    assert len(objects) == 4, objects
    for path in objects:
        names = subprocess.run(["nm", "-C", path], capture_output=True, text=True, check=True).stdout
        assert names.count("avx") > 0
        assert shared_functions(names) == [], path


def test_a_wrong_set_is_named(lab):
    lab.scene(HEAP)
    command = [PROGRAM, "run", "scene.toml", "--out", "out"]
    environment = {**os.environ, "REPOSE_INSTRUCTION_SET": "sse9"}
    done = subprocess.run(command, cwd=lab.path, env=environment, capture_output=True, text=True)
    assert done.returncode == 2 and not (lab.path / "out").exists()
    assert "REPOSE_INSTRUCTION_SET = sse9: must be scalar, baseline, avx2 or avx512" in done.stderr
