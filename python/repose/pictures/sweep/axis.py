# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The axis that a sweep is drawn over: a numeric parameter, with a line for each combination of the others, or, where
none qualifies, the points by name."""

import re
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Line:
    """Points that differ in the parameter of the axis alone, in ascending order of it."""

    name: str
    rows: np.ndarray  # of the points


@dataclass(frozen=True)
class Axis:
    """Positions of the points of a sweep along the axis."""

    key: "str | None"  # of the parameter; None: points by name
    place: np.ndarray  # (P) along the axis
    lines: "list[Line]"


def axis_of(sweep):
    """The numeric parameter that every point has, that separates the points of each line, and that leaves the fewest
    lines; the points by name where no parameter qualifies."""
    best = None
    for key in sorted(sweep.parameters):
        place = sweep.parameters[key]
        if not np.isfinite(place).all() or len(np.unique(place)) < 2:
            continue
        lines = lines_along(sweep, key)
        if any(len(np.unique(place[line.rows])) < len(line.rows) for line in lines):
            continue
        axis = Axis(key, place, lines)
        if best is None or len(lines) < len(best.lines):
            best = axis
    count = len(sweep.points)
    return best or Axis(None, np.arange(count, dtype=float), [Line("", np.arange(count))])


def lines_along(sweep, key):
    """The points in lines that differ in this key alone."""
    groups = {}
    others = [other for other in sorted(sweep.parameter_text) if other != key]
    for row, name in enumerate(sweep.points):
        rest = name_without(name, key, sweep.parameter_text[key][row])
        texts = tuple(f"{last_part(other)}={sweep.parameter_text[other][row]}" for other in others)
        # the rest of a name holds the other parameters, and the scene where a sweep has several
        groups.setdefault(", ".join(texts) if rest is None else rest, []).append(row)
    place = sweep.parameters[key]
    return [Line(name, np.array(rows)[np.argsort(place[rows])]) for name, rows in groups.items()]


def name_without(name, key, text):
    """The name of a point without its part "friction=0.5"; None where it has no such part."""
    in_name = re.sub(r"[^A-Za-z0-9._=+-]", "-", text)  # as names of points are made, for folders
    part = re.compile(rf"(^|_){re.escape(last_part(key))}={re.escape(in_name)}(?=_|$)")
    return part.sub("", name, count=1).lstrip("_") if part.search(name) else None


def last_part(key):
    """The last part of a dotted key."""
    return key.rsplit(".", 1)[-1]
