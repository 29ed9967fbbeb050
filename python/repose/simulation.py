# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Simulations in Python: the same bits as `repose run`.

>>> import repose
>>> scene = repose.Scene.example("heap")
>>> scene.source.count = 30
>>> simulation = repose.Simulation(scene)
>>> reached = simulation.advance(20.0)
>>> with simulation.state() as state:
...     state.grains.position.shape[1], state.grains.base.sum() > 0
(2, True)
"""

import weakref
from contextlib import contextmanager
from os import fspath

import numpy as np

import repose_compiled
from repose.run_folder import Contacts, Grains, RunFolder, State

RunError = repose_compiled.RunError  # a RuntimeError: the run cannot continue or cannot be written


class Simulation:
    """A scene at work. The state does not depend on the number of threads, on how a run is divided into advances, nor on
    observers. Times are in units of the scene [T]. Other Python threads run while it computes; Ctrl-C ends an advance or a
    run within about a second, and an advance may be followed by another."""

    def __init__(self, scene, threads=1):
        """A simulation of a Scene at time 0. ValueError with a line for each problem of the scene."""
        self._live = repose_compiled.Simulation(scene._compiled(), int(threads))
        self._begin()

    @classmethod
    def resume(cls, folder, threads=1):
        """Continues an interrupted run from the last checkpoint of its folder, as `repose resume` does."""
        simulation = cls.__new__(cls)
        simulation._live = repose_compiled.Simulation.resume(fspath(folder), int(threads))
        simulation._begin()
        simulation._folder = fspath(folder)
        return simulation

    def _begin(self):
        self._folder = None
        self._busy = ""

    @contextmanager
    def _at_work(self, what):
        if self._busy:
            raise RuntimeError(f"cannot {what} {self._busy}")
        self._busy = "while the simulation runs"
        try:
            yield
        finally:
            self._busy = ""

    def advance(self, until):
        """Advances to a time [T], in whole steps where the method has equal ones, or until the run stops. Returns the time
        reached."""
        with self._at_work("advance"):
            return self._live.advance(float(until))

    def run(self, out=None, overwrite=False):
        """Advances until a stop of the scene. With `out`, writes a run folder as `repose run` does, and returns it as a
        RunFolder. After Ctrl-C the folder can be resumed."""
        with self._at_work("run"):
            if out is not None:
                self._folder = fspath(out)
                self._live.write_to(self._folder, bool(overwrite))
            self._live.run()
        return None if self._folder is None else RunFolder(self._folder)

    def save(self, folder, overwrite=False):
        """Writes the present state with its analysis and a checkpoint into a new run folder; returns it as a RunFolder."""
        with self._at_work("save"):
            self._live.save(fspath(folder), bool(overwrite))
        return RunFolder(folder)

    def observe_every(self, interval, use):
        """Calls use(simulation) every `interval` of simulated time [T], in whole steps. An exception of `use` ends the
        advance and comes out of it; the next advance continues as if nothing had been."""
        own = weakref.ref(self)
        self._live.observe_every(float(interval), lambda: use(own()))

    def interrupt(self):
        """Ends the present advance or run within about a second; from another thread or an observer."""
        self._live.interrupt()

    @contextmanager
    def state(self):
        """The present State within a `with` block, in which the simulation stands still: grains by id, contacts by the ids
        of their partners, as read-only numpy arrays. Copy what is to be changed."""
        before, self._busy = self._busy, "within a block with state()"
        try:
            yield State(self.time, self.steps, _grains(self._live.grains()), _contacts(self._live.contacts()))
        finally:
            self._busy = before

    def measures(self):
        """The numbers that the analysis finds in the present state, by the names of docs/reference/summary.md; NaN for
        those that are not defined."""
        return self._live.measures()

    @property
    def time(self):
        """[T]"""
        return self._live.time

    @property
    def time_step(self):
        """[T]; 0 where steps vary."""
        return self._live.time_step

    @property
    def steps(self):
        """Steps or events taken."""
        return self._live.steps

    @property
    def status(self):
        """ "running" until a stop of the scene; then "finished", "interrupted" or "failed"."""
        return self._live.status

    @property
    def message(self):
        """Why the run stopped."""
        return self._live.message

    @property
    def state_hash(self):
        """Of the exact state: equal for equal bits."""
        return self._live.state_hash

    def __repr__(self):
        return f"<Simulation {self.status} at time {self.time:g} after {self.steps} steps>"


def run(scene, out=None, threads=1, overwrite=False):
    """Runs a scene to its end: the RunFolder with `out`, else the Simulation."""
    simulation = Simulation(scene, threads)
    folder = simulation.run(out, overwrite)
    return simulation if folder is None else folder


def analyse(folder):
    """Analyses a run folder again, as `repose analyse` does; returns it as a RunFolder."""
    repose_compiled.analyse(fspath(folder))
    return RunFolder(folder)


def _grains(views):
    return Grains(**{**views, "material": views["material"].astype(np.uint16)})


def _contacts(views):
    first, second = views.pop("first"), views.pop("second")
    return Contacts(grains=np.column_stack([first, second]), **views)
