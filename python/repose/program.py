# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Calls the program repose: what runs in processes of its own is not done within Python."""

import os
import shutil
import subprocess
from os import fspath
from pathlib import Path

from repose.sweep_folder import SweepFolder

INPUT_TROUBLE = 2  # exit status


def program():
    """Path of the program: REPOSE_PROGRAM, that beside this package in a build folder or an installation, or that on the
    PATH. RuntimeError without one."""
    here = Path(__file__).parent.parent  # not resolved: a build folder has a link to the package
    beside = [here.parent / "repose", here.parent.parent.parent / "bin/repose"]
    found = os.environ.get("REPOSE_PROGRAM") or next((fspath(path) for path in beside if path.is_file()), None)
    found = found or shutil.which("repose")
    if found is None:
        raise RuntimeError("the program repose is not on the PATH: REPOSE_PROGRAM may name it")
    return found


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
