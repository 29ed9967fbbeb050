#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures Repose beside its installed peers and prints one table; see docs/performance.md.

Called by ./dev bench. Writes build/bench/bench.json and bench.md. Slowness and missing peers are no errors: the exit status
is 1 only if something fails to run, or if --check-physics finds that two programs differ.
"""

import argparse
import importlib.util
import json
import os
import sys
from datetime import UTC, datetime

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver import bars, deposition, heap, lammps, machine, physics, rounds, soft, table, yade  # noqa: E402
from driver.cases import Options  # noqa: E402
from driver.process import Failed  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
METHODS = ("soft", "heap", "contact-dynamics", "deposition")


def say(text):
    print(f"  {text}", file=sys.stderr, flush=True)


def sizes(text):
    return [int(float(number)) for number in text.split(",")]


def arguments():
    parser = argparse.ArgumentParser(prog="./dev bench", description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, help="interleaved rounds (default: 5; with --quick 2)")
    parser.add_argument("--quick", action="store_true", help="sizes to 10 000 and short measurements: about a minute")
    parser.add_argument("--only", choices=METHODS, help="one method alone")
    parser.add_argument("--sizes", type=sizes, metavar="N,N", help="these sizes alone, such as 1e4,1e6; no heap")
    parser.add_argument("--heap", action="store_true", help="the whole heap of the paper, minutes a round, not its start")
    parser.add_argument("--check-physics", action="store_true", help="only compare what Repose and LAMMPS compute")
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"), help="folder of the programs")
    options = parser.parse_args()
    if options.rounds is None:
        options.rounds = 2 if options.quick else 5
    if options.rounds < 1:
        parser.error("--rounds must be at least 1")
    return options


def cases(wanted, options):
    """All cases that are wanted; says which peers are missing."""
    methods = [wanted.only] if wanted.only else METHODS
    if {"soft", "heap"} & set(methods) and not lammps.program():
        print(lammps.MISSING)
    if "soft" in methods:
        if not yade.program():
            print(yade.MISSING)
        yield from soft.cases(options)
    if "heap" in methods and options.sizes is None:
        yield from heap.cases(options, wanted.heap)
    if "contact-dynamics" in methods:
        if importlib.util.find_spec("h5py"):
            from driver import rigid

            yield from rigid.cases(options)
        else:
            print("python3-h5py is not installed (./dev setup installs it): no figures of contact dynamics")
    if "deposition" in methods:
        yield from deposition.cases(options)


def main():
    wanted = arguments()
    folder = os.path.join(ROOT, "build", "bench")
    os.makedirs(folder, exist_ok=True)
    options = Options(wanted.build, folder, 0.2 if wanted.quick else 2.0, wanted.sizes, wanted.quick, say)
    if wanted.check_physics:
        if not lammps.program():
            print(lammps.MISSING)
            return 0
        return 0 if physics.compare(options) else 1
    about = machine.describe() | {"date": datetime.now(UTC).isoformat(timespec="seconds"), "rounds": wanted.rounds}
    rows = rounds.measure(list(cases(wanted, options)), wanted.rounds, say)
    found = bars.check(rows)
    sets = ", ".join(about["instruction_sets"])
    head = (
        f"{about['processor']}, {about['threads']} threads, {sets}; load at the start {about['load']};"
        f" {wanted.rounds} interleaved rounds: median (least-largest)"
    )
    said = "\n\n".join(filter(None, [head, table.text(rows), table.bars_text(found)])) + "\n"
    print(said)
    with open(os.path.join(folder, "bench.md"), "w", encoding="utf-8") as file:
        file.write(said)
    names = ("what", "value", "bar", "met")
    with open(os.path.join(folder, "bench.json"), "w", encoding="utf-8") as file:
        everything = {"machine": about, "rows": table.json_of(rows), "bars": [dict(zip(names, bar)) for bar in found]}
        json.dump(everything, file, indent=1)
    print(f"also in {os.path.relpath(folder)}: bench.json, bench.md")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Failed as failure:
        sys.exit(f"bench: {failure}")
