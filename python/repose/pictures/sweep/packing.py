# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures of packings over the parameter of a sweep and over the solid fraction (Bratberg 2003, paper one, Figs. 2, 6
to 8 and 10 to 14), with a series of points for each combination of the other parameters, or for each scene."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.sweep.axis import axis_of
from repose.pictures.sweep.key_label import key_label
from repose.pictures.sweep.panel import TOP, add_legend, caption, has_measure, is_geometric

# The measures of the packing follow from geometry for every method; others of the same name may follow from forces.
DENSITY = "packing.solid_fraction.mean"
DENSITY_LABEL = "solid fraction ρ"
MEASURES = (
    ("packing.coordination.mean", "coordination z"),
    ("packing.fabric.anisotropy.mean", "anisotropy a"),
    ("packing.fabric_folded.direction_deg.mean", "direction $θ_f$ from the\nvertical (deg)"),
)
FRACTIONS = tuple(f"packing.P_{q}" for q in range(7))  # fraction of the grains that have q contacts
CONTACTS = ("0", "1", "2", "3", "4", "5", "6+")
LEAST_FRACTION = 0.005  # smaller ones are not drawn
COLOURS = (*style.SERIES, style.INK)
MARKERS = (*style.MARKERS, "X")
MANY = 24  # points; longer series have small markers
PANEL_HEIGHT = 2.15  # inch


def draw(sweep):
    """A figure over the parameter and one over the solid fraction; of several series one more, of the fractions P_q."""
    axis = axis_of(sweep)
    if axis.key is None or not all(has_measure(sweep, key) for key in (DENSITY, *(key for key, _ in MEASURES))):
        raise NotDrawn("no packings were measured over a numeric parameter")
    density = sweep.measures[DENSITY]
    fractions = [q for q, key in enumerate(FRACTIONS) if _largest_mean(sweep, key) > LEAST_FRACTION]
    along = (axis.place, None, key_label(axis.key, sweep.key_comments, style.units_of(sweep)))
    over_density = (density["mean"], density["error"], DENSITY_LABEL)
    one = len(axis.lines) == 1
    figures = [
        _figure(sweep, axis, along, ((DENSITY, DENSITY_LABEL), *MEASURES), fractions if one else ()),
        _figure(sweep, axis, over_density, MEASURES, fractions if one else ()),
    ]
    if fractions and not one:
        panels = [(FRACTIONS[q], f"fraction $P_{q}$ with\n{CONTACTS[q]} contact{'s' * (q != 1)}") for q in fractions]
        figures.append(_figure(sweep, axis, over_density, panels))
    return figures


def _figure(sweep, axis, along, panels, together=()):
    """A panel with all series for each measure, and one panel with the fractions `together` of the only series."""
    place, place_error, place_label = along
    scale = "log" if place_error is None and is_geometric(place) else "linear"
    count = len(panels) + bool(together)
    columns = 2 if together or count in (2, 4) else 3
    rows = -(-count // columns)
    height = PANEL_HEIGHT * rows + TOP
    figure = Figure(figsize=(3.15 * columns if columns == 2 else 2.5 * columns, height))
    grid = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes, (key, label) in zip(grid, panels):
        for k, line in enumerate(axis.lines):
            points = _points(axes, place, place_error, sweep.measures[key], line.rows, k, line.name)
            if k % 2:  # points below it stay visible
                points.set_markerfacecolor("none")
        axes.set(xlabel=place_label, ylabel=label, xscale=scale)
    if together:
        axes = grid[len(panels)]
        for q in together:
            _points(axes, place, place_error, sweep.measures[FRACTIONS[q]], axis.lines[0].rows, q, CONTACTS[q])
        axes.set(xlabel=place_label, xscale=scale, ylabel="fraction $P_q$ with q contacts")
        axes.legend(loc="upper center", ncol=4, bbox_to_anchor=(0.5, 1.16), handlelength=0.8, columnspacing=0.8)
    for axes in grid[count:]:
        axes.remove()
    top = TOP + add_legend(figure, grid[0], axis, TOP)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - top / height), h_pad=1.2, w_pad=1.0)
    caption(figure, axis, sweep, "mean ± standard error over the members of a point")
    return figure


def _largest_mean(sweep, key):
    """The largest mean of a measure over the points; 0 where no point has it."""
    return np.nanmax(sweep.measures[key]["mean"]) if has_measure(sweep, key) else 0.0


def _points(axes, place, place_error, measure, rows, k, name):
    """The markers of a series."""
    colour, marker = COLOURS[k % len(COLOURS)], MARKERS[k % len(MARKERS)]
    errors = dict(yerr=np.nan_to_num(measure["error"][rows]))
    if place_error is not None:
        errors["xerr"] = np.nan_to_num(place_error[rows])
    drawing = dict(fmt=marker, color=colour, markersize=2.2 if len(rows) > MANY else 4.0, elinewidth=0.7)
    return axes.errorbar(place[rows], measure["mean"][rows], label=name, **drawing, **errors)[0]
