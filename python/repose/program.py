# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Calls the program repose: what runs in processes of its own is not done within Python."""

import os
import shutil
import subprocess
import sys
from os import fspath
from pathlib import Path

from repose.sweep_folder import SweepFolder

INPUT_TROUBLE = 2  # exit status


def program():
    """Path of the program: REPOSE_PROGRAM, that in this package as pip installs it, beside it in a build folder or an
    installation, or on the PATH. RuntimeError without one."""
    package = Path(__file__).parent  # not resolved: a build folder has a link to the package
    here = package.parent
    beside = [package / "bin/repose", here.parent / "repose", here.parent.parent.parent / "bin/repose"]
    found = os.environ.get("REPOSE_PROGRAM") or next((fspath(path) for path in beside if path.is_file()), None)
    found = found or shutil.which("repose")
    if found is None:
        raise RuntimeError("the program repose is not on the PATH: REPOSE_PROGRAM may name it")
    return found


def main():
    """Becomes the program, which draws with this Python and this package: the command `repose` that pip installs."""
    package = fspath(Path(__file__).resolve().parent.parent)
    own = {"REPOSE_PYTHON": sys.executable, "REPOSE_PYTHON_PATH": package}
    os.execve(program(), ["repose", *sys.argv[1:]], own | dict(os.environ))


def call(*words):
    """Runs the program and waits. Ctrl-C reaches it too. ValueError with its messages for bad input, RuntimeError if it
    fails otherwise; KeyboardInterrupt if it was interrupted."""
    process = subprocess.Popen([program(), *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    try:
        _, messages = process.communicate()
    except KeyboardInterrupt:
        process.communicate()  # the program keeps what it has
        raise
    if process.returncode == INPUT_TROUBLE:
        raise ValueError(messages.strip())
    if process.returncode != 0:
        raise RuntimeError(messages.strip() or f"{words[0]}: exit status {process.returncode}")


def run_sweep(file, out=None, quick=False, threads=None, overwrite=False):
    """Runs or continues a sweep in the folder `out` (default: the name of the file), with its quick form if wanted and at
    most `threads` members side by side. Returns the SweepFolder. RuntimeError if members failed: the others are there."""
    out = fspath(out) if out is not None else Path(file).stem
    options = [word for word, wanted in (("--quick", quick), ("--overwrite", overwrite)) if wanted]
    if threads is not None:
        options += ["--threads", str(int(threads))]
    call("sweep", fspath(file), "--out", out, "--quiet", *options)
    return SweepFolder(out)
