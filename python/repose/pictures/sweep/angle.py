# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Angle of repose over the axis of a sweep."""

from matplotlib.figure import Figure

from repose import style
from repose.pictures.sweep.axis import axis_of
from repose.pictures.sweep.panel import CAPTION, TOP, add_legend, caption, draw_measure, label_axes, panel_height



def draw(sweep):
    """One figure."""
    axis = axis_of(sweep)
    figure = Figure(figsize=(4.6, panel_height(axis, sweep, 3.0) + TOP))
    axes = figure.subplots()
    draw_measure(axes, axis, sweep, "angle_of_repose_deg.mean")
    label_axes(axes, axis, sweep, "angle of repose (deg)")
    height = figure.get_size_inches()[1]
    top = TOP + add_legend(figure, axes, axis, TOP)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - top / height))
    caption(figure, axis, sweep, CAPTION)
    return [figure]
