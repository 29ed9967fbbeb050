#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures how the cost of lattice piles grows with their size: hybrid method, 30 degrees, base pinned in x.

Each pile is brought to equilibrium (method.relax) and then takes ten steps. Prints the number of discs, the iterations of
the solver, the largest residual in grain weights, the CPU seconds, and the exponent of the growth from the pile before.

usage: benchmarks/hybrid_piles.py [--program FILE] [--stiffness K] [--widths N ...]
"""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def pile(arguments, width, out):
    """(summary, CPU seconds) of a pile `width` discs wide."""
    step = 2.0 / math.sqrt(arguments.stiffness)
    settings = [f"method.stiffness={arguments.stiffness}", "method.pin_base=true", "source.slope=30"]
    settings += [f"source.base_count={width}", f"box.half_width={width}", f"stop.time={10.0 * step}", f"output.series={step}"]
    command = [arguments.program, "run", str(ROOT / "examples/pile-hybrid.toml"), "--out", str(out), "--quiet"]
    for setting in [*settings, "output.frames=0"]:
        command += ["--set", setting]
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"failed: {' '.join(command)}")
    return json.loads((out / "summary.json").read_text()), usage.ru_utime + usage.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/repose"))
    parser.add_argument("--stiffness", type=float, default=1e6, help="of contacts [m g / d]")
    parser.add_argument("--widths", type=int, nargs="+", default=[45, 90, 180, 360, 543], help="discs in the lowest row")
    arguments = parser.parse_args()
    print(f"{'discs':>8}{'iterations':>12}{'residual':>12}{'CPU seconds':>14}{'exponent':>10}")
    before = None
    with tempfile.TemporaryDirectory() as folder:
        for width in arguments.widths:
            found, seconds = pile(arguments, width, Path(folder) / str(width))
            discs, account = found["grains"], found["collisions"]
            exponent = math.log(seconds / before[1]) / math.log(discs / before[0]) if before else None
            growth = f"{exponent:10.2f}" if exponent is not None else ""
            print(f"{discs:8}{account['iterations']:12}{account['worst_residual']:12.1e}{seconds:14.2f}{growth}", flush=True)
            before = discs, seconds


if __name__ == "__main__":
    main()
