#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Repose's benchmarks and, where lmp is installed, LAMMPS beside it on the same bed in the same run.

Called by ./dev bench. Figures are moving grain-steps per second of CPU time (wall time for several threads); machines
drift, so the ratios of paired rounds are what to quote. Never a test: slow is not an error.
"""

import argparse
import json
import os
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BAR = 2.5
MOVING = 10000


def bench(program, pattern):
    """Runs the Google Benchmark cases that match; returns {name: figures}."""
    command = [program, f"--benchmark_filter={pattern}", "--benchmark_format=json"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return {case["name"]: case for case in json.loads(done.stdout)["benchmarks"]}


def lammps(program, bed, skin, steps, folder, every=0):
    """Runs LAMMPS; returns (CPU seconds of the process, its log)."""
    command = [program, "-in", os.path.join(ROOT, "benchmarks/peers/lammps.in"), "-screen", "none", "-log", "log.lammps"]
    for name, value in (("bed", bed), ("skin", skin), ("steps", steps), ("every", every or steps)):
        command += ["-var", name, str(value)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    subprocess.run(command, cwd=folder, env=environment, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(os.path.join(folder, "log.lammps"), encoding="utf-8") as log:
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, log.read()


def lammps_rate(program, bed, skin, steps, folder):
    """Moving grain-steps per CPU second of the steps alone: a long run less a short one."""
    short, _ = lammps(program, bed, skin, steps // 10, folder)
    long, _ = lammps(program, bed, skin, steps, folder)
    return MOVING * (steps - steps // 10) / (long - short)


def best_skin(program, bed, steps, folder):
    """LAMMPS's own best skin on this bed."""
    rates = {skin: lammps_rate(program, bed, skin, steps, folder) for skin in (0.03, 0.05, 0.1, 0.2, 0.3)}
    return max(rates, key=rates.get)


def spread(values):
    return f"{min(values) / 1e6:8.2f} {statistics.median(values) / 1e6:8.2f} {max(values) / 1e6:8.2f}"


def thermo(log):
    """Rows of numbers [step, kinetic energy, height of the centre of mass, force on the row] of a LAMMPS log."""
    return [[float(word) for word in row.split()] for row in re.findall(r"^ *\d+(?: +[-+.\deE]+){3} *$", log, re.M)]


def compare_physics(program, repose_program, bed, folder):
    """The same bed for the same time in both: energy, centre of mass and force on the row must agree."""
    steps = 20000
    _, log = lammps(program, bed, 0.1, steps, folder, every=steps)
    peer = thermo(log)[-1]
    done = subprocess.run([repose_program, str(steps)], capture_output=True, text=True, check=True)
    own = [float(word) for word in done.stdout.split()]
    weight = own[3]
    print(f"\nThe same bed after {steps} steps, linear law with history     LAMMPS        Repose")
    print(f"kinetic energy of all grains                            {peer[1]:12.4e}  {own[0]:12.4e}")
    print(f"height of the centre of mass                            {peer[2]:12.8f}  {own[1]:12.8f}")
    print(f"force on the fixed row over the weight                  {-peer[3] / weight:12.8f}  {own[2] / weight:12.8f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", default=os.path.join(ROOT, "build/release"), help="build folder")
    parser.add_argument("--rounds", type=int, default=5, help="paired rounds with LAMMPS")
    parser.add_argument("--quick", action="store_true", help="one short round, no large cases")
    options = parser.parse_args()
    program = os.path.join(options.build, "repose_bench")
    bed = os.path.join(options.build, "bed10k.data")
    rounds = 1 if options.quick else options.rounds
    steps = 500 if options.quick else 2000

    pattern = "copies:1/|heap" if options.quick else "."
    cases = bench(program, pattern)
    print("moving grain-steps, millions per second (CPU time; wall time for several threads)")
    for name, case in cases.items():
        if "grain_steps" in case:
            print(f"  {name:52s} {case['grain_steps'] / 1e6:8.2f}")
    print("pair list, nanoseconds per grain and build")
    for name, case in cases.items():
        if "seconds_per_grain" in case:
            print(f"  {name:52s} {case['seconds_per_grain'] * 1e9:8.0f}")
    one = next((c for n, c in cases.items() if n.startswith("bed_threads/copies:10/threads:1")), None)
    two = next((c for n, c in cases.items() if n.startswith("bed_threads/copies:10/threads:2")), None)
    if one and two:
        print(f"two threads over one at 1e5 grains: {two['grain_steps'] / one['grain_steps']:.2f}")

    peer = shutil.which("lmp")
    if peer is None:
        print("lmp is not installed (./dev setup --peers installs it): no comparison with LAMMPS")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        skin = best_skin(peer, bed, steps, folder)
        own_rates, peer_rates = [], []
        for _ in range(rounds):
            own_rates.append(bench(program, "bed_hooke_linear/copies:1/")["bed_hooke_linear/copies:1/threads:1"]["grain_steps"])
            peer_rates.append(lammps_rate(peer, bed, skin, steps, folder))
        ratios = [own / other for own, other in zip(own_rates, peer_rates)]
        print(f"\nBed of 10 000 discs, linear spring with tangential history, one core, {rounds} paired rounds")
        print("million moving grain-steps per CPU second      min   median      max")
        print(f"  Repose                                  {spread(own_rates)}")
        print(f"  LAMMPS gran/hooke/history (skin {skin:4.2f})    {spread(peer_rates)}")
        ratio = statistics.median(ratios)
        verdict = "met" if ratio >= BAR else "NOT met"
        print(f"  ratio of pairs: {min(ratios):.2f} / {ratio:.2f} / {max(ratios):.2f}; the bar of {BAR} is {verdict}")
        compare_physics(peer, os.path.join(options.build, "repose_bed_physics"), bed, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
