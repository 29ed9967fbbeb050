# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures of packings over what a sweep varies, and over their solid fraction (Bratberg 2003, paper one, Figs. 2, 7, 8,
10 and 11 to 14)."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.not_drawn import NotDrawn
from repose.pictures.sweep.axis import axis_of
from repose.pictures.sweep.measured import has

MEASURES = (
    ("solid_fraction", "solid fraction ρ"),
    ("coordination", "coordination z"),
    ("anisotropy", "anisotropy a"),
    ("fabric_direction_deg", "direction θ_f (deg)"),
)
SHARES = tuple(f"packing.P_{q}" for q in range(7))
COLOURS = (*style.SERIES, style.INK)
MARKERS = (*style.MARKERS, "X")
MANY = 24  # points of a line whose markers are left small


def draw(sweep):
    """Two figures: over the parameter, and over the solid fraction."""
    axis = axis_of(sweep)
    if axis.key is None or not all(has(sweep, key) for key, _ in MEASURES):
        raise NotDrawn("no packings measured over a parameter that is a number")
    density = sweep.measures["solid_fraction"]
    return [
        _figure(sweep, axis, axis.place, None, axis.key, MEASURES),
        _figure(sweep, axis, density["mean"], density["error"], "solid fraction ρ", MEASURES[1:]),
    ]


def _figure(sweep, axis, place, place_error, place_label, panels):
    several = len(axis.lines) > 1
    count = len(panels) + has(sweep, SHARES[2])
    rows = -(-count // 2)
    figure = Figure(figsize=(6.3, 2.15 * rows + 0.3 + 0.2 * several))
    grid = figure.subplots(rows, 2, squeeze=False).ravel()
    for axes, (key, label) in zip(grid, panels):
        for k, line in enumerate(axis.lines):
            _points(axes, place, place_error, sweep.measures[key], line.rows, k, line.name)
        axes.set(xlabel=place_label, ylabel=label)
    if count > len(panels):
        axes = grid[len(panels)]
        for q, key in enumerate(SHARES):
            if has(sweep, key) and np.nanmax(sweep.measures[key]["mean"]) > 0.005:
                _points(axes, place, place_error, sweep.measures[key], axis.lines[0].rows, q, f"{q}{'+' if q == 6 else ''}")
        axes.set(xlabel=place_label, ylabel="share P_q with q contacts")
        axes.legend(loc="upper center", ncol=4, bbox_to_anchor=(0.5, 1.16), handlelength=0.8, columnspacing=0.8)
    for axes in grid[count:]:
        axes.remove()
    if several:
        handles, labels = figure.axes[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="lower center", ncol=min(4, len(labels)))
    figure.tight_layout(pad=0.4, h_pad=1.2, w_pad=1.0, rect=(0.0, 0.05 * several, 1.0, 0.96))
    style.caption(figure, "mean ± standard error of the members of a point")
    return figure


def _points(axes, place, place_error, measure, rows, k, name):
    colour, marker = COLOURS[k % len(COLOURS)], MARKERS[k % len(MARKERS)]
    bars = dict(yerr=np.nan_to_num(measure["error"][rows]))
    if place_error is not None:
        bars["xerr"] = np.nan_to_num(place_error[rows])
    size = 2.2 if len(rows) > MANY else 4.0
    axes.errorbar(
        place[rows], measure["mean"][rows], fmt=marker, color=colour, markersize=size, elinewidth=0.7, label=name, **bars
    )
