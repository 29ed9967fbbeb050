# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The soft method in beds of discs and spheres, beside LAMMPS and YADE."""

import json

from . import lammps, machine, yade
from .beds import bed
from .cases import OWN, Case, Contender, of_cost
from .process import run

UNIT = "moving grain-steps"
SIZES = (1_000, 10_000, 100_000, 1_000_000)
# Method, dimension, law, sizes, the largest size of --quick.
BEDS = (
    ("soft 2D", 2, "hooke", SIZES, 10_000),
    ("soft 2D, continuous law", 2, "continuous", (10_000,), 0),
    ("soft 3D", 3, "hooke", SIZES, 1_000),
)
MOST_TRIED = 100_000  # grains of a bed on which peers look for their best settings


def own(options, what, law, instructions, threads=1, lists=False):
    def measure():
        command = [options.program("repose_soft_bench"), "lists" if lists else "steps", what.dimension, law, what.path]
        done = run([*command, what.copies, threads, options.seconds], instructions)
        return of_cost(json.loads(done.output), threads)

    return Contender(OWN, measure, instructions, threads)


def cases(options):
    sets = machine.instruction_sets()
    for method, dimension, law, sizes, quick in BEDS:
        for size in options.wanted(sizes, quick):
            what = bed(options, size, dimension, law)
            contenders = [own(options, what, law, one) for one in sets]
            if size >= 10_000:
                contenders += [own(options, what, law, sets[-1], threads) for threads in thread_counts()]
            if law == "hooke":
                tried = bed(options, min(size, MOST_TRIED), dimension, law)
                if lammps.program():
                    contenders.append(lammps.contender(options, what, tried))
                if dimension == 3 and size <= yade.LARGEST and yade.program():
                    contenders.append(yade.contender(options, what))
            yield Case(method, size, UNIT, contenders)
    for size in options.wanted((10_000, 1_000_000), 10_000):
        what = bed(options, size)
        yield Case("new pair list 2D", size, "grains", [own(options, what, "hooke", sets[-1], lists=True)])


def thread_counts():
    """Beside one: two, four, ... up to all threads of the machine."""
    count = 2
    while count <= machine.threads():
        yield count
        count *= 2
