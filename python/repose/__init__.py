# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Repose in Python: read a run folder as numpy arrays and draw it. No physics: that is the program's."""

from repose.run_folder import RunFolder, RunFolderError

__all__ = ["RunFolder", "RunFolderError"]
