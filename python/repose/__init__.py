# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Repose in Python: scenes, simulations with the bits of the program, and folders of results as numpy arrays.

    import repose
    scene = repose.Scene.example("heap")     # or Scene.from_file("heap.toml"), or Scene({...})
    scene.source.count = 200
    run = repose.run(scene, "out/heap")      # as `repose run`; Ctrl-C interrupts, `Simulation.resume` continues
    run.state.grains.position                # (N, D) [L]
    run.series["time"]                       # (rows) [T]
    run.analysis["voronoi"]["area"]          # (G) [L^2]
    sweep = repose.run_sweep("examples/sweeps/spacing.toml", "out/spacing")
    sweep.measures["coordination"]["mean"]   # (points)
    repose.open_run("out/heap"), repose.open_sweep("out/spacing")
    repose.theory.predict("janssen", height=20)
"""

import importlib
from pathlib import Path
from typing import TYPE_CHECKING

from repose.analysis import Analysis
from repose.errors import RunFolderError
from repose.hdf5 import Table
from repose.run_folder import Contacts, Grains, RunFolder, State
from repose.sweep_folder import Profile, SweepFolder

if TYPE_CHECKING:
    from repose import theory
    from repose.scene import Scene, example_scenes
    from repose.simulation import RunError, Simulation, analyse, run
    from repose.theory import InputError

# What needs the compiled module is imported when it is asked for: pictures do without.
_COMPILED = {
    "InputError": "theory",
    "RunError": "simulation",
    "Scene": "scene",
    "Simulation": "simulation",
    "analyse": "simulation",
    "example_scenes": "scene",
    "run": "simulation",
}

__all__ = [
    "Analysis",
    "Contacts",
    "Grains",
    "InputError",
    "Profile",
    "RunError",
    "RunFolder",
    "RunFolderError",
    "Scene",
    "Simulation",
    "State",
    "SweepFolder",
    "Table",
    "analyse",
    "example_scenes",
    "open",
    "open_run",
    "open_sweep",
    "run",
    "run_sweep",
    "theory",
]


def __getattr__(name):
    if name == "theory":
        return importlib.import_module("repose.theory")
    if name in _COMPILED:
        return getattr(importlib.import_module(f"repose.{_COMPILED[name]}"), name)
    raise AttributeError(f"module 'repose' has no attribute {name!r}")


def __dir__():
    return __all__


def open(path):
    """The folder at `path` as a RunFolder or a SweepFolder; RunFolderError, one line, if it is neither or damaged."""
    folder = Path(path)
    if (folder / "sweep.h5").exists():
        return SweepFolder(folder)
    if folder.is_dir() and not (folder / "run.h5").exists():
        raise RunFolderError(f"{path}: no run.h5 or sweep.h5 in this folder")
    return RunFolder(folder)


def open_run(path):
    """The run folder at `path` as a RunFolder; RunFolderError, one line, if it is none or damaged."""
    return RunFolder(path)


def open_sweep(path):
    """The sweep folder at `path` as a SweepFolder; RunFolderError, one line, if it is none or damaged."""
    return SweepFolder(path)


def run_sweep(file, out=None, quick=False, threads=None, overwrite=False):
    """Runs or continues a sweep with the program, one process per member, and returns its SweepFolder: see
    repose.program.run_sweep."""
    from repose import program

    return program.run_sweep(file, out, quick, threads, overwrite)
