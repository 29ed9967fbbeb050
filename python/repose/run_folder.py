# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads a run folder; the format is described in docs/reference/run-folder.md."""

import tomllib
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np

from repose.analysis import Analysis
from repose.errors import RunFolderError
from repose.hdf5 import Table, attributes_of, check_format, opened, values_of
from repose.notebook import run_html
from repose.summary import read_summary
from repose.tables import to_pandas

FORMAT_VERSION = 4
FORCES = {"normal_force", "tangential_force", "history", "sliding"}
TANGENTIAL = {"tangential_force", "history"}  # vectors in three dimensions
NEEDED = set("title units dimension time status grain_diameter grain_weight periodic x_min x_max".split())


@dataclass(frozen=True)
class Grains:
    """Grains in order of their stable id: N grains in D dimensions."""

    id: np.ndarray  #: (N) int64, ascending, with gaps where grains were lost
    position: np.ndarray  #: (N, D) [L]
    velocity: np.ndarray  #: (N, D) [L/T], half a step before the stated time
    spin: np.ndarray  #: angular velocity [1/T], (N) counter-clockwise in 2D, (N, 3) in 3D
    radius: np.ndarray  #: (N) [L]
    mass: np.ndarray  #: (N) [M]
    fixed: np.ndarray  #: (N) bool: neither moves nor turns
    base: np.ndarray  #: (N) bool: belongs to the base
    material: np.ndarray  #: (N) uint16

    def __len__(self):
        return len(self.id)

    def to_pandas(self):
        """The grains as a DataFrame; ImportError without pandas."""
        return to_pandas(vars(self))

    @property
    def held(self):
        """Grains that support the heap, (N) bool: base grains and other fixed ones."""
        return self.fixed | self.base


@dataclass(frozen=True)
class Contacts:
    """Pairs within the range of the normal law: M contacts in D dimensions; forces act on the first grain."""

    grains: np.ndarray  #: (M, 2) int64 ids; second = -1 - k means wall k
    normal: np.ndarray  #: (M, D) unit vector from the second to the first
    overlap: np.ndarray  #: (M) [L], negative in the tail of the continuous law
    normal_force: np.ndarray  #: (M) [M L/T^2], positive pushes apart
    tangential_force: np.ndarray  #: [M L/T^2], (M) along the normal turned by +90 degrees in 2D, (M, 3) in 3D
    history: np.ndarray  #: [L] slip displacement, (M) in 2D, (M, 3) in 3D
    sliding: np.ndarray  #: (M) bool: at the Coulomb limit

    def __len__(self):
        return len(self.overlap)

    def to_pandas(self):
        """The contacts as a DataFrame with the columns first and second; ImportError without pandas."""
        first, second = self.grains.T
        return to_pandas({"first": first, "second": second, **{key: value for key, value in vars(self).items() if key != "grains"}})


@dataclass(frozen=True)
class State:
    """Grains and contacts at one time."""

    time: float  #: [T]
    steps: int  #: steps or events since the start
    grains: Grains  #: moving and fixed ones
    contacts: Contacts  #: pairs within the range of the normal law
    frame: "str | None" = None  #: name of the saved frame; None: the last state of the run
    axes: "object | None" = None  #: of its pictures (CommonAxes), as of those of other states; None: its own

    def rows(self, ids):
        """Rows of the grains with these ids (any shape); RunFolderError for an id without a grain."""
        rows = np.searchsorted(self.grains.id, ids)
        within = np.minimum(rows, len(self.grains) - 1)
        if np.size(ids) and (len(self.grains) == 0 or not np.array_equal(self.grains.id[within], ids)):
            raise RunFolderError("a contact names a grain that is not in the file")
        return rows


