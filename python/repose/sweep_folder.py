# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads a sweep folder; the format is described in docs/reference/sweep.md."""

import tomllib
from pathlib import Path

import numpy as np

from repose.errors import RunFolderError
from repose.hdf5 import Table, attributes_of, check_format, opened
from repose.scene_comments import key_comments
from repose.summary import read_summary
from repose.tables import sweep_to_pandas

FORMAT_VERSION = 1
NEEDED = {"title", "units"}
COLUMNS = "x normal normal_error shear shear_error"
COLUMN = "depth pressure pressure_error stress stress_error"


class Profile(Table):
    """Mean base profile of a point, by base grain: x [L], forces [grain weights]; and a Table of it in bins."""

    binned: Table  #: the same columns, in bins of several base grains

    def __init__(self, group):
        super().__init__(group, COLUMNS)
        self.binned = Table(group["binned"], COLUMNS)


class SweepFolder:
    """The results of a sweep, read once when opened: P points, K members."""

    path: Path  #: the folder
    attributes: dict  #: of sweep.h5: title, units, repose_version
    points: "list[str]"  #: (P) names
    finished: np.ndarray  #: (P) finished members
    parameters: "dict[str, np.ndarray]"  #: (P) by key that varies; NaN where not a number or not set
    parameter_text: "dict[str, list[str]]"  #: (P) the same as text, "" where not set
    measures: "dict[str, Table]"  #: mean, error, deviation, count; newer also missing, low, high, bias: each (P)
    key_comments: dict  #: KeyComment by key that varies, as far as scenes of members are there
    members: Table  #: point, seed, status: each (K)
    values: "dict[str, np.ndarray]"  #: measures by member (K)
    profiles: "list[Profile | None]"  #: (P)
    columns: "list[Table | None]"  #: (P) mean column by slice: depth [L], stress [M/T^2], of spheres [M/(L T^2)] ...
    summary: dict  #: summary.json: comparisons of theory with the profiles; empty without

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_dir():
            raise RunFolderError(f"{path}: no such folder")
        with opened(self.path / "sweep.h5") as file:
            self.attributes = attributes_of(file)
            check_format(self.path / "sweep.h5", self.attributes, "sweep", FORMAT_VERSION, NEEDED)
            points = Table(file["points"], "name members")
            self.points, self.finished = points["name"], points["members"]
            self.parameters, self.parameter_text, self.values = (
                dict(Table(file[name])) if name in file else {} for name in ("parameters", "parameter_text", "values")
            )
            self.measures = {name: Table(part, "mean error deviation count") for name, part in file["measures"].items()}
            self.members = Table(file["members"], "point seed status")
            self.profiles = [_read_profile(file, k) for k in range(len(self.points))]
            self.columns = [_read_column(file, k) for k in range(len(self.points))]
        self.summary = read_summary(self.path / "summary.json")
        self.key_comments = self._key_comments()

    def _key_comments(self):
        known = {}
        for name in self.points:
            if known.keys() >= self.parameters.keys():
                break
            comments = key_comments(self._scene_text(name))
            known |= {key: comments[key] for key in self.parameters if key in comments}
        return known

    def to_pandas(self):
        """A DataFrame with a row per point: parameters, mean and standard error of every measure; ImportError without
        pandas."""
        return sweep_to_pandas(self)

    def scene(self, point):
        """Tables and keys of the scene of a point, by its name, as of its first member; empty where none can be read."""
        try:
            return tomllib.loads(self._scene_text(point))
        except tomllib.TOMLDecodeError:
            return {}

    def _scene_text(self, point):
        """The scene of the first member of a point; "" where it cannot be read, as pictures do without."""
        for path in sorted((self.path / "members" / point).glob("seed-*/scene.toml"))[:1]:
            if path.is_file():
                try:
                    return path.read_text(encoding="utf-8", errors="replace")
                except OSError:
                    pass
        return ""


def _read_column(file, point):
    name = f"columns/{point:04}"
    return Table(file[name], COLUMN) if name in file else None


def _read_profile(file, point):
    name = f"profiles/{point:04}"
    return Profile(file[name]) if name in file else None
