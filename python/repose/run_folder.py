# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Read a run folder. Layout, shapes and units: docs/reference/run-folder.md."""

import json
import os
from dataclasses import dataclass

import h5py
import numpy as np


class RunFolderError(Exception):
    """A folder that is not a readable run; the message is one line."""


@dataclass
class State:
    """Grains and contacts of one moment, in the units of the scene."""

    time: float
    id: np.ndarray  # (N) int64, ascending
    position: np.ndarray  # (N, 2) [L]
    velocity: np.ndarray  # (N, 2) [L/T]
    radius: np.ndarray  # (N) [L]
    fixed: np.ndarray  # (N) bool
    base: np.ndarray  # (N) bool
    pairs: np.ndarray  # (M, 2) int64 ids; second = -1 - k: plane k
    normal: np.ndarray  # (M, 2) from the second to the first
    overlap: np.ndarray  # (M) [L]
    normal_force: np.ndarray  # (M) [M L/T^2]
    sliding: np.ndarray  # (M) bool

    def places(self, ids):
        """Rows of the grains with these ids."""
        return np.searchsorted(self.id, ids)


class RunFolder:
    """The numbers of one run: `RunFolder("out/demo").state().position`."""

    def __init__(self, path):
        self.path = path
        if not os.path.isdir(path):
            raise RunFolderError(f"{path}: no such folder")
        name = os.path.join(path, "run.h5")
        if not os.path.isfile(name):
            raise RunFolderError(f"{path}: no run.h5 in this folder")
        try:
            self.file = h5py.File(name, "r")
        except OSError as error:
            raise RunFolderError(f"{name}: cannot read: {str(error).splitlines()[0]}") from error
        if self.attribute("format") != "repose-run":
            raise RunFolderError(f"{name}: not a run of Repose")
        if self.attribute("format_version") != 1:
            raise RunFolderError(f"{name}: format version {self.attribute('format_version')}, this reads version 1")

    def attribute(self, name, group="/"):
        """An attribute of a group; None if it is not there."""
        value = self.file[group].attrs.get(name)
        return value.decode() if isinstance(value, bytes) else value

    def has(self, group):
        return group in self.file

    def values(self, dataset):
        """A dataset as an array."""
        return self.file[dataset][()]

    def frames(self):
        """Names of the saved frames."""
        return sorted(self.file["frames"]) if self.has("frames") else []

    def state(self, frame=None):
        """The last state, or that of a saved frame."""
        if frame is not None and frame not in self.frames():
            known = ", ".join(self.frames()) or "none"
            raise RunFolderError(f"{self.path}: no frame {frame}; saved: {known}")
        root = self.file if frame is None else self.file[f"frames/{frame}"]
        grains = root["grains"]
        contacts = root["contacts"]
        return State(
            time=float(root.attrs["time"]),
            id=grains["id"][()],
            position=grains["position"][()],
            velocity=grains["velocity"][()],
            radius=grains["radius"][()],
            fixed=grains["fixed"][()].astype(bool),
            base=grains["base"][()].astype(bool),
            pairs=contacts["grains"][()],
            normal=contacts["normal"][()],
            overlap=contacts["overlap"][()],
            normal_force=contacts["normal_force"][()],
            sliding=contacts["sliding"][()].astype(bool),
        )

    def summary(self):
        """summary.json, or an empty dictionary before it is written."""
        name = os.path.join(self.path, "summary.json")
        if not os.path.isfile(name):
            return {}
        with open(name, encoding="utf-8") as file:
            return json.load(file)

    def length_label(self, symbol):
        """Axis label of a length, e.g. "x / σ" in reduced units."""
        return f"{symbol} / σ" if self.attribute("units") == "reduced" else f"{symbol} [m]"

    def time_label(self):
        return "time / √(σ/g)" if self.attribute("units") == "reduced" else "time [s]"
