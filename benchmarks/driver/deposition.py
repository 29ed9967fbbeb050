# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Deposition of discs, by critical angle and size."""

import json

from .cases import OWN, Case, Contender, Measurement
from .process import Failed, run

# Number of discs, and the width on which they fall. 1000 discs on 32 are packings of Bratberg (2003).
WIDTHS = {1_000: 32, 10_000: 100, 100_000: 316, 1_000_000: 1_000, 10_000_000: 10_000}
ANGLES = (90, 50, 0)


def cases(options):
    for angle in ANGLES:
        for size in options.wanted(WIDTHS, 100_000):
            yield Case(f"deposition {angle} deg", size, "discs", [contender(options, angle, size)])


def contender(options, angle, size):
    def measure():
        name = f"deposit/angle:{angle}/width:{WIDTHS[size]}/discs:{size}"
        least = [] if size >= 1_000_000 else [f"--benchmark_min_time={options.seconds / 2}"]
        command = [options.program("repose_deposition_bench"), f"--benchmark_filter=^{name}(/iterations:[0-9]+)?$"]
        done = run([*command, "--benchmark_format=json", *least])
        if "{" not in done.output:
            raise Failed(f"repose_deposition_bench has no case {name}")
        case = json.loads(done.output[done.output.index("{") :])["benchmarks"][0]
        return Measurement(case["discs"], size / case["discs"], case["peak_mib"])

    return Contender(OWN, measure)
