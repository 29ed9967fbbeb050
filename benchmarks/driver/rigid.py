# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Contact dynamics: whole steps in the beds of discs, and its solver beside Siconos and Box2D on the same problems."""

import json
import os
import sys
import tempfile

import h5py

from . import machine
from .beds import bed
from .cases import OWN, Case, Contender, Measurement, of_cost
from .process import run

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import contact_dynamics  # noqa: E402

SIZES = (1_000, 10_000, 100_000, 1_000_000)
UNIT = "contact visits"
SWEEPS = 500  # of a problem, each forward and backward
_folder = tempfile.TemporaryDirectory()


def missing(options):
    return contact_dynamics.find_peers(options.build)


def cases(options):
    sets = machine.instruction_sets()
    for size in options.wanted(SIZES, 10_000):
        contenders = [steps(options, bed(options, size), one) for one in sets]
        yield Case("contact dynamics, steps", size, UNIT, contenders)
    peers = missing(options)
    for size in options.wanted(contact_dynamics.ROWS, contact_dynamics.SICONOS_BED):
        problem = Problem(options, size)
        contenders = [problem.own(one) for one in sets]
        if "siconos" in peers and size == contact_dynamics.SICONOS_BED:
            contenders.append(problem.siconos())
        if "box2d" in peers and size == contact_dynamics.BOX2D_BED:
            contenders.append(problem.box2d(peers["box2d"]))
        yield Case("contact dynamics, solver", size, UNIT, contenders)


def steps(options, what, instructions):
    def measure():
        command = [options.program("repose_rigid_bench"), what.path, what.copies, 1, options.seconds]
        return of_cost(json.loads(run(command, instructions).output))

    return Contender(OWN, measure, instructions)


class Problem:
    """The contact problem of a settled bed between two walls."""

    def __init__(self, options, size):
        options.say(f"settling a bed between walls: {size} discs")
        self.repose = options.program("repose")
        self.bed = contact_dynamics.Bed(self.repose, _folder.name, size)

    def own(self, instructions):
        def measure():
            answer = self.bed.file + ".answer"
            command = [self.repose, "solve", self.bed.file, "--out", answer, "--overwrite", "--quiet"]
            done = run([*command, "--tolerance", 0, "--most-sweeps", SWEEPS], instructions)
            with h5py.File(answer) as file:
                visits, seconds = file.attrs["contact_iterations"], file.attrs["cpu_seconds"]
            return Measurement(visits / seconds, seconds, done.peak_mib)

        return Contender(OWN, measure, instructions)

    def siconos(self):
        def measure():
            found = contact_dynamics.siconos(self.bed, "--iterations", 2 * SWEEPS)
            return Measurement(found["contact_iterations"] / found["cpu_seconds"], found["cpu_seconds"], 0.0)

        return Contender("Siconos", measure)

    def box2d(self, program):
        def measure():
            found = contact_dynamics.box2d(program, self.bed)
            return Measurement(found["contact_iterations"] / found["cpu_seconds"], found["cpu_seconds"], 0.0)

        return Contender("Box2D", measure)
