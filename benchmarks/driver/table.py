# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The one table of all figures, as text, Markdown and JSON."""

import statistics

from .rounds import one_thread_of, peers_of, ratios, reference_of

PEERS = ("LAMMPS", "YADE", "Siconos", "Box2D")


def short(size):
    """1e3, 1e4, ...; other sizes in full."""
    power = len(str(size)) - 1
    return f"1e{power}" if size == 10**power else str(size)


def spread(values, scale=1.0, digits=3):
    values = [value * scale for value in values]
    median = f"{statistics.median(values):.{digits}g}"
    return median if len(values) == 1 else f"{median} ({min(values):.{digits}g}-{max(values):.{digits}g})"


def compared_with(row, rows):
    """{name: row} of all that a row is a ratio to.

    With more than one thread a rate is one of the clock: it is compared with that of one thread, which has the
    processor to itself, but not with peers.
    """
    if row.contender.threads > 1:
        found = {"1 thread": one_thread_of(row, rows)}
    else:
        found = {"scalar": reference_of(row, rows)} | peers_of(row, rows)
    return {name: other for name, other in found.items() if other is not None}


def header(rows):
    peers = [name for name in PEERS if any(row.contender.program == name for row in rows)]
    ratio_to = ["scalar", "1 thread", *peers]
    used = [name for name in ratio_to if any(name in compared_with(row, rows) for row in rows)]
    return used, ["method", "size", "program", "set", "threads", "million/s", *(f"x {name}" for name in used), "MiB"]


def cells(row, rows, used):
    contender = row.contender
    others = compared_with(row, rows)
    memory = max(one.peak_mib for one in row.measured)
    return [
        row.case.method,
        short(row.case.size),
        contender.program,
        contender.instructions,
        str(contender.threads),
        spread(row.rates, 1e-6),
        *(spread(ratios(row, others[name])) if name in others else "" for name in used),
        f"{memory:.0f}" if memory else "",
    ]


def text(rows):
    """Markdown, whose columns are as wide as their widest cell, so that it reads well on a terminal too."""
    used, names = header(rows)
    lines = [names, *(cells(row, rows, used) for row in rows)]
    for before, line in zip(reversed(lines[1:-1]), reversed(lines[2:])):
        if line[:2] == before[:2]:
            line[0] = line[1] = ""
    widths = [max(len(line[k]) for line in lines) for k in range(len(names))]
    left = (0, 2, 3)
    lines.insert(1, ["-" * width if k in left else "-" * (width - 1) + ":" for k, width in enumerate(widths)])
    return "\n".join(
        "| " + " | ".join(c.ljust(w) if k in left else c.rjust(w) for k, (c, w) in enumerate(zip(line, widths))) + " |"
        for line in lines
    )


def bars_text(bars):
    if not bars:
        return ""
    rows = [f"| {what} | {value:.3g} | {bar:g} | {'met' if met else 'NOT met'} |" for what, value, bar, met in bars]
    return "\n".join(["| bar | measured | bar | |", "|---|---:|---:|---|", *rows])


def json_of(rows):
    """Plain numbers of every row: rates of all rounds, their median and spread, ratios by name."""
    all_rows = []
    for row in rows:
        contender = row.contender
        all_rows.append(
            {
                "method": row.case.method,
                "size": row.case.size,
                "unit": row.case.unit + (" per CPU second" if contender.threads == 1 else " per second of the clock"),
                "program": contender.program,
                "instructions": contender.instructions,
                "threads": contender.threads,
                "rates": row.rates,
                "rate": summary(row.rates),
                "ratio_to": {name: summary(ratios(row, o)) for name, o in compared_with(row, rows).items()},
                "seconds": [one.seconds for one in row.measured],
                "peak_mib": max(one.peak_mib for one in row.measured),
                "more": [one.more for one in row.measured],
            }
        )
    return all_rows


def summary(values):
    return {"median": statistics.median(values), "min": min(values), "max": max(values)}
