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
    if not run.attributes["periodic"]:
        box = widened(box, (LEAST_AXES_WIDTH - beside) / scale)
    panels = stack_panels(run, state, [(box, "xy")] * len(legend_heights), scale, legend_heights, below, beside)
    style.caption(panels[0].figure, grains_and_time(run, state, box.near(wrapped(run, state.grains.position), 0.0)))
    return panels


def stack_panels(run, state, views, scale, legend_heights, below=0.0, beside=0.0, left=LEFT):
    """A figure with a panel of `scale` [inch per L] for each view, one below the other, `left` [inch] from its edge. A view is a
    box and the names of its axes; all have the same width."""
    least_width = LEAST_AXES_WIDTH - beside
    axes_width = (views[0][0].x_max - views[0][0].x_min) * scale
    heights = [(box.y_max - box.y_min) * scale for box, _ in views]
    width = left + max(axes_width, least_width) + RIGHT + beside
    height = TOP + sum(legend_heights) + sum(axes_height + BOTTOM for axes_height in heights) + below
    figure = Figure(figsize=(width, height))
    panels, top = [], TOP
    for (box, names), axes_height, legend_height in zip(views, heights, legend_heights):
        low = height - top - legend_height - axes_height
        axes = figure.add_axes([left / width, low / height, axes_width / width, axes_height / height])
        _set_limits_and_labels(axes, run, state, box, names, axes_width, axes_height)
        panels.append(GrainPanel(figure, axes, box, scale * 72.0, top))
        top += legend_height + axes_height + BOTTOM
    return panels


def widened(box, width):
    """The box, widened about its middle to at least `width` [L]."""
    missing = max(0.0, width - (box.x_max - box.x_min))
    return Box(box.x_min - 0.5 * missing, box.x_max + 0.5 * missing, box.y_min, box.y_max)


def _set_limits_and_labels(axes, run, state, box, names, width, height):
    if len(state.grains) > MOST_VECTOR_GRAINS:
        axes.set_rasterization_zorder(1.5)  # between the collections and the lines
    axes.set_xlim(box.x_min, box.x_max)
    axes.set_ylim(box.y_min, box.y_max)
    axes.locator_params(axis="y", nbins=max(2, min(8, int(height / 0.35))), steps=[1, 2, 5, 10])
    axes.locator_params(axis="x", nbins=max(2, min(10, int(width / 0.6))), steps=[1, 2, 5, 10])
    units = style.units_of(run)
    axes.set_xlabel(units.length(names[0]))
    axes.set_ylabel(units.length(names[1]))


def grains_and_time(run, state, inside):
    """Caption of a picture of grains, of which those `inside` (N, bool) are in it."""
    moving = ~state.grains.held
    outside = np.count_nonzero(moving & ~inside)
    count = np.count_nonzero(moving)
    text = f"{count} {'grain' if count == 1 else 'grains'}"
    if outside:
        text += f" ({outside} outside the picture)"
    if run.attributes.get("method") != "deposition":  # time counts grains there
        text += f", t = {style.units_of(run).time_value(state.time)}"
    return text if state.frame or run.attributes["status"] == "finished" else f"{text}, {run.attributes['status']}"
