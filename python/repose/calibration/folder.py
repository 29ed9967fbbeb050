# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The folder of a calibration: made once for one file, locked while a calibration runs in it, against all others or
against those that do not share it."""

import fcntl
import os
import shutil
from contextlib import contextmanager, suppress
from pathlib import Path

from repose.calibration.errors import CalibrationError
from repose.calibration.sweep_rounds import write_first

OWN_FOLDERS = ("rounds", "pictures")
OWN_FILES = ("calibration.toml", "calibration.json", "posterior.csv", "points.csv")


def folder_problem(plan, folder, overwrite):
    """Why a calibration cannot be written into a folder; "" if it can."""
    folder = Path(folder)
    if not folder.exists():
        return ""
    if not folder.is_dir():
        return f"{folder}: is no folder"
    if (folder / "calibration.toml").is_file():
        return "" if overwrite else _other_file(plan, folder)
    if any(not path.name.startswith(".calibration.toml") for path in folder.iterdir()):
        return f"{folder}: folder is not empty and holds no calibration; choose another --out"
    return ""


def _other_file(plan, folder):
    """Says so where a folder was made from another file."""
    same = (folder / "calibration.toml").read_text(encoding="utf-8", errors="replace") == plan.text
    reason = "was made from another calibration file; choose another --out, or --overwrite"
    return "" if same else f"{folder}: {reason}"


def open_folder(plan, folder, overwrite, several=False):
    """Makes the folder, or opens that of the same file; returns a descriptor that locks it until it is closed. `several`
    programs hold it together."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    lock = os.open(folder, os.O_RDONLY | os.O_CLOEXEC)
    try:
        fcntl.flock(lock, (fcntl.LOCK_SH if several else fcntl.LOCK_EX) | fcntl.LOCK_NB)
    except BlockingIOError as error:
        os.close(lock)
        raise CalibrationError([f"{folder}: another program calibrates here"]) from error
    if overwrite:
        for name in OWN_FOLDERS:
            shutil.rmtree(folder / name, ignore_errors=True)
        for name in OWN_FILES:
            (folder / name).unlink(missing_ok=True)
    write_first(folder / "calibration.toml", plan.text)
    if problem := _other_file(plan, folder):  # one of several may have begun with another file
        raise CalibrationError([problem])
    return lock


@contextmanager
def one_at_a_time(folder):
    """Within the block this program alone writes results, so that all of them are of one program."""
    lock = os.open(Path(folder, "rounds"), os.O_RDONLY | os.O_CLOEXEC)
    try:
        with suppress(OSError):  # not every file system has locks
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield
    finally:
        os.close(lock)
