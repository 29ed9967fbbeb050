# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a sweep is drawn over: a parameter that is a number, in one line per value of the others, or its points."""

import re
from dataclasses import dataclass

import numpy as np

from repose import style

WIDE = 20.0  # ratio of the ends of a logarithmic axis, at least
LONGEST_LINE = 22  # letters of a name before it is broken
UNITS = {"method.critical_angle": "deg"}  # of keys whose unit is that in every scene


@dataclass(frozen=True)
class Line:
    """Points of equal parameters but for the one along the axis, which ascends."""

    name: str
    rows: np.ndarray  # of the points


@dataclass(frozen=True)
class Axis:
    """Where the points of a sweep stand."""

    key: "str | None"  # of the parameter; None: points by name
    place: np.ndarray  # (P) along the axis
    lines: "list[Line]"


def axis_of(sweep):
    """Along the numeric parameter of most values, if every point has it and the others tell the lines apart."""
    best = None
    for key in sorted(sweep.parameters):
        place = sweep.parameters[key]
        if not np.isfinite(place).all() or len(np.unique(place)) < 2:
            continue
        lines = _lines(sweep, key)
        if any(len(np.unique(place[line.rows])) < len(line.rows) for line in lines):
            continue
        axis = Axis(key, place, lines)
        if best is None or len(lines) < len(best.lines):
            best = axis
    count = len(sweep.points)
    return best or Axis(None, np.arange(count, dtype=float), [Line("", np.arange(count))])


def _lines(sweep, key):
    groups = {}
    others = [other for other in sorted(sweep.parameter_text) if other != key]
    for row, name in enumerate(sweep.points):
        rest = without_part(name, key, sweep.parameter_text[key][row])
        texts = tuple(f"{short(other)}={sweep.parameter_text[other][row]}" for other in others)
        # the rest of a name holds what was varied and what only its own scene has
        groups.setdefault(", ".join(texts) if rest is None else rest, []).append(row)
    place = sweep.parameters[key]
    return [Line(name, np.array(rows)[np.argsort(place[rows])]) for name, rows in groups.items()]


def without_part(name, key, text):
    """The name of a point without its part "friction=0.5"; None if it has no such part."""
    part = re.compile(rf"(^|_){re.escape(short(key))}={re.escape(text)}(?=_|$)")
    return part.sub("", name, count=1).lstrip("_") if part.search(name) else None


def short(key):
    """The last part of a dotted key."""
    return key.rsplit(".", 1)[-1]


def key_label(key):
    """A key as the label of an axis, with its unit if that is the same in every scene."""
    return f"{key} ({UNITS[key]})" if key in UNITS else key


def draw_measure(axes, axis, mean, error, place=None, values=None):
    """Means (P) with their errors over the axis; as faint dots the members' `values` (K), of the points `place` (K)."""
    for k, line in enumerate(axis.lines):
        colour, marker = style.SERIES[k % len(style.SERIES)], style.MARKERS[k % len(style.MARKERS)]
        look = dict(color=colour, marker=marker, markersize=4, elinewidth=1.0, capsize=2, label=line.name)
        at, height, bar = axis.place[line.rows], mean[line.rows], np.nan_to_num(error[line.rows])
        if values is not None:
            mine = np.isin(place, line.rows)
            dots = _oriented(axis, axis.place[place[mine]], values[mine])
            axes.plot(*dots, "o", color=colour, markersize=2.4, alpha=0.3, markeredgewidth=0, zorder=1.5)
        if axis.key is None:
            axes.errorbar(height, at, xerr=bar, linestyle="none", **look)
        else:
            axes.errorbar(at, height, yerr=bar, linewidth=0.7, **look)


def label_axis(axes, axis, sweep, value_label, names=True):
    """Labels of both axes; points stand from the top to the bottom, `names` beside the axes or not."""
    if axis.key is not None:
        low, high = axis.place.min(), axis.place.max()
        if low > 0.0 and high / low >= WIDE:
            axes.set_xscale("log")
        else:
            axes.locator_params(axis="x", nbins=5, steps=[1, 2, 5, 10])
        axes.set_xlabel(key_label(axis.key))
        axes.set_ylabel(value_label)
        return
    axes.set_ylim(len(sweep.points) - 0.5, -0.5)
    axes.set_yticks(axis.place, [broken(name) for name in sweep.points] if names else [""] * len(sweep.points))
    axes.grid(axis="y", color=style.FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    axes.set_xlabel(value_label)


def line_at(axes, axis, value):
    """A line at a value of the measure."""
    draw = axes.axvline if axis.key is None else axes.axhline
    draw(value, color=style.GREY, linewidth=0.8, linestyle="--", zorder=0.5)


def broken(name, longest=LONGEST_LINE):
    """The name of a point in lines that are not longer, where it can be broken: before an underscore."""
    lines = []
    for part in re.split(r"(?=_)", name):
        if lines and len(lines[-1]) + len(part) <= longest:
            lines[-1] += part
        else:
            lines.append(part)
    return "\n".join(lines)


def points_height(axis, sweep, height):
    """Inches that the axes need: `height` along a parameter, a row for each point by name."""
    return height if axis.key else max(1.2, 0.6 + sum(0.12 + 0.12 * len(broken(n).split("\n")) for n in sweep.points))


def add_legend(figure, axes, axis, top):
    """Names of the lines, if there is more than one, in rows below `top` [inch] from the upper edge; their height."""
    if len(axis.lines) < 2:
        return 0.0
    width, height = figure.get_size_inches()
    longest = max(len(line.name) for line in axis.lines)
    columns = max(1, min(len(axis.lines), int((width - 0.2) / (0.45 + 0.068 * longest))))
    handles, labels = axes.get_legend_handles_labels()
    at = (0.08 / width, 1.0 - top / height)
    figure.legend(handles, labels, loc="upper left", bbox_to_anchor=at, ncol=columns)
    return 0.06 + 0.15 * -(-len(axis.lines) // columns)


def _oriented(axis, place, values):
    return (values, place) if axis.key is None else (place, values)
