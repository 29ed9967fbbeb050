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


def over_peer(rows, method, size, peer, instructions=None):
    row = find(rows, method, size, instructions)
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


# Least ratios to LAMMPS by instruction set, method and grains.
OVER_LAMMPS = {
    "avx512": {"soft 2D": {10_000: 6.5, 100_000: 7.0, 1_000_000: 10.0}, "soft 3D": {10_000: 3.0, 100_000: 2.5}},
    "avx2": {"soft 2D": {10_000: 5.0, 100_000: 5.0, 1_000_000: 8.0}, "soft 3D": {10_000: 2.3, 100_000: 2.1}},
}


def rate(rows, method, size):
    """Median rate in millions a second."""
    row = find(rows, method, size)
    return statistics.median(one.rate for one in row.measured) / 1e6 if row else None


def over_scalar(rows, method, size):
    row, scalar = find(rows, method, size), find(rows, method, size, "scalar")
    return statistics.median(ratios(row, scalar)) if row and scalar else None


def threads_gain(rows, method, size, threads):
    """Rate with some threads over that with one, by the best instruction set."""
    one = find(rows, method, size)
    more = [
        row
        for row in rows
        if one and row.case == one.case and row.contender.threads == threads and row.contender.program == OWN
    ]
    return statistics.median(ratios(more[-1], one)) if more else None


def wanted(rows):
    """(what, value, bar, kind) of every bar; the value is None where it has not been measured."""
    for instructions, methods in OVER_LAMMPS.items():
        for method, by_size in methods.items():
            for size, bar in by_size.items():
                what = f"{method}, {size} grains, {instructions}: rate over LAMMPS"
                yield what, over_peer(rows, method, size, "LAMMPS", instructions), bar, "least"
    law = "soft 2D, continuous law"
    yield f"{law}: rate over the scalar reference", over_scalar(rows, law, 10_000), 4.5, "least"
    for size in (10_000, 100_000):
        what = f"soft 2D, {size} grains: two threads over one"
        yield what, threads_gain(rows, "soft 2D", size, 2), 1.85, "least"
    what = "contact dynamics, 10 000 grains: two threads over one"
    yield what, threads_gain(rows, "contact dynamics, steps", 10_000, 2), 1.6, "least"
    for size, bar in ((10_000, 90.0), (1_000_000, 110.0)):
        grains = rate(rows, "new pair list 2D", size)
        yield f"new pair list, {size} grains [ns per grain]", 1e3 / grains if grains else None, bar, "most"
    what = "soft 2D: cost of a grain-step, 1e6 over 1e4"
    yield what, growth(rows, "soft 2D", 10_000, 1_000_000), 1.35, "most"
    yield "soft 2D, 1e6 grains: peak memory [MiB]", memory(rows, "soft 2D", 1_000_000), 500, "most"
    yield "paper heap: CPU time over that of LAMMPS", heap_time(rows), 0.2, "most"
    for angle, bar in ((90, 8.0), (0, 4.0)):
        what = f"deposition at {angle} deg, 1e7 discs [million a second]"
        yield what, rate(rows, f"deposition {angle} deg", 10_000_000), bar, "least"


def check(rows):
    """[(what, value, bar, whether it is met)] of what has been measured."""
    return [
        (what, value, bar, value >= bar if kind == "least" else value <= bar)
        for what, value, bar, kind in wanted(rows)
        if value is not None
    ]
