# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Panels that show spheres in one or more views of the same scale."""

from repose import style
from repose.pictures.run.grain_panel import (
    AXES_HEIGHT,
    AXES_WIDTH,
    LARGEST_GRAIN,
    LEAST_AXES_WIDTH,
    LEFT,
    grains_and_time,
    stack_panels,
    widened,
)
from repose.pictures.run.space_box import space_box
from repose.pictures.run.visible_box import periodic_sides, wrapped

SI_LEFT = 0.72  # inch


def make_views(run, state, planes, legend_heights, beside=0.0, remark=""):
    """A figure with a panel of the heap for each plane, one below the other; all show the same axis to the right. `remark`
    ends its caption."""
    box = space_box(run, state)
    views = [(box.face(plane.across, plane.up), plane.names) for plane in planes]
    first = views[0][0]
    scale = min(
        (AXES_WIDTH - beside) / (first.x_max - first.x_min),
        AXES_HEIGHT / sum(view.y_max - view.y_min for view, _ in views),
        LARGEST_GRAIN / run.attributes["grain_diameter"],
    )
    if planes[0].across not in [axis for axis, _, _ in periodic_sides(run)]:
        views = [(widened(view, (LEAST_AXES_WIDTH - beside) / scale), names) for view, names in views]
    panels = stack_panels(run, state, views, scale, legend_heights, beside=beside, left=left_edge(run))
    text = grains_and_time(run, state, box.holds(wrapped(run, state.grains.position)))
    style.caption(panels[0].figure, text + (f"; {remark}" if remark else ""))
    return panels


def left_edge(run):
    """[inch] left of the axes, where SI lengths such as -0.010 need space."""
    return LEFT if style.units_of(run).reduced else SI_LEFT


def edge_width(run, panel):
    """[points] of the outline of a sphere."""
    return min(0.5, 0.06 * run.attributes["grain_diameter"] * panel.points_per_length)
