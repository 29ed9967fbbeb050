# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Repose in Python: reads run and sweep folders as numpy arrays and draws them. The program computes the physics.

    import repose
    run = repose.open("out/heap")
    run.state.grains.position            # (N, D) [L]
    run.series["time"]                   # (rows) [T]
    run.analysis["voronoi"]["area"]      # (G) [L^2]
    sweep = repose.open("out/spacing")
    sweep.measures["coordination"]["mean"]  # (points)
"""

from pathlib import Path

from repose.analysis import Analysis
from repose.errors import RunFolderError
from repose.hdf5 import Table
from repose.run_folder import Contacts, Grains, RunFolder, State
from repose.sweep_folder import Profile, SweepFolder

__all__ = [
    "Analysis",
    "Contacts",
    "Grains",
    "Profile",
    "RunFolder",
    "RunFolderError",
    "State",
    "SweepFolder",
    "Table",
    "open",
]


def open(path):
    """The folder at `path` as a RunFolder or a SweepFolder; RunFolderError, one line, if it is neither or damaged."""
    folder = Path(path)
    if (folder / "sweep.h5").exists():
        return SweepFolder(folder)
    if folder.is_dir() and not (folder / "run.h5").exists():
        raise RunFolderError(f"{path}: no run.h5 or sweep.h5 in this folder")
    return RunFolder(folder)
