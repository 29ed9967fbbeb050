# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The bars that the figures are held against. Missing one is no error."""

import statistics

from .cases import OWN
from .rounds import peers_of, ratios


def find(rows, method, size, instructions=None):
    """The row of Repose on one thread: the last one, by the best instruction set, if none is named."""
    found = [
        row
        for row in rows
        if row.case.method == method
        and row.case.size == size
        and row.contender.program == OWN
        and row.contender.threads == 1
        and instructions in (None, row.contender.instructions)
    ]
    return found[-1] if found else None


def over_peer(rows, method, size, peer):
    row = find(rows, method, size)
    other = peers_of(row, rows).get(peer) if row else None
    return statistics.median(ratios(row, other)) if other else None


def heap_time(rows):
    """CPU time over that of LAMMPS, for the whole heap alone: at its start the cost of a step is that of few grains."""
    ratio = over_peer(rows, "paper heap", 1_334, "LAMMPS")
    return 1 / ratio if ratio else None


def growth(rows, method, small, large):
    """Cost of a unit of work at a large size over that at a small one, in the same round."""
    few, many = find(rows, method, small), find(rows, method, large)
    return statistics.median(ratios(few, many)) if few and many else None


def memory(rows, method, size):
    row = find(rows, method, size)
    return max(one.peak_mib for one in row.measured) if row else None


def check(rows):
    """[(what, value, bar, whether it is met)] of what has been measured."""
    found = [
        ("soft 2D, 10 000 grains: rate over LAMMPS", over_peer(rows, "soft 2D", 10_000, "LAMMPS"), 2.5, "least"),
        ("soft 2D: cost of a grain-step, 1e6 over 1e4", growth(rows, "soft 2D", 10_000, 1_000_000), 1.35, "most"),
        ("soft 2D, 1e6 grains: peak memory [MiB]", memory(rows, "soft 2D", 1_000_000), 500, "most"),
        ("paper heap: CPU time over that of LAMMPS", heap_time(rows), 0.2, "most"),
    ]
    return [
        (what, value, bar, value >= bar if kind == "least" else value <= bar)
        for what, value, bar, kind in found
        if value is not None
    ]
