# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The golden list: every scene of this folder must end in the exact state whose hash is listed in hashes.toml.

The hash covers every bit of grains and contact histories, so it must be the same for any number of threads, compiler
options and x86 processor.

This prints the list as the program at hand would have it:
  REPOSE_PROGRAM=build/release/repose /usr/bin/python3 tests/golden/test_golden.py --print
"""

import json
import os
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

import pytest

FOLDER = Path(__file__).resolve().parent
PROGRAM = os.environ.get("REPOSE_PROGRAM", "")
SCENES = sorted(path.stem for path in FOLDER.glob("*.toml") if path.stem != "hashes")
HEAD = """\
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
#
# The state_hash at the end of every scene of this folder. A change of a hash needs its reason in the commit message.
# test_golden.py compares the list with the program, and prints it: see there.

"""

# The C library chooses variants of exp, log, pow, sin and others by the processor; their last bits differ. With these
# features masked it takes the variants of a processor without fused multiply-add. A C library that does not know the
# names ignores them.
WITHOUT_FUSED_MULTIPLY_ADD = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4"}


def hash_of(scene, folder, threads, environment=None):
    """The state_hash of a scene, run by the program into `folder`."""
    command = [PROGRAM, "run", FOLDER / f"{scene}.toml", "--out", folder, "--quiet", "--threads", threads]
    result = subprocess.run(
        [str(word) for word in command],
        env={**os.environ, **(environment or {})},
        timeout=600,
        capture_output=True,
        text=True,
        errors="replace",
    )
    assert result.returncode == 0, result.stderr + result.stdout
    return json.loads((Path(folder) / "summary.json").read_text())["state_hash"]


@pytest.fixture(scope="module")
def listed():
    assert Path(PROGRAM).is_file(), f"set REPOSE_PROGRAM to the path of the program, not {PROGRAM!r}"
    return tomllib.loads((FOLDER / "hashes.toml").read_text())


def test_every_scene_has_a_line_and_every_line_a_scene(listed):
    assert sorted(listed) == SCENES


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("scene", SCENES)
def test_state_is_golden(scene, threads, listed, tmp_path):
    assert hash_of(scene, tmp_path / "out", threads) == listed.get(scene)


@pytest.mark.parametrize("scene", SCENES)
def test_state_does_not_depend_on_the_processor(scene, listed, tmp_path):
    assert hash_of(scene, tmp_path / "out", 1, WITHOUT_FUSED_MULTIPLY_ADD) == listed.get(scene)


@pytest.mark.parametrize("instructions", ["scalar", "baseline"])
@pytest.mark.parametrize("scene", ["soft-continuous-cumulative", "soft-hertz-mindlin", "soft-hooke-linear", "rigid-accelerated"])
def test_state_does_not_depend_on_the_instruction_set(scene, instructions, listed, tmp_path):
    environment = {"REPOSE_INSTRUCTION_SET": instructions}
    assert hash_of(scene, tmp_path / "out", 1, environment) == listed.get(scene)


def print_list():
    print(HEAD, end="")
    for scene in SCENES:
        with tempfile.TemporaryDirectory() as folder:
            print(f'{scene} = "{hash_of(scene, Path(folder) / "out", 1)}"')


if __name__ == "__main__":
    if sys.argv[1:] != ["--print"]:
        sys.exit("usage: REPOSE_PROGRAM=PATH python3 test_golden.py --print")
    print_list()
