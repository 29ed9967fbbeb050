#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmarks of Repose and, if lmp is installed, LAMMPS on the same bed in the same run.

Called by ./dev bench. Rates are moving grain-steps per second of CPU time, or of wall time where threads are compared.
Machines drift, so quote the ratios of paired rounds. Slowness is never an error: the exit status is 1 only if something
fails to run, or if --check-physics finds that the two programs differ.
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
BAR = 2.5  # Repose over LAMMPS
MOVING = 10000  # grains of the bed that move
SKINS = (0.05, 0.1, 0.2, 0.3, 0.4)  # at least one of them is the best for LAMMPS
PHYSICS_STEPS = 20000


class Failed(Exception):
    """A program to be timed did not run."""


def run(command, **how):
    """Runs a command; raises Failed with the end of its output if it fails."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, **how)
    except OSError as problem:
        raise Failed(f"{command[0]}: {problem.strerror}") from problem
    if done.returncode != 0:
        raise Failed(f"{' '.join(command)}: exit status {done.returncode}\n{(done.stdout + done.stderr)[-2000:]}")
    return done.stdout


def bench(program, pattern):
    """{name: figures} of the Google Benchmark cases with matching names; names are without the settings of the case."""
    output = run([program, f"--benchmark_filter={pattern}", "--benchmark_format=json"])
    cases = {}
    for case in json.loads(output[output.index("{") :])["benchmarks"]:
        if case.get("error_occurred"):
            raise Failed(f"{case['name']}: {case['error_message']}")
        cases[re.sub(r"/(min_time|iterations):[\d.]+|/real_time", "", case["name"])] = case
    return cases


def lammps(program, bed, skin, steps, folder, every=0):
    """Runs LAMMPS on one core; returns (CPU seconds of the process, its log)."""
    script = os.path.join(ROOT, "benchmarks", "peers", "lammps.in")
    command = [program, "-in", script, "-screen", "none", "-log", "log.lammps"]
    for name, value in (("bed", bed), ("skin", skin), ("steps", steps), ("every", every or steps)):
        command += ["-var", name, str(value)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run(command, cwd=folder, env=dict(os.environ, OMP_NUM_THREADS="1"))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(os.path.join(folder, "log.lammps"), encoding="utf-8") as log:
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, log.read()


def lammps_rate(program, bed, skin, steps, folder):
    """Moving grain-steps per CPU second of the steps alone: a long run minus a short one."""
    few = steps // 10
    short, _ = lammps(program, bed, skin, few, folder)
    long, _ = lammps(program, bed, skin, steps, folder)
    return MOVING * (steps - few) / (long - short)


def spread(values):
    return f"{min(values):8.2f} {statistics.median(values):8.2f} {max(values):8.2f}"


def print_cases(cases):
    print("Repose, million moving grain-steps per second (of CPU time; bed_threads of wall time)")
    for name, case in cases.items():
        if "grain_steps" in case:
            builds = f"{case['steps_per_build']:8.0f} steps per pair list" if "steps_per_build" in case else ""
            print(f"  {name:40s} {case['grain_steps'] / 1e6:8.2f} {builds}")
    print("Repose, nanoseconds per grain and new pair list (of wall time)")
    for name, case in cases.items():
        if "seconds_per_grain" in case:
            print(f"  {name:40s} {case['seconds_per_grain'] * 1e9:8.0f}")


def compare_threads(program, rounds):
    """Compares two threads with one on the same 100 000 grains, in pairs of wall times."""
    ratios = []
    for _ in range(rounds):
        cases = bench(program, "^bed_threads/copies:10/")
        one, two = (cases[f"bed_threads/copies:10/threads:{threads}"]["grain_steps"] for threads in (1, 2))
        ratios.append(two / one)
    print(f"\nTwo threads over one, 100 000 grains, {rounds} pairs   min   median      max")
    print(f"  ratio                                   {spread(ratios)}")


def compare_speed(program, peer, bed, rounds, steps, folder):
    """Runs the bed in Repose and in LAMMPS alternately, and reports whether the bar is met."""
    rates = {skin: lammps_rate(peer, bed, skin, steps, folder) for skin in SKINS}
    skin = max(rates, key=rates.get)
    own, other = [], []
    for _ in range(rounds):
        case = bench(program, "^bed_hooke_linear/copies:1/")["bed_hooke_linear/copies:1/threads:1"]
        own.append(case["grain_steps"] / 1e6)
        other.append(lammps_rate(peer, bed, skin, steps, folder) / 1e6)
    ratios = [a / b for a, b in zip(own, other)]
    verdict = "is met" if statistics.median(ratios) >= BAR else "is NOT met"
    print(f"\nBed of {MOVING} discs, linear spring with tangential history, one core, {rounds} paired rounds")
    print("  million moving grain-steps per CPU second    min   median      max")
    print(f"  Repose                                  {spread(own)}")
    print(f"  LAMMPS gran/hooke/history, skin {skin:4.2f}    {spread(other)}")
    print(f"  ratio of the pairs                      {spread(ratios)}   the bar of {BAR} {verdict}")


def thermo(log):
    """Rows [step, kinetic energy, height of the centre of mass, force on the row] of a LAMMPS log."""
    return [[float(word) for word in row.split()] for row in re.findall(r"^ *\d+(?: +[-+.\deE]+){3} *$", log, re.M)]


def compare_physics(physics, peer, bed, folder):
    """Compares the bed after the same time in both programs: energy, centre of mass and force on the fixed row.

    The dashpots differ: they are proportional to the mass of a pair in LAMMPS and to its square root in Repose. So the
    energies agree only in part. The positions of rest and the weight must not depend on the dashpots.
    """
    _, log = lammps(peer, bed, 0.1, PHYSICS_STEPS, folder, every=PHYSICS_STEPS)
    start, end = thermo(log)[0], thermo(log)[-1]
    energy, height, force, weight = (float(word) for word in run([physics, str(PHYSICS_STEPS)]).split())
    rows = [
        ("kinetic energy of all grains", "12.4e", end[1], energy, 0.1 * end[1]),
        ("sinking of the centre of mass", "12.4e", start[2] - end[2], start[2] - height, 0.05 * (start[2] - end[2])),
        ("force on the fixed row over the weight", "12.5f", -end[3] / weight, force / weight, 0.01),
    ]
    print(f"\nThe bed after {PHYSICS_STEPS} steps                        LAMMPS       Repose")
    agree = True
    for what, shape, theirs, ours, tolerance in rows:
        close = abs(ours - theirs) <= tolerance
        agree = agree and close
        print(f"  {what:40s} {theirs:{shape}} {ours:{shape}}   {'agree' if close else 'DIFFER'} (within {tolerance:.1e})")
    return agree


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"), help="build folder")
    parser.add_argument("--rounds", type=int, default=5, help="paired rounds of every comparison (default: 5)")
    parser.add_argument("--quick", action="store_true", help="one round, the bed of 10 000 and the heap only")
    parser.add_argument("--check-physics", action="store_true", help="only compare what the two programs compute")
    options = parser.parse_args()
    if options.rounds < 1:
        parser.error("--rounds must be at least 1")
    program, physics, bed = (
        os.path.join(options.build, name) for name in ("repose_bench", "repose_bed_physics", "bed10k.data")
    )
    peer = shutil.which("lmp")
    no_peer = "lmp is not installed (./dev setup --peers installs it): no comparison with LAMMPS"
    rounds = 1 if options.quick else options.rounds

    with tempfile.TemporaryDirectory() as folder:
        if options.check_physics:
            if peer is None:
                print(no_peer)
                return 0
            return 0 if compare_physics(physics, peer, bed, folder) else 1
        load = os.getloadavg()[0]
        if load > 0.5:
            print(f"Other programs use this machine (load {load:.1f}): the ratio of threads suffers from it.\n")
        print_cases(bench(program, "bed_hooke|heap|build/copies:1/" if options.quick else "."))
        if not options.quick:
            compare_threads(program, rounds)
        if peer is None:
            print(no_peer)
            return 0
        compare_speed(program, peer, bed, rounds, 500 if options.quick else 3000, folder)
        if not options.quick:
            compare_physics(physics, peer, bed, folder)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Failed as failure:
        sys.exit(f"run.py: {failure}")
