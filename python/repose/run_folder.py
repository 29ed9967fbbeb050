# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads a run folder; the format is described in docs/reference/run-folder.md."""

import json
from contextlib import contextmanager
from dataclasses import dataclass, fields
from pathlib import Path

import h5py
import numpy as np

FORMAT = "repose-run"
FORMAT_VERSION = 1
NEEDED = set("title units dimension time status grain_diameter grain_weight periodic x_min x_max".split())


class RunFolderError(ValueError):
    """A folder that holds no readable run; the message is one line."""


@dataclass(frozen=True)
class Grains:
    """Grains in order of their stable id: N grains in D dimensions."""

    id: np.ndarray  # (N) int64, ascending, with gaps where grains were lost
    position: np.ndarray  # (N, D) [L]
    velocity: np.ndarray  # (N, D) [L/T], half a step before the stated time
    spin: np.ndarray  # (N) in 2D, (N, 3) in 3D [1/T], counter-clockwise
    radius: np.ndarray  # (N) [L]
    mass: np.ndarray  # (N) [M]
    fixed: np.ndarray  # (N) bool: never moves nor turns
    base: np.ndarray  # (N) bool: belongs to the base
    material: np.ndarray  # (N) uint16

    def __len__(self):
        return len(self.id)

    @property
    def held(self):
        """Which grains the heap stands on or leans against: base grains and other fixed ones; (N) bool."""
        return self.fixed | self.base


@dataclass(frozen=True)
class Contacts:
    """Pairs within the reach of the normal law: M contacts in D dimensions; forces act on the first grain."""

    grains: np.ndarray  # (M, 2) int64 ids; second = -1 - k means plane k
    normal: np.ndarray  # (M, D) unit vector from the second to the first
    overlap: np.ndarray  # (M) [L], negative in the tail of the continuous law
    normal_force: np.ndarray  # (M) [M L/T^2], positive pushes apart
    tangential_force: np.ndarray  # (M) in 2D, (M, 3) in 3D [M L/T^2], along the normal turned by +90 degrees
    history: np.ndarray  # (M) in 2D, (M, 3) in 3D [L]
    sliding: np.ndarray  # (M) bool: at the Coulomb limit

    def __len__(self):
        return len(self.overlap)


@dataclass(frozen=True)
class State:
    """Grains and contacts of one moment."""

    time: float  # [T]
    steps: int
    grains: Grains
    contacts: Contacts
    frame: "str | None" = None  # name of the saved frame; None: the last state of the run

    def rows(self, ids):
        """Rows of the grains with these ids (any shape); RunFolderError if one is not there."""
        rows = np.searchsorted(self.grains.id, ids)
        within = np.minimum(rows, len(self.grains) - 1)
        if np.size(ids) and (len(self.grains) == 0 or not np.array_equal(self.grains.id[within], ids)):
            raise RunFolderError("a contact names a grain that is not in the file")
        return rows


class Table(dict):
    """Columns by name, with the attributes of their group."""

    def __init__(self, group):
        super().__init__({name: dataset[()] for name, dataset in group.items()})
        self.attributes = _attributes(group)


class RunFolder:
    """What a run wrote, read once: later changes of the folder do not show."""

    path: Path
    attributes: dict  # of run.h5: title, units, time [T], grain_diameter [L], grain_weight [M L/T^2], periodic ...
    state: State  # last state
    series: Table  # columns of /series, one row per observation; empty without
    base: "Table | None"  # forces on the base in grain weights; None without a row of base grains
    surface: "Table | None"  # profile of the heap and lines of its flanks
    planes: "Table | None"  # point (P, D) [L] and outward normal (P, D)
    frames: "list[str]"  # names of the saved frames
    summary: dict  # summary.json; empty without

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_dir():
            raise RunFolderError(f"{path}: no such folder")
        with _open(self.path / "run.h5") as file, _parts_of(self.path / "run.h5"):
            self.attributes = _attributes(file)
            _check_format(self.path / "run.h5", self.attributes)
            self.state = _read_state(file)
            self.series = Table(file["series"]) if "series" in file else {}
            self.base, self.surface, self.planes = (
                Table(file[name]) if name in file else None for name in ("base", "surface", "planes")
            )
            self.frames = sorted(file["frames"]) if "frames" in file else []
        self.summary = _read_summary(self.path / "summary.json")

    def frame(self, name):
        """State of a saved frame: "000003" or 3."""
        name = str(name).zfill(6)
        if name not in self.frames:
            saved = f"{self.frames[0]} to {self.frames[-1]}" if self.frames else "none"
            raise RunFolderError(f"{self.path}: no frame {name} (saved: {saved})")
        path = self.path / "frames" / f"{name}.h5"
        with _open(path) as file, _parts_of(path):
            return _read_state(file, name)


def _attributes(group):
    """Attributes of a group as Python values and arrays; text as str."""
    values = {}
    for name, value in group.attrs.items():
        if isinstance(value, bytes):
            value = value.decode("utf-8")
        values[name] = value.item() if isinstance(value, np.generic) else value
    return values


def _read_arrays(kind, group):
    """A Grains or Contacts from the datasets named like its fields; flags become bool."""
    arrays = {field.name: group[field.name][()] for field in fields(kind)}
    for name in {"fixed", "base", "sliding"} & arrays.keys():
        arrays[name] = arrays[name].astype(bool)
    return kind(**arrays)


def _read_state(file, frame=None):
    attributes = _attributes(file)
    return State(
        attributes["time"],
        attributes["steps"],
        _read_arrays(Grains, file["grains"]),
        _read_arrays(Contacts, file["contacts"]),
        frame,
    )


def _check_format(path, attributes):
    if attributes.get("format") != FORMAT:
        raise RunFolderError(f"{path}: not a run of Repose (no format = {FORMAT!r})")
    if attributes.get("format_version") != FORMAT_VERSION:
        version = attributes.get("format_version")
        raise RunFolderError(f"{path}: format_version {version}; this reads {FORMAT_VERSION}")
    missing = sorted(NEEDED - attributes.keys())
    if missing:
        raise RunFolderError(f"{path}: not as the format says: no attribute {', '.join(missing)}")


def _open(path):
    if not path.is_file():
        raise RunFolderError(f"{path.parent}: no {path.name} in this folder")
    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise RunFolderError(f"{path}: cannot be read: {_one_line(error)}") from error


@contextmanager
def _parts_of(path):
    """Turns what h5py says of a missing or damaged part into a RunFolderError."""
    try:
        yield
    except (AttributeError, KeyError, OSError, TypeError) as error:
        raise RunFolderError(f"{path}: not as the format says: {_one_line(error)}") from error


def _one_line(error):
    return " ".join(str(error).strip("'\"").split())


def _read_summary(path):
    if not path.is_file():
        return {}
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise RunFolderError(f"{path}: cannot be read: {_one_line(error)}") from error
