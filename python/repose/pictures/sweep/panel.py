# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Panels that show a measure over the axis of a sweep."""

import re
import textwrap

import numpy as np

from repose import style
from repose.errors import NotDrawn
from repose.pictures.sweep.key_label import key_label, meaning_of

CAPTION = "mean ± standard error over the members of a point; faint: single members"
TOP = 0.39  # inch of a caption and the meaning of the axis
LETTERS_PER_INCH = 19  # of a caption
WIDE = 20.0  # least ratio of the ends of a logarithmic axis
LONGEST_LINE = 22  # letters of a name in one line


def has_measure(sweep, key):
    """Whether some point has a mean of the measure."""
    return key in sweep.measures and bool(np.isfinite(sweep.measures[key]["mean"]).any())


def draw_measure(axes, axis, sweep, key):
    """Means and standard errors of a measure, and its values of all members; NotDrawn if no point has it."""
    if not has_measure(sweep, key):
        raise NotDrawn(f"no member has {key}")
    measure = sweep.measures[key]
    draw_means(axes, axis, measure["mean"], measure["error"], sweep.members["point"], sweep.values.get(key))


def draw_means(axes, axis, mean, error, place=None, values=None):
    """Means (P) with their errors; with `values` (K) of the members also faint dots, at the points `place` (K)."""
    for k, line in enumerate(axis.lines):
        colour, marker = style.SERIES[k % len(style.SERIES)], style.MARKERS[k % len(style.MARKERS)]
        drawing = dict(color=colour, marker=marker, markersize=4, elinewidth=1.0, capsize=2, label=line.name)
        at, height, bar = axis.place[line.rows], mean[line.rows], np.nan_to_num(error[line.rows])
        if values is not None:
            own = np.isin(place, line.rows)
            dots = _in_order_of_axes(axis, axis.place[place[own]], values[own])
            axes.plot(*dots, "o", color=style.pale(colour, 0.4), markersize=2.4, markeredgewidth=0, zorder=1.5)
        if axis.key is None:
            axes.errorbar(height, at, xerr=bar, linestyle="none", **drawing)
        else:
            axes.errorbar(at, height, yerr=bar, linewidth=0.7, **drawing)


def label_axes(axes, axis, sweep, value_label, names=True):
    """Labels of both axes. Points by name run from top to bottom; `names` writes their names beside the axes."""
    if axis.key is not None:
        if is_geometric(axis.place):
            axes.set_xscale("log")
        else:
            axes.locator_params(axis="x", nbins=5, steps=[1, 2, 5, 10])
        axes.set_xlabel(key_label(axis.key, sweep.key_comments, style.units_of(sweep)))
        axes.set_ylabel(value_label)
        return
    axes.set_ylim(len(sweep.points) - 0.5, -0.5)
    labels = [in_lines(name) for name in sweep.points] if names else [""] * len(sweep.points)
    axes.set_yticks(axis.place, labels)
    axes.grid(axis="y", color=style.FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    axes.set_xlabel(value_label)


def is_geometric(place):
    """Whether places span a wide range and follow each other more evenly by ratios than by differences."""
    steps = np.unique(place)
    if len(steps) < 3 or steps[0] <= 0.0 or steps[-1] < WIDE * steps[0]:
        return False
    ratios, differences = np.diff(np.log(steps)), np.diff(steps)
    return ratios.std() / ratios.mean() < differences.std() / differences.mean()


def caption(figure, axis, sweep, text):
    """The caption, and below it the meaning of the parameter of the axis, as far as the figure is wide."""
    width = max(20, int(LETTERS_PER_INCH * figure.get_figwidth()))
    meaning = meaning_of(axis.key, sweep.key_comments) if axis.key else ""
    style.caption(figure, f"{text}\n{textwrap.shorten(meaning, width, placeholder=' ...')}".rstrip())


def mark_value(axes, axis, value):
    """A dashed line at a value of the measure."""
    draw = axes.axvline if axis.key is None else axes.axhline
    draw(value, color=style.GREY, linewidth=0.8, linestyle="--", zorder=0.5)


def in_lines(name, longest=LONGEST_LINE):
    """The name of a point, broken before underscores into lines of at most `longest` letters where that is possible."""
    lines = []
    for part in re.split(r"(?=_)", name):
        if lines and len(lines[-1]) + len(part) <= longest:
            lines[-1] += part
        else:
            lines.append(part)
    return "\n".join(lines)


def panel_height(axis, sweep, height):
    """Inches that a panel needs: `height` along a parameter, a row for each point by name."""
    return height if axis.key else max(1.2, 0.6 + sum(0.12 + 0.12 * len(in_lines(n).split("\n")) for n in sweep.points))


def add_legend(figure, axes, axis, top):
    """A legend of the lines, if there are several, `top` [inch] below the upper edge; its height [inch]."""
    if len(axis.lines) < 2:
        return 0.0
    width, height = figure.get_size_inches()
    longest = max(len(line.name) for line in axis.lines)
    columns = max(1, min(len(axis.lines), int((width - 0.2) / (0.45 + 0.068 * longest))))
    handles, labels = axes.get_legend_handles_labels()
    at = (0.08 / width, 1.0 - top / height)
    figure.legend(handles, labels, loc="upper left", bbox_to_anchor=at, ncol=columns)
    return 0.06 + 0.15 * -(-len(axis.lines) // columns)


def _in_order_of_axes(axis, place, values):
    """(x, y): points by name stand along y."""
    return (values, place) if axis.key is None else (place, values)