class RunFolder:
    """The results of a run, read once when opened: later changes of the folder have no effect."""

    path: Path  #: the folder
    attributes: dict  #: of run.h5: title, units, time [T], grain_diameter [L], grain_weight [M L/T^2], periodic ...
    scene: dict  #: tables and keys of the scene, complete; empty without
    state: State  #: last state
    series: Table  #: columns of /series, one row per observation; empty without
    base: "Table | None"  #: forces on the base in grain weights; None without a row of base grains
    walls: "Table | None"  #: name, point at the start and position now (W, D) [L], normal (W, D), half_length [L], open
    energy: "Table | None"  #: columns of /energy [M L^2/T^2]; None without an energy budget
    analysis: "Analysis | None"  #: Tables of analysis.h5; None without an analysis of the last state
    frames: "list[str]"  #: names of the saved frames
    summary: dict  #: summary.json; empty without

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_dir():
            raise RunFolderError(f"{path}: no such folder")
        with opened(self.path / "run.h5") as file:
            self.attributes = attributes_of(file)
            check_format(self.path / "run.h5", self.attributes, "run", FORMAT_VERSION, NEEDED)
            self.scene = tomllib.loads("".join(values_of(file["scene"]))) if "scene" in file else {}
            self.state = _read_state(file)
            self.series = Table(file["series"]) if "series" in file else {}
            self.base, self.walls, self.energy = (
                Table(file[name]) if name in file else None for name in ("base", "walls", "energy")
            )
            self.frames = sorted(file["frames"]) if "frames" in file else []
        self.analysis = _read_analysis(self.path / "analysis.h5", self.state, self.attributes)
        self.summary = read_summary(self.path / "summary.json")

    @property
    def surface(self):
        """Table of the surface profile with the lines of its flanks as attributes; None without an analysis."""
        return self.analysis and self.analysis.get("surface")

    def _repr_html_(self):
        """What a notebook shows of the run."""
        return run_html(self)

    def frame(self, name):
        """State of the saved frame `name`, "000003" or 3."""
        name = str(name).zfill(6)
        if name not in self.frames:
            saved = f"{self.frames[0]} to {self.frames[-1]}" if self.frames else "none"
            raise RunFolderError(f"{self.path}: no frame {name} (saved: {saved})")
        path = self.path / "frames" / f"{name}.h5"
        with opened(path) as file:
            _check_belongs(path, attributes_of(file), self.attributes)
            return _read_state(file, name)


def _read_arrays(kind, group):
    """A Grains or Contacts from the datasets named like its fields; flags become bool. A method without forces keeps none:
    they are 0 then."""
    arrays = {
        field.name: _no_forces(group, field.name)
        if kind is Contacts and field.name in FORCES and field.name not in group
        else values_of(group[field.name])
        for field in fields(kind)
    }
    for name in {"fixed", "base", "sliding"} & arrays.keys():
        arrays[name] = arrays[name].astype(bool)
    return kind(**arrays)


def _no_forces(group, name):
    """The zeros that stand for a dataset of forces which a method without forces leaves out."""
    count, dimension = group["normal"].shape
    return np.zeros((count, dimension) if dimension == 3 and name in TANGENTIAL else count)


def _read_state(file, frame=None):
    attributes = attributes_of(file)
    return State(
        attributes["time"],
        attributes["steps"],
        _read_arrays(Grains, file["grains"]),
        _read_arrays(Contacts, file["contacts"]),
        frame,
    )


def _check_belongs(path, attributes, run):
    """RunFolderError if a file of the folder belongs to another run than its run.h5."""
    if attributes.get("scene_hash", "") not in ("", run.get("scene_hash", "")):
        raise RunFolderError(f"{path}: belongs to another run than the run.h5 of this folder")


def _read_analysis(path, state, run):
    """None without a file, or with one of an earlier state: a running simulation writes run.h5 before analysis.h5."""
    if not path.is_file():
        return None
    analysis = Analysis(path, run["dimension"])
    _check_belongs(path, analysis.attributes, run)
    if analysis.attributes.get("state_hash", "") not in ("", run.get("state_hash", "")):
        return None
    chains = analysis.get("chains")
    same_contacts = chains is None or len(chains["chain"]) == len(state.contacts)
    return analysis if analysis.attributes["time"] == state.time and same_contacts else None
