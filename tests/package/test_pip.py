# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The package as pip installs it: module, program and command work from anywhere."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

BUILD = Path(os.environ.get("REPOSE_BUILD", ""))
SOURCE = Path(__file__).resolve().parents[2]
CLEAN = {name: os.environ[name] for name in ("PATH", "HOME") if name in os.environ}
SMALL = "source.count=30 source.height=10 base.half_width=12 source.rate=2".split()


def done(*words, cwd, **environment):
    """Standard output of a command that must end well."""
    result = subprocess.run([str(word) for word in words], cwd=cwd, env={**CLEAN, **environment}, capture_output=True,
                            text=True, timeout=600)
    assert result.returncode == 0, f"{words}: {result.stderr}{result.stdout}"
    return result.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """A folder into which pip has installed the package, made from a copy of the source, as pip builds in its place."""
    copy = tmp_path_factory.mktemp("source")
    for name in ("pyproject.toml", "setup.py", "README.md", "LICENSE", "CMakeLists.txt"):
        shutil.copy(SOURCE / name, copy)
    shutil.copytree(SOURCE / "python", copy / "python", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
    target = tmp_path_factory.mktemp("site")
    options = ["--no-build-isolation", "--no-deps", "--no-index", "--quiet", "--target", target]
    done(sys.executable, "-m", "pip", "install", *options, copy, cwd=copy, REPOSE_BUILD=str(BUILD.resolve()))
    return target


def test_the_command_runs_and_draws(installed, tmp_path):
    command = [sys.executable, installed / "bin/repose"]
    scene = ["--set", "contact.friction=0.4", *(word for setting in SMALL for word in ("--set", setting))]
    done(*command, "run", SOURCE / "examples/heap.toml", "--out", "heap", "--quiet", *scene, cwd=tmp_path,
         PYTHONPATH=str(installed))
    done(*command, "plot", "heap", "--only", "heap", "--format", "png", "--dpi", "50", cwd=tmp_path,
         PYTHONPATH=str(installed))
    assert (tmp_path / "heap/pictures/heap.png").stat().st_size > 1000


def test_the_module_has_the_program_and_its_bits(installed, tmp_path):
    script = (
        "import repose\n"
        "from repose.program import program\n"
        "scene = repose.Scene.example('heap')\n"
        "scene.contact.friction = 0.4\n"
        "scene.source.count, scene.source.height, scene.base.half_width, scene.source.rate = 30, 10.0, 12.0, 2.0\n"
        "run = repose.run(scene, 'heap')\n"
        "print(program())\n"
        "print(run.attributes['state_hash'])\n"
    )
    place, state = done(sys.executable, "-c", script, cwd=tmp_path, PYTHONPATH=str(installed)).splitlines()
    assert place == str(installed / "repose/bin/repose")
    resumed = done(place, "run", tmp_path / "heap/scene.toml", "--out", "again", "--quiet", cwd=tmp_path)
    assert resumed == ""
    script = "import repose\nprint(repose.open_run('again').attributes['state_hash'])\n"
    assert done(sys.executable, "-c", script, cwd=tmp_path, PYTHONPATH=str(installed)).strip() == state
