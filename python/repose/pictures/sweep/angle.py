# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Angle of repose over what a sweep varies."""

from matplotlib.figure import Figure

from repose import style
from repose.pictures.sweep.axis import add_legend, axis_of, label_axis, points_height
from repose.pictures.sweep.measured import CAPTION, draw_measured

TOP = 0.26  # inch of the caption


def draw(sweep):
    """One figure."""
    axis = axis_of(sweep)
    figure = Figure(figsize=(4.6, points_height(axis, sweep, 3.0) + TOP))
    axes = figure.subplots()
    draw_measured(axes, axis, sweep, "angle_of_repose_deg.mean")
    label_axis(axes, axis, sweep, "angle of repose (deg)")
    height = figure.get_size_inches()[1]
    top = TOP + add_legend(figure, axes, axis, TOP)
    figure.tight_layout(pad=0.4, rect=(0.0, 0.0, 1.0, 1.0 - top / height))
    style.caption(figure, CAPTION)
    return [figure]
