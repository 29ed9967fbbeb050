#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what five grains of 50 diameters cost beside 3000 small ones: runs the bed with and without them, alternately,
and prints the ratio of the times of pair lists and steps (`repose run --profile`).

usage: benchmarks/large_grains.py [--program FILE] [--rounds N]
"""

import argparse
import json
import math
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COLUMNS, ROWS, LARGE, SIZE = 60, 50, 5, 50.0
STAGES = ("pair lists", "forces and motion")
SCENE = """[method]
velocities = "synchronised"      # as sizes of such a range ask for; so both runs have the same kernel
kind = "soft"
[contact]
friction = 0.5
normal = { law = "hooke", stiffness = 1e4, damping = 0.5 }
tangential = { law = "linear", stiffness = 5e3, damping = 0.2 }
[start]
from = "grains.csv"
[base]
kind = "plane"
[box]
half_width = 400.0
[stop]
time = 10.0
[output]
frames = 0.0
"""


def grains(with_large):
    """A triangular bed with a gap between grains, which falls together; large grains stand apart on the floor."""
    lines = ["x,y,diameter"]
    for row in range(ROWS):
        for column in range(COLUMNS):
            x = column + 0.5 * (row % 2) + 0.02 * math.sin(37.0 * column + 11.0 * row)
            lines.append(f"{x:.6f},{0.51 + 0.9 * row:.6f},1")
    if with_large:
        lines += [f"{COLUMNS + SIZE * (k + 0.6):.6f},{0.5 * SIZE + 0.01},{SIZE}" for k in range(LARGE)]
    return "\n".join(lines) + "\n"


def seconds(program, folder, with_large):
    """Seconds of pair lists and steps of one run."""
    folder.mkdir()
    (folder / "grains.csv").write_text(grains(with_large))
    (folder / "scene.toml").write_text(SCENE)
    command = [program, "run", "scene.toml", "--out", "out", "--threads", "1", "--quiet", "--profile"]
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"failed: {' '.join(command)}: {result.stderr}")
    stages = json.loads((folder / "out/profile.json").read_text())["stages"]
    return sum(stage["seconds"] for stage in stages if stage["name"] in STAGES)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/repose"))
    parser.add_argument("--rounds", type=int, default=5)
    arguments = parser.parse_args()
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        for k in range(arguments.rounds):
            small, both = (seconds(arguments.program, Path(folder) / f"{k}-{large}", large) for large in (False, True))
            ratios.append(both / small)
    print(f"{COLUMNS * ROWS} grains with {LARGE} of {SIZE:g} diameters over those alone, {arguments.rounds} rounds:"
          f" {statistics.median(ratios):.2f} ({min(ratios):.2f}-{max(ratios):.2f})")


if __name__ == "__main__":
    main()
