# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the folder of a study: its study.json, and the ensemble of runs that it judges."""

import fnmatch
import json
from functools import cached_property
from pathlib import Path

from repose.errors import NotDrawn, RunFolderError, one_line
from repose.run_folder import RunFolder
from repose.sweep_folder import SweepFolder


class StudyFolder:
    """A study with its claims, its figure and its ensemble."""

    def __init__(self, path):
        self.path = Path(path)
        try:
            self.content = json.loads((self.path / "study.json").read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise RunFolderError(f"{path}: cannot be read: {one_line(error)}") from error
        self.name, self.title, self.source = (self.content[key] for key in ("study", "title", "source"))
        self.states, self.remark, self.claims = (self.content[key] for key in ("states", "remark", "claims"))
        self.figure = self.content["figure"]

    @property
    def ensemble(self):
        """Title, folder, seeds and points of the ensemble; None where models alone are judged."""
        return self.content["ensemble"]

    @cached_property
    def sweep(self):
        """The ensemble as a SweepFolder; NotDrawn without one."""
        if self.ensemble is None:
            raise NotDrawn("the study has no ensemble")
        return SweepFolder((self.path / self.ensemble["folder"]).resolve())

    def run(self, point, seed=None):
        """The run of a point; the first seed unless one is given. NotDrawn where it has not finished."""
        self.row(point)
        folder = self.sweep.path / "members" / point / f"seed-{seed or self.ensemble['seeds'][0]}"
        if not (folder / "run.h5").is_file():
            raise NotDrawn(f"{point}: no finished run in {folder}")
        return RunFolder(folder)

    def runs(self, point):
        """All finished runs of a point."""
        self.row(point)
        for folder in sorted((self.sweep.path / "members" / point).glob("seed-*")):
            if (folder / "run.h5").is_file():
                yield RunFolder(folder)

    def row(self, point):
        """The row of a point in the tables of the sweep."""
        if point not in self.sweep.points:
            raise NotDrawn(f"no point {point}; there are {', '.join(self.sweep.points)}")
        return self.sweep.points.index(point)

    def rows(self, pattern):
        """The rows of the points whose names match a pattern such as "soft_*"."""
        found = [k for k, name in enumerate(self.sweep.points) if fnmatch.fnmatchcase(name, pattern)]
        if not found:
            raise NotDrawn(f"no point {pattern}; there are {', '.join(self.sweep.points)}")
        return found
