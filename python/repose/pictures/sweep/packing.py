# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures of packings over what a sweep varies, and over their solid fraction (Bratberg 2003, paper one, Figs. 2, 6 to 8,
10 and 11 to 14), with a series of points for each set of the other parameters, or for each scene."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.not_drawn import NotDrawn
from repose.pictures.sweep.axis import add_legend, axis_of, key_label
from repose.pictures.sweep.measured import has

# Those of the packing are by geometry for every method; the summary's own are of forces where there are any.
DENSITY = "packing.solid_fraction.mean"
DENSITY_LABEL = "solid fraction ρ"
MEASURES = (
    ("packing.coordination.mean", "coordination z"),
    ("packing.fabric.anisotropy.mean", "anisotropy a"),
    ("packing.fabric_folded.direction_deg.mean", "direction $θ_f$ from the\nvertical (deg)"),
)
SHARES = tuple(f"packing.P_{q}" for q in range(7))
NEIGHBOURS = ("0", "1", "2", "3", "4", "5", "6+")
LEAST_SHARE = 0.005  # that is drawn
COLOURS = (*style.SERIES, style.INK)
MARKERS = (*style.MARKERS, "X")
MANY = 24  # points of a line whose markers are left small
TOP = 0.26  # inch of the caption
PANEL = 2.15  # inch, its height


def draw(sweep):
    """Over the parameter; over the solid fraction; and if there are several series, their shares P_q over it."""
    axis = axis_of(sweep)
    if axis.key is None or not all(has(sweep, key) for key in (DENSITY, *(key for key, _ in MEASURES))):
        raise NotDrawn("no packings measured over a parameter that is a number")
    density = sweep.measures[DENSITY]
    shares = [q for q, key in enumerate(SHARES) if has(sweep, key) and _largest(sweep, key) > LEAST_SHARE]
    along = (axis.place, None, key_label(axis.key))
    over_density = (density["mean"], density["error"], DENSITY_LABEL)
    one = len(axis.lines) == 1
    figures = [
        _figure(sweep, axis, along, ((DENSITY, DENSITY_LABEL), *MEASURES), shares if one else ()),
        _figure(sweep, axis, over_density, MEASURES, shares if one else ()),
    ]
    if shares and not one:
        panels = [(SHARES[q], f"share $P_{q}$ with\n{NEIGHBOURS[q]} contact{'s' * (q != 1)}") for q in shares]
        figures.append(_figure(sweep, axis, over_density, panels))
    return figures


def _figure(sweep, axis, along, panels, together=()):
    """A panel for each measure with all series, and one of the shares `together` of the only series."""
    place, place_error, place_label = along
    count = len(panels) + bool(together)
    columns = 2 if together or count in (2, 4) else 3
    rows = -(-count // columns)
    height = PANEL * rows + TOP
    figure = Figure(figsize=(3.15 * columns if columns == 2 else 2.5 * columns, height))
    grid = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes, (key, label) in zip(grid, panels):
        for k, line in enumerate(axis.lines):
            points = _points(axes, place, place_error, sweep.measures[key], line.rows, k, line.name)
            if k % 2:  # what lies under it is still seen
                points.set_markerfacecolor("none")
        axes.set(xlabel=place_label, ylabel=label)
    if together:
        axes = grid[len(panels)]
        for q in together:
            _points(axes, place, place_error, sweep.measures[SHARES[q]], axis.lines[0].rows, q, NEIGHBOURS[q])
        axes.set(xlabel=place_label, ylabel="share $P_q$ with q contacts")
        axes.legend(loc="upper center", ncol=4, bbox_to_anchor=(0.5, 1.16), handlelength=0.8, columnspacing=0.8)
    for axes in grid[count:]:
        axes.remove()
    top = TOP + add_legend(figure, grid[0], axis, TOP)
    figure.tight_layout(pad=0.4, h_pad=1.2, w_pad=1.0, rect=(0.0, 0.0, 1.0, 1.0 - top / height))
    style.caption(figure, "mean ± standard error of the members of a point")
    return figure


def _largest(sweep, key):
    return np.nanmax(sweep.measures[key]["mean"])


def _points(axes, place, place_error, measure, rows, k, name):
    """The markers of a series."""
    colour, marker = COLOURS[k % len(COLOURS)], MARKERS[k % len(MARKERS)]
    errors = dict(yerr=np.nan_to_num(measure["error"][rows]))
    if place_error is not None:
        errors["xerr"] = np.nan_to_num(place_error[rows])
    size = 2.2 if len(rows) > MANY else 4.0
    bars = axes.errorbar(
        place[rows], measure["mean"][rows], fmt=marker, color=colour, markersize=size, elinewidth=0.7, label=name, **errors
    )
    return bars[0]
