# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Coarse-grained motion of a heap: the mean velocity as speed and arrows, and the granular temperature."""

import numpy as np

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import analysis_table
from repose.pictures.run.grain_panel import make_panels
from repose.pictures.run.legends import BAR_ROW, colour_bar_above
from repose.pictures.run.shapes import add_discs, add_walls
from repose.pictures.run.stress import LEAST, before_walls, field_map

LEAST_PITCH = 0.2  # inch between arrows


def draw_velocity(run, state):
    """Figure of the last state: speed in colours, and arrows of one length for the largest speed."""
    table, dense = _dense(run, state)
    x, y = table["velocity_x"], table["velocity_y"]
    speed = np.hypot(x, y)
    largest = np.nanmax(np.where(dense, speed, np.nan))
    if not largest > 0.0:
        raise NotDrawn("nothing moves")
    (panel,) = make_panels(run, state, [BAR_ROW])
    colours = field_map(panel, table, np.ma.masked_where(~dense, speed), style.LOAD, None)
    cell = table.attributes["cell"]
    step = max(1, int(np.ceil(LEAST_PITCH * 72.0 / panel.points_per_length / cell)))
    some = np.zeros_like(dense)
    some[step // 2 :: step, step // 2 :: step] = True
    row, column = np.nonzero(some & dense)
    length = step * cell / largest
    panel.axes.quiver(
        table["x"][column], table["y"][row], length * x[row, column], length * y[row, column],
        angles="xy", scale_units="xy", scale=1.0, width=0.6 / 72.0, units="inches", color=style.INK, pivot="middle",
    )  # fmt: skip
    return _finished(panel, run, state, colours, style.units_of(run).speed("speed of the mean flow"))


def draw_temperature(run, state):
    """Figure of the last state."""
    table, dense = _dense(run, state)
    temperature = table["temperature"]
    dense &= np.isfinite(temperature)
    if not dense.any() or not np.nanmax(np.where(dense, temperature, np.nan)) > 0.0:
        raise NotDrawn("velocities do not scatter about the mean flow")
    (panel,) = make_panels(run, state, [BAR_ROW])
    colours = field_map(panel, table, np.ma.masked_where(~dense, temperature), "magma_r", None)
    return _finished(panel, run, state, colours, style.units_of(run).speed_squared("granular temperature"))


def _dense(run, state):
    table = analysis_table(run, state, "fields", "there is no heap")
    dense = before_walls(table, "solid_fraction") >= LEAST
    if not dense.any():
        raise NotDrawn("there is no heap")
    return table, dense


def _finished(panel, run, state, colours, title):
    add_walls(panel, run, state)
    held = dict(facecolor=style.HELD, edgecolor="white", linewidth=0.25, zorder=2.5)
    add_discs(panel, run, state, state.grains.held, **held)
    colour_bar_above(panel, colours, title)
    return panel.figure
