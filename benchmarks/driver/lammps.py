# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS (gran/hooke/history, one rank, one thread) on the beds and the heap."""

import functools
import os
import re
import shutil
import tempfile

from .cases import Contender, Measurement
from .process import Failed, run

PEERS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "peers")
SKINS = (0.05, 0.1, 0.2, 0.3, 0.4)  # at least one of them is the best in a bed
MISSING = "lammps is not installed (./dev setup installs it): no comparison with LAMMPS"


def program():
    return shutil.which("lmp")


def call(script, folder, **variables):
    """Runs a script of benchmarks/peers; returns (what it cost, its log)."""
    command = [program(), "-in", os.path.join(PEERS, script), "-screen", "none", "-log", "log.lammps"]
    for name, value in variables.items():
        command += ["-var", name, value]
    path = os.path.join(folder, "log.lammps")
    try:
        done = run(command, cwd=folder)
    except Failed as failure:
        if not os.path.exists(path):
            raise
        with open(path, encoding="utf-8") as log:
            raise Failed(f"{failure}\n{log.read()[-2000:]}") from failure
    with open(path, encoding="utf-8") as log:
        return done, log.read()


def loop_seconds(log):
    """(steps, CPU seconds) of the last run command alone, as LAMMPS itself measured them."""
    loops = re.findall(r"^Loop time of (\S+) on 1 procs for (\d+) steps", log, re.M)
    use = re.findall(r"^([\d.]+)% CPU use", log, re.M)
    if not loops or len(use) < len(loops):
        raise Failed(f"LAMMPS: no time in its log\n{log[-2000:]}")
    return int(loops[-1][1]), float(loops[-1][0]) * float(use[-1]) / 100


def run_bed(bed, skin, steps, every=0, warm=0):
    with tempfile.TemporaryDirectory() as folder:
        return call(
            "lammps.in", folder, bed=bed.path, dim=bed.dimension, copies=bed.copies, skin=skin, steps=steps, warm=warm,
            every=every or max(steps, 1),
        )


def steps_for(bed, seconds, rate):
    return max(20, round(seconds * rate / bed.moving))


@functools.cache
def best_skin(bed, seconds):
    rates = {}
    for skin in SKINS:
        steps, spent = loop_seconds(run_bed(bed, skin, steps_for(bed, seconds, 5e6))[1])
        rates[skin] = steps / spent
    return max(rates, key=rates.get)


def contender(options, bed, tried):
    """LAMMPS on a bed, with the skin that is best on the bed `tried`."""

    def measure():
        skin = best_skin(tried, options.seconds / 2)
        steps = steps_for(bed, options.seconds, 6e6)
        done, log = run_bed(bed, skin, steps, warm=steps // 10)
        steps, seconds = loop_seconds(log)
        return Measurement(bed.moving * steps / seconds, seconds, done.peak_mib, {"skin": skin})

    return Contender("LAMMPS", measure)
