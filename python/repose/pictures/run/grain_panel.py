# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Panels that show grains: axes of one scale in x and y, as large as the box that they show asks for."""

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.legends import LEGEND_ROW
from repose.pictures.run.visible_box import Box, visible_box, wrapped

# inches
AXES_WIDTH = 6.3
AXES_HEIGHT = 6.5
LEFT, RIGHT, BOTTOM, TOP = 0.58, 0.12, 0.42, 0.28
LEAST_AXES_WIDTH = 3.9  # the legend of the force network needs it
LARGEST_GRAIN = 0.17

MOST_VECTOR_GRAINS = 20000  # above it grains are pixels in vector files, which would otherwise be slow to open


@dataclass(frozen=True)
class GrainPanel:
    """Axes that show a box."""

    figure: Figure
    axes: object
    box: Box
    points_per_length: float  # [1/72 inch per L]
    legend_top: float  # [inch] from the top of the figure to the space for legends above the axes


def make_panel(run, state, with_legend):
    """A figure with one panel and a caption; `with_legend` leaves a row above the axes."""
    return make_panels(run, state, [LEGEND_ROW if with_legend else 0.0])[0]


def make_panels(run, state, legend_heights, below=0.0, beside=0.0):
    """A figure with panels of the same box, one below the other, and a caption: one panel for each height [inch] of the
    legends above it. `below` and `beside` [inch] of the figure are left empty at the bottom and on the right."""
    if run.attributes["dimension"] != 2:
        raise NotDrawn("the run is not two-dimensional")
    box = visible_box(run, state)
    scale = min(
        (AXES_WIDTH - beside) / (box.x_max - box.x_min),
        AXES_HEIGHT / len(legend_heights) / (box.y_max - box.y_min),
        LARGEST_GRAIN / run.attributes["grain_diameter"],
    )
    least_width = LEAST_AXES_WIDTH - beside
    if not run.attributes["periodic"]:
        box = Box(*_widened(box.x_min, box.x_max, least_width / scale), box.y_min, box.y_max)
    axes_width, axes_height = (box.x_max - box.x_min) * scale, (box.y_max - box.y_min) * scale
    width = LEFT + max(axes_width, least_width) + RIGHT + beside
    height = TOP + sum(legend_heights) + len(legend_heights) * (axes_height + BOTTOM) + below
    figure = Figure(figsize=(width, height))
    panels, top = [], TOP
    for legend_height in legend_heights:
        low = height - top - legend_height - axes_height
        axes = figure.add_axes([LEFT / width, low / height, axes_width / width, axes_height / height])
        _set_limits_and_labels(axes, run, state, box, axes_width, axes_height)
        panels.append(GrainPanel(figure, axes, box, scale * 72.0, top))
        top += legend_height + axes_height + BOTTOM
    style.caption(figure, _grains_and_time(run, state, box))
    return panels


def _widened(low, high, width):
    """The interval, widened about its middle to at least `width`."""
    missing = max(0.0, width - (high - low))
    return low - 0.5 * missing, high + 0.5 * missing


def _set_limits_and_labels(axes, run, state, box, width, height):
    if len(state.grains) > MOST_VECTOR_GRAINS:
        axes.set_rasterization_zorder(1.5)  # between the collections and the lines
    axes.set_xlim(box.x_min, box.x_max)
    axes.set_ylim(box.y_min, box.y_max)
    axes.locator_params(axis="y", nbins=max(2, min(8, int(height / 0.35))), steps=[1, 2, 5, 10])
    axes.locator_params(axis="x", nbins=max(2, min(10, int(width / 0.6))), steps=[1, 2, 5, 10])
    units = style.units_of(run)
    axes.set_xlabel(units.length("x"))
    axes.set_ylabel(units.length("y"))


def _grains_and_time(run, state, box):
    """Caption of a panel."""
    moving = ~state.grains.held
    outside = np.count_nonzero(moving & ~box.near(wrapped(run, state.grains.position), 0.0))
    count = np.count_nonzero(moving)
    text = f"{count} {'grain' if count == 1 else 'grains'}"
    if outside:
        text += f" ({outside} outside the picture)"
    if run.attributes.get("method") != "deposition":  # time counts grains there
        text += f", t = {style.units_of(run).time_value(state.time)}"
    return text if state.frame or run.attributes["status"] == "finished" else f"{text}, {run.attributes['status']}"
