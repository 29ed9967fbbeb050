# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Coarse-grained fields of a heap: solid fraction, and pressure with bars along the major principal stress."""

import numpy as np
from matplotlib import colormaps
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import analysis_table
from repose.pictures.run.grain_panel import make_panels
from repose.pictures.run.legends import BAR_ROW, LEGEND_ROW, colour_bar_above, legend_above
from repose.pictures.run.shapes import add_discs, add_walls

LEAST = 0.2  # solid fraction below which nothing is drawn, because the Gaussian extends beyond the surface
LEAST_ROOM = 0.02  # of a cell that is cut by a wall
RANGE = 0.3  # of the largest solid fraction; the colours span it, and the surface below it is grey
LEAST_PITCH = 0.17  # inch between bars
LONGEST = 0.6  # (p1 - p2)/(p1 + p2) of a bar as long as the pitch
LEGEND_VALUE = 0.3  # (p1 - p2)/(p1 + p2) of the bar in the legend


def draw(run, state):
    """Figure of the last state."""
    table = analysis_table(run, state, "fields", "there is no heap")
    filled = before_walls(table, "solid_fraction")
    dense = filled >= LEAST
    if not dense.any():
        raise NotDrawn("there is no heap")
    pressure, anisotropy, angle = principal(table)
    upper, lower = make_panels(run, state, [BAR_ROW, BAR_ROW + LEGEND_ROW])
    solid_fraction = np.ma.masked_where(~dense, filled)
    top = 0.05 * np.ceil(solid_fraction.max() / 0.05)
    colours = colormaps[style.PACKING].with_extremes(under=style.FAINT)
    packing = field_map(upper, table, solid_fraction, colours, Normalize((1.0 - RANGE) * top, top))
    load = np.ma.masked_where(~dense, pressure / np.maximum(table["room"], LEAST_ROOM))
    load_map = field_map(lower, table, load, style.LOAD, Normalize(min(0.0, load.min()), load.max() or 1.0))
    bars, pitch = _bars(table, lower, dense & (pressure > 0.0), anisotropy, angle)
    width = min(0.9, 0.06 * pitch * lower.points_per_length)
    lower.axes.add_collection(LineCollection(bars, colors=style.INK, linewidths=width), autolim=False)
    for panel in (upper, lower):
        add_walls(panel, run, state)
        drawing = dict(facecolor=style.HELD, edgecolor="white", linewidth=0.25, zorder=2.5)
        add_discs(panel, run, state, state.grains.held, **drawing)
    units = style.units_of(run)
    upper.axes.set_xlabel("")
    title = f"solid fraction, Gaussian of width {units.length_value(table.attributes['width'])}"
    colour_bar_above(upper, packing, title, extend="min")
    colour_bar_above(lower, load_map, units.stress("pressure"))
    legend_above(lower, [_handle(pitch * lower.points_per_length, width)], down=BAR_ROW)
    return lower.figure


def principal(table):
    """Pressure (p1 + p2)/2, anisotropy (p1 - p2)/(p1 + p2) with NaN at pressures <= 0, angle of the axis of p1 from x."""
    xx, yy = table["stress_xx"], table["stress_yy"]
    xy = 0.5 * (table["stress_xy"] + table["stress_yx"])
    pressure = 0.5 * (xx + yy)
    deviator = np.hypot(0.5 * (xx - yy), xy)
    anisotropy = np.divide(deviator, pressure, out=np.full_like(pressure, np.nan), where=pressure > 0.0)
    return pressure, anisotropy, 0.5 * np.arctan2(2.0 * xy, xx - yy)


def before_walls(table, name):
    """A density as the mean over the part of each cell that walls leave to the heap; 0 where that is next to nothing."""
    room = table["room"]
    return np.where(room >= LEAST_ROOM, table[name] / np.maximum(room, LEAST_ROOM), 0.0)


def edges(centres, cell):
    return np.append(centres - 0.5 * cell, centres[-1] + 0.5 * cell)


def field_map(panel, table, values, colours, norm):
    cell = table.attributes["cell"]
    x, y = (edges(table[name], cell) for name in ("x", "y"))
    itself = panel.axes.get_rasterization_zorder() is None  # else the axes do, and Matplotlib cannot do it twice
    return panel.axes.pcolormesh(x, y, values, cmap=colours, norm=norm, rasterized=itself, zorder=0.4)


def _bars(table, panel, chosen, anisotropy, angle):
    """Lines (K, 2, 2) [L] at every n-th cell in x and y, and the distance [L] between those cells."""
    cell = table.attributes["cell"]
    step = max(1, int(np.ceil(LEAST_PITCH * 72.0 / panel.points_per_length / cell)))
    row, column = (np.arange(0, len(table[name]), step) + (len(table[name]) - 1) % step // 2 for name in ("y", "x"))
    at = np.array([(r, c) for r in row for c in column if r < chosen.shape[0] and c < chosen.shape[1] and chosen[r, c]])
    if len(at) == 0:
        return np.empty((0, 2, 2)), step * cell
    r, c = at.T
    half = 0.5 * step * cell * np.minimum(anisotropy[r, c] / LONGEST, 1.0)
    along = half[:, None] * np.column_stack([np.cos(angle[r, c]), np.sin(angle[r, c])])
    centre = np.column_stack([table["x"][c], table["y"][r]])
    return np.stack([centre - along, centre + along], axis=1), step * cell


def _handle(pitch, width):
    """The bar of the legend; `pitch` and `width` in points."""
    length = pitch * LEGEND_VALUE / LONGEST
    name = f"axis of the major principal stress; this long: (p₁ − p₂)/(p₁ + p₂) = {LEGEND_VALUE:g}"
    bar = dict(linestyle="none", marker="_", markersize=length, markeredgewidth=width, color=style.INK)
    return Line2D([], [], label=name, **bar)
