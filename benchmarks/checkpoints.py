#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the cost of checkpoints and of the time series: runs one scene with and without them, alternately.

Prints, for each round, the ratio of the CPU times (which other work on the machine hardly affects, but which exclude
waiting for the disk) and of the wall times. Exit status 1 if the runs do not end with the same bits.

usage: benchmarks/checkpoints.py [--program FILE] [--scene FILE] [--time T] [--rounds N]
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SELDOM = "output.series=1e9"  # only the last row
WITHOUT = "without"
VARIANTS = {
    WITHOUT: ["output.checkpoint=0", SELDOM],
    "series": ["output.checkpoint=0"],
    "defaults": [],
    "checkpoint every second": ["output.checkpoint=1", SELDOM],
}


def timed(arguments, settings, out):
    """(CPU seconds, seconds, hash of the final state) of one run."""
    command = [arguments.program, "run", arguments.scene, "--out", str(out), "--threads", "1", "--quiet"]
    for setting in [f"stop.time={arguments.time}", "output.track=0", "output.frames=0", *settings]:
        command += ["--set", setting]
    start = time.monotonic()
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.monotonic() - start
    if status != 0:
        sys.exit(f"failed: {' '.join(command)}")
    return usage.ru_utime + usage.ru_stime, seconds, json.loads((out / "summary.json").read_text())["state_hash"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/repose"))
    parser.add_argument("--scene", default=str(ROOT / "examples/heap.toml"))
    parser.add_argument("--time", type=float, default=700.0, help="simulated time at which the run stops")
    parser.add_argument("--rounds", type=int, default=5)
    arguments = parser.parse_args()
    times = {name: [] for name in VARIANTS}
    hashes = set()
    with tempfile.TemporaryDirectory() as folder:
        for round_number in range(arguments.rounds):
            names = list(VARIANTS)
            for name in names if round_number % 2 == 0 else reversed(names):
                cpu, seconds, state = timed(arguments, VARIANTS[name], Path(folder) / f"{name}-{round_number}")
                times[name].append((cpu, seconds))
                hashes.add(state)
    cpu, seconds = (statistics.median(column) for column in zip(*times[WITHOUT]))
    print(f"{Path(arguments.scene).name} to time {arguments.time:g}, {arguments.rounds} rounds; without checkpoints and"
          f" series {cpu:.1f} s of CPU time, {seconds:.1f} s of the clock")
    for k, kind in enumerate(("CPU", "clock")):
        print(f"  {kind + ' time over that without':32}    min   median      max")
        for name in list(VARIANTS)[1:]:
            ratios = [one[k] / base[k] for one, base in zip(times[name], times[WITHOUT])]
            print(f"    {name:30} {min(ratios):6.3f}   {statistics.median(ratios):6.3f}   {max(ratios):6.3f}")
    print("all runs end in the same bits" if len(hashes) == 1 else f"the runs end in different states: {sorted(hashes)}")
    return 0 if len(hashes) == 1 else 1


if __name__ == "__main__":
    sys.exit(main())
