# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Panels of measures over a parameter or over another measure, and of measures of some points as bars."""

import numpy as np

from repose import style
from repose.errors import NotDrawn


def draw(axes, study, panel):
    """A series of means with standard errors for each pattern of points."""
    measure = _measure(study, panel["measure"])
    over = panel.get("over")
    for k, series in enumerate(panel.get("series", [{"points": "*"}])):
        rows = study.rows(series["points"])
        place, place_error = _place(study, over, rows)
        order = np.argsort(place)
        rows, place = np.array(rows)[order], place[order]
        colour, marker = style.SERIES[k % len(style.SERIES)], style.MARKERS[k % len(style.MARKERS)]
        drawing = dict(color=colour, marker=marker, markersize=3.2, elinewidth=0.7, linewidth=0.7)
        if place_error is not None:
            drawing |= dict(xerr=np.nan_to_num(place_error[order]), linestyle="none")
        error = np.nan_to_num(measure["error"][rows])
        drawn = axes.errorbar(place, measure["mean"][rows], error, label=series.get("label", ""), **drawing)
        if k % 2:  # points below it stay visible
            drawn[0].set_markerfacecolor("white")
    for line in panel.get("lines", []):
        axes.axhline(line["value"], color=style.GREY, linewidth=0.8, linestyle="--", zorder=0.5)
        axes.annotate(line.get("label", ""), (1.0, line["value"]), xycoords=("axes fraction", "data"), ha="right",
                      va="bottom", fontsize=6.5, color=style.GREY)  # fmt: skip
    if panel.get("log"):
        axes.set_xscale("log")
    axes.set_xlabel(panel.get("xlabel", over or ""))
    axes.set_ylabel(panel.get("ylabel", panel["measure"]))
    if any("label" in series for series in panel.get("series", [])):
        axes.legend(loc="best")


def draw_bars(axes, study, panel):
    """Bars of several measures, grouped by measure, one of each group for each point."""
    points = panel["points"]
    measures = panel["measures"]
    width = 0.8 / len(points)
    for k, (point, label) in enumerate(zip(points, panel.get("labels", points))):
        row = study.row(point)
        tables = [_measure(study, name) for name in measures]
        mean, error = (np.nan_to_num([table[part][row] for table in tables]) for part in ("mean", "error"))
        place = np.arange(len(measures)) + (k - 0.5 * (len(points) - 1)) * width
        colour = style.pale(style.SERIES[k % len(style.SERIES)], 0.75)
        axes.bar(place, mean, width, yerr=error, color=colour, error_kw=dict(elinewidth=0.7), label=label)
    axes.set_xticks(range(len(measures)), panel.get("ticks", measures))
    axes.set_ylabel(panel.get("ylabel", ""))
    axes.legend(loc="best")


def _measure(study, name):
    if name not in study.sweep.measures:
        raise NotDrawn(f"no member has {name}")
    return study.sweep.measures[name]


def _place(study, over, rows):
    """Places of points along the axis, with their errors where it is a measure."""
    if over is None:
        return np.arange(len(rows), dtype=float), None
    if over in study.sweep.parameters:
        place = study.sweep.parameters[over][rows]
        if not np.isfinite(place).any():  # a vector, such as a velocity: its last component
            place = np.array([float(study.sweep.parameter_text[over][row].strip("[] ").split(",")[-1]) for row in rows])
        return place, None
    measure = _measure(study, over)
    return measure["mean"][rows], measure["error"][rows]
