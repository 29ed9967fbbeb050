# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Repose in Python: read a run folder as numpy arrays and draw it. The physics is the program's.

    import repose
    run = repose.open("out/heap")
    run.state.grains.position   # (N, D) [L]
    run.series["time"]          # (rows) [T]
"""

from repose.run_folder import Contacts, Grains, RunFolder, RunFolderError, State, Table

__all__ = ["Contacts", "Grains", "RunFolder", "RunFolderError", "State", "Table", "open"]


def open(path):
    """The run folder at `path` as a RunFolder; RunFolderError, one line, if there is none to read."""
    return RunFolder(path)
