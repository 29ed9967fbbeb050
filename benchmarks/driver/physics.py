# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares what Repose and LAMMPS compute: programs with the same law must agree on the physics.

The beds after the same time: energy, centre of mass and force on the fixed grains. The dashpots differ: they are
proportional to the mass of a pair in LAMMPS and to its square root in Repose. So the energies agree only in part. The
positions of rest and the weight must not depend on the dashpots.
"""

import re

from . import lammps
from .beds import bed
from .process import run

BEDS = ((2, 10_000, 20_000), (3, 1_000, 20_000))  # dimension, grains, steps


def thermo(log):
    """Rows [step, kinetic energy, height of the centre of mass, force on the fixed grains] of a LAMMPS log."""
    return [[float(word) for word in row.split()] for row in re.findall(r"^ *\d+(?: +[-+.\deE]+){3} *$", log, re.M)]


def compare(options):
    """Prints the comparison; whether the programs agree."""
    agree = True
    for dimension, size, steps in BEDS:
        what = bed(options, size, dimension)
        options.say(f"the bed of {size} grains in {dimension}D, in both programs")
        _, log = lammps.run_bed(what, 0.1, steps, every=steps)
        start, end = thermo(log)[0], thermo(log)[-1]
        output = run([options.program("repose_bed_physics"), dimension, what.path, steps]).output
        energy, height, force, weight = (float(word) for word in output.split())
        rows = [
            ("kinetic energy without rotation", "12.4e", end[1], energy, 0.1 * end[1]),
            ("sinking of the centre of mass", "12.4e", start[2] - end[2], start[2] - height, 0.05 * (start[2] - end[2])),
            ("force on the fixed grains over the weight", "12.5f", -end[3] / weight, force / weight, 0.01),
        ]
        print(f"\n{f'The bed of {size} grains in {dimension}D, {steps} steps':44s}     LAMMPS       Repose")
        for name, shape, theirs, ours, tolerance in rows:
            close = abs(ours - theirs) <= tolerance
            agree = agree and close
            verdict = "agree" if close else "DIFFER"
            print(f"  {name:42s} {theirs:{shape}} {ours:{shape}}   {verdict} (within {tolerance:.1e})")
    return agree
