#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares contact dynamics of Repose, Siconos and Box2D (if installed) on the same settled beds in one run.

Called by ./dev bench --contact-dynamics. Each solver has one thread; CPU time is that of the solver alone. The programs
alternate. Quote medians over the rounds, and medians of ratios within a round. Impulses are judged only by the independent
function in benchmarks/peers/contact_problem.py. Slowness is never an error: the exit status is 1 only if something fails
to run.
"""

import argparse
import importlib.util
import json
import os
import statistics
import subprocess
import sys
import tempfile

import h5py

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PEERS = os.path.join(ROOT, "benchmarks", "peers")
sys.path.insert(0, PEERS)
from contact_problem import read_problem, residual  # noqa: E402

TOLERANCE = 1e-4  # of the independent residual
ROWS = {1000: 20, 5000: 100}  # of 50 discs
SICONOS_BED, BOX2D_BED, BED = 1000, 5000, 5000
RATE_SWEEPS = 500  # each forward and backward: 1000 visits of each contact
GIVEN_UP = 4e7  # contact-iterations per second of Repose over those of Siconos
BARS = {"time": 10.0, "siconos": 50.0, "box2d": 6.0}
ONE_THREAD = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")


class Failed(Exception):
    """A program to be timed did not run."""


def run(command, **how):
    try:
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=ONE_THREAD, **how)
    except OSError as problem:
        raise Failed(f"{command[0]}: {problem.strerror}") from problem
    if done.returncode != 0:
        raise Failed(f"{command[0]}: exit status {done.returncode}\n{(done.stdout + done.stderr)[-2000:]}")
    return done.stdout


class Bed:
    """A settled bed: its run, and the problem of its next step."""

    def __init__(self, repose, folder, discs):
        self.repose = repose
        self.discs = discs
        out = os.path.join(folder, f"bed{discs}")
        scene = os.path.join(ROOT, "benchmarks", "beds", "walled.toml")
        run([repose, "run", scene, "--set", f"source.rows={ROWS[discs]}", "--threads", 1, "--out", out, "--quiet"])
        run([repose, "export", out, "--to", "contact-problem", "--quiet"])
        self.file = os.path.join(out, "export", "contact-problem", "problem.h5")
        self.answer = os.path.join(out, "answer.h5")
        self.problem = read_problem(self.file)

    def solve(self, *options):
        """The report of `repose solve` on its solution, with the independent residual."""
        run([self.repose, "solve", self.file, "--out", self.answer, "--overwrite", "--quiet", *options])
        with h5py.File(self.answer) as file:
            found = {name: file.attrs[name] for name in ("cpu_seconds", "contact_iterations", "sweeps")}
            found["residual"] = residual(self.problem, file["impulse"][()])["worst"]
        found |= {"contacts": len(self.problem.friction), "iterations": 2 * found["sweeps"]}
        return found

    def table(self):
        """(time step, one disc or wall per line) in the form that repose_box2d_bench reads."""
        with h5py.File(self.file) as file:
            body = {name: data[()] for name, data in file["bodies"].items()}
            second, normal = file["contacts/bodies"][:, 1], file["contacts/normal"][()]
            time_step = file.attrs["time_step"]
        lines = []
        for k, (x, y) in enumerate(body["position"]):
            if body["id"][k] >= 0:
                lines.append(f"disc {x} {y} {body['radius'][k]} {body['mass'][k]}")
            else:
                nx, ny = normal[second == k][0]
                lines.append(f"wall {x} {y} {nx} {ny}")
        return time_step, "\n".join(lines) + "\n"


def siconos(bed, *options):
    script = os.path.join(PEERS, "siconos_solve.py")
    return json.loads(run([sys.executable, script, bed.file, *options]))


def box2d(program, bed):
    time_step, table = bed.table()
    return json.loads(run([program, time_step], input=table))


def one_round(beds, options, peers, starts):
    """{case: figures} of each program, one after the other."""
    cases = {}
    for start in starts:
        begin = ["--warm"] if start == "warm" else []
        for discs, bed in beds.items():
            most_sweeps = int(options.seconds * GIVEN_UP / (2 * len(bed.problem.friction)))
            till = ["--tolerance", TOLERANCE, "--most-sweeps", most_sweeps, *begin]
            cases["Repose", "time", start, discs] = bed.solve(*till)
            if discs == SICONOS_BED:
                cases["Repose, sweeps alone", "time", start, discs] = bed.solve(*till, "--solver", "sweeps")
        if "siconos" in peers:
            till = ["--tolerance", TOLERANCE, "--seconds", options.seconds, *begin]
            cases["Siconos NSGS", "time", start, SICONOS_BED] = siconos(beds[SICONOS_BED], *till)
    for discs, bed in beds.items():
        all_sweeps = ["--tolerance", 0, "--most-sweeps", RATE_SWEEPS]
        cases["Repose", "rate", "cold", discs] = bed.solve(*all_sweeps)
        cases["Repose, sweeps alone", "rate", "cold", discs] = bed.solve(*all_sweeps, "--solver", "sweeps")
    if "siconos" in peers:
        cases["Siconos NSGS", "rate", "cold", SICONOS_BED] = siconos(beds[SICONOS_BED], "--iterations", 2 * RATE_SWEEPS)
    if "box2d" in peers:
        cases["Box2D, float", "rate", "", BOX2D_BED] = box2d(peers["box2d"], beds[BOX2D_BED])
    return cases


def rate(case):
    """Million contact-iterations per second."""
    return case["contact_iterations"] / case["cpu_seconds"] / 1e6


def time_per_contact(case):
    return case["cpu_seconds"] / case["contacts"]


def print_times(rounds):
    print(f"CPU time of the solver to an outside residual of {TOLERANCE:g} g dt")
    print(f"(warm: medians of {len(rounds)} rounds; cold: once)")
    print("                         start  discs  contacts  iterations    seconds  us/contact   residual")
    for key, case in rounds[0].items():
        name, kind, start, discs = key
        if kind != "time":
            continue
        seconds = statistics.median(one[key]["cpu_seconds"] for one in rounds if key in one)
        remark = "" if case["residual"] <= TOLERANCE else "   not reached: given up"
        print(
            f"  {name:22s} {start:>5s} {discs:6d} {case['contacts']:9d} {case['iterations']:11d} {seconds:10.4f}"
            f" {seconds / case['contacts'] * 1e6:11.1f}   {case['residual']:.2e}{remark}"
        )


def print_rates(rounds):
    print("\nMillion contact-iterations per CPU second                     min   median      max")
    for key, case in rounds[0].items():
        name, kind, _, discs = key
        if kind != "rate":
            continue
        rates = [rate(one[key]) for one in rounds]
        remark = f"   (rms speed of the bed {case['speed_over_gdt']:.1g} g dt)" if "speed_over_gdt" in case else ""
        print(
            f"  {name:22s} {discs:6d} discs {case['contacts']:6d} contacts"
            f" {min(rates):12.1f} {statistics.median(rates):8.1f} {max(rates):8.1f}{remark}"
        )


def print_bar(what, ratios, bar, comparison=""):
    ratio = statistics.median(ratios)
    print(f"  {what:61s} {comparison}{ratio:8.2f}   bar {bar:g}: {'met' if ratio >= bar else 'NOT met'}")


def print_time_bar(rounds, start, discs):
    own, peer = ("Repose", "time", start, discs), ("Siconos NSGS", "time", start, SICONOS_BED)
    rounds = [one for one in rounds if own in one]
    what = f"{start}: time per contact, Siconos ({SICONOS_BED}) over Repose ({discs})"
    if any(one[own]["residual"] > TOLERANCE for one in rounds):
        print(f"  {what:61s}      none   bar {BARS['time']:g}: NOT met, Repose did not reach the residual")
        return
    given_up = any(one[peer]["residual"] > TOLERANCE for one in rounds)
    ratios = [time_per_contact(one[peer]) / time_per_contact(one[own]) for one in rounds]
    print_bar(what, ratios, BARS["time"], ">" if given_up else " ")


def print_bars(rounds, peers):
    print("\nRatios, medians of those within a round")
    if "siconos" in peers:
        for start in ("warm", "cold"):
            for discs in ROWS:
                print_time_bar(rounds, start, discs)
    for solver in ("Repose", "Repose, sweeps alone"):
        own = (solver, "rate", "cold", BED)
        if "siconos" in peers:
            peer = ("Siconos NSGS", "rate", "cold", SICONOS_BED)
            ratios = [rate(one[own]) / rate(one[peer]) for one in rounds]
            print_bar(f"visits, {solver} ({BED}) over Siconos ({SICONOS_BED})", ratios, BARS["siconos"], " ")
        if "box2d" in peers:
            peer = ("Box2D, float", "rate", "", BOX2D_BED)
            ratios = [rate(one[own]) / rate(one[peer]) for one in rounds]
            print_bar(f"visits, {solver} ({BED}) over Box2D ({BOX2D_BED})", ratios, BARS["box2d"], " ")


def find_peers(build):
    peers = {}
    missing = "is not installed (./dev setup --peers installs it): no comparison with it"
    if all(importlib.util.find_spec(name) for name in ("siconos", "scipy")):
        peers["siconos"] = True
    else:
        print(f"python3-siconos {missing}")
    program = os.path.join(build, "repose_box2d_bench")
    if os.path.exists(program):
        peers["box2d"] = program
    else:
        print(f"libbox2d-dev {missing}")
    return peers


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"), help="build folder")
    parser.add_argument("--rounds", type=int, default=3, help="(default: 3)")
    parser.add_argument("--seconds", type=float, default=60.0, help="CPU time after which a solver is given up (default: 60)")
    options = parser.parse_args()
    if options.rounds < 1:
        parser.error("--rounds must be at least 1")
    peers = find_peers(options.build)
    load = os.getloadavg()[0]
    if load > 0.5:
        print(f"Other programs use this machine (load {load:.1f}).")
    with tempfile.TemporaryDirectory() as folder:
        beds = {discs: Bed(os.path.join(options.build, "repose"), folder, discs) for discs in ROWS}
        rounds = [one_round(beds, options, peers, ("warm", "cold"))]
        rounds += [one_round(beds, options, peers, ("warm",)) for _ in range(1, options.rounds)]
    print_times(rounds)
    print_rates(rounds)
    if peers:
        print_bars(rounds, peers)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Failed as failure:
        sys.exit(f"contact_dynamics.py: {failure}")
