# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""YADE (Law2_ScGeom_FrictPhys_CundallStrack, one thread) on the beds of spheres."""

import json
import os
import shutil
import tempfile

from .cases import Contender, Measurement
from .lammps import PEERS
from .process import Failed, run

LARGEST = 10_000  # grains: a larger bed takes minutes to set up
MISSING = "yade is not installed (./dev setup --peers installs it): no comparison with YADE"


def program():
    return shutil.which("yade")


def run_bed(bed, seconds):
    """(figures of the script, what the process cost)."""
    with tempfile.TemporaryDirectory() as folder:
        script = os.path.join(PEERS, "yade_bed.py")
        out = os.path.join(folder, "figures.json")
        done = run([program(), "-n", "-x", "-j1", script, bed.path, seconds, out], cwd=folder)
        try:
            with open(out, encoding="utf-8") as file:
                return json.load(file), done
        except (OSError, ValueError) as problem:
            raise Failed(f"YADE has written no figures: {problem}\n{done.output[-2000:]}") from problem


def contender(options, bed):
    def measure():
        figures, done = run_bed(bed, options.seconds)
        seconds = figures["cpu_seconds"]
        return Measurement(bed.moving * figures["steps"] / seconds, seconds, done.peak_mib)

    return Contender("YADE", measure)
