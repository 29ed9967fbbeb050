# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""A column between two upright walls: its force network, and beside it the stresses by height with Janssen's law."""

import numpy as np
from matplotlib.lines import Line2D

from repose import style
from repose.pictures.janssen import PRESSURE, STRESS, Janssen
from repose.pictures.run.analysis_parts import analysis_table
from repose.pictures.run.forces import add_network, largest_of
from repose.pictures.run.grain_panel import RIGHT, make_panels
from repose.pictures.run.legends import LEGEND_ROW, legend_above
from repose.pictures.run.pipe import floor_height

NO_COLUMN = "there are no grains between two upright walls, or its method has no forces"
BESIDE = 2.9  # inch of the panel beside the grains
GAP = 0.2  # inch between the two
POINTS = 200  # of a curve


def draw(run, state):
    """Figure of the last state, and of means over output.window."""
    column = analysis_table(run, state, "column", NO_COLUMN)
    largest = largest_of(run, state)
    panel = make_panels(run, state, [legend_rows(run) * LEGEND_ROW], beside=BESIDE)[0]
    add_network(panel, run, state, largest)
    draw_beside(panel, run, column, _law(run, column), floor_height(run, state))
    return panel.figure


def legend_rows(run):
    """Rows of legends above the panels."""
    return 3 if _allowed_load(run) is None else 4


def draw_beside(panel, run, column, law, floor):
    """Stresses by height beside a panel of grains, with their legends above it. `floor` [L] is where heights count from."""
    figure = panel.figure
    place = panel.axes.get_position()
    width = figure.get_figwidth()
    left = place.x1 + GAP / width
    axes = figure.add_axes([left, place.y0, 1.0 - RIGHT / width - left, place.height], sharey=panel.axes)
    axes.tick_params(labelleft=False)
    units = style.units_of(run)
    handles = _draw_slices(axes, column, floor)
    legend_above(panel, handles, _window(run, units), LEGEND_ROW)
    if law.known:
        _draw_law(panel, axes, law, floor)
    allowed = _allowed_load(run)
    if allowed is not None:
        handle = _draw_allowed(axes, np.array(allowed) * law.weight / law.width, floor)
        legend_above(panel, [handle], "equilibrium of rigid grains allows:", 3 * LEGEND_ROW)
    axes.axvline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
    axes.locator_params(axis="x", nbins=6)
    axes.set_xlabel(units.stress("stress"))


def _window(run, units):
    window = run.scene.get("output", {}).get("window", 0.0)
    return f"mean over the last {units.time_value(window)}:" if window > 0.0 else "at the end:"


def _draw_slices(axes, column, floor):
    """Steps of pressure and shear, points of the vertical stress in the middle of each slice; handles of a legend."""
    edges = floor + np.append(column["bottom"], column["top"][-1])
    for name, colour in (("pressure", PRESSURE), ("shear", style.GREEN)):
        axes.stairs(column[name], edges, orientation="horizontal", baseline=None, color=colour, linewidth=0.9)
    middle = 0.5 * (edges[1:] + edges[:-1])
    axes.plot(column["stress"], middle, "o", color=STRESS, markersize=2.8, markeredgewidth=0)
    return [
        Line2D([], [], color=STRESS, marker="o", linestyle="none", markersize=2.8, label="vertical stress"),
        Line2D([], [], color=PRESSURE, linewidth=0.9, label="wall pressure"),
        Line2D([], [], color=style.GREEN, linewidth=0.9, label="wall shear, up > 0"),
    ]


def _law(run, column):
    """Janssen's law of the measured stress ratio and friction: no fit to the stresses drawn."""
    values = column.attributes
    gravity = np.hypot(*np.asarray(run.attributes.get("gravity", [0.0, np.nan]), dtype=float)[:2])
    names = ("width", "height", "stress_ratio", "friction")
    return Janssen(**{name: values.get(name, np.nan) for name in names}, weight=values.get("mass", np.nan) * gravity)


def _draw_law(panel, axes, law, floor):
    depth = np.linspace(0.0, law.height, POINTS)
    height = floor + law.height - depth
    drawing = dict(linewidth=1.2, linestyle="--")
    handles = [
        axes.plot(law.stress(depth), height, color=STRESS, label="stress", **drawing)[0],
        axes.plot(law.pressure(depth), height, color=PRESSURE, label="pressure", **drawing)[0],
    ]
    numbers = f"measured K = {law.stress_ratio:.2f}, friction {law.friction:.2f}".replace("-", "−")
    legend_above(panel, handles, f"Janssen's law of the {numbers}:", 2 * LEGEND_ROW)


def _allowed_load(run):
    """Least and largest load of the floor over the weight that statics allows; None where that was not looked for."""
    found = (run.summary.get("force_range") or {}).get("load_ratio") or {}
    ends = [found.get("min"), found.get("max")]
    return None if None in ends else ends


def _draw_allowed(axes, ends, floor):
    axes.plot(ends, [floor, floor], "|-", color=STRESS, linewidth=0.9, markersize=7, clip_on=False, zorder=3)
    return Line2D([], [], color=STRESS, marker="|", markersize=7, linewidth=0.9, label="stress at the floor")
