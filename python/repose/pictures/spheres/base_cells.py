# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pressure and shear of a heap on a level floor, seen from above: pressure on square cells in colours, shear as arrows."""

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import analysis_table
from repose.pictures.run.common_axes import largest_force
from repose.pictures.run.legends import colour_bar_above

NO_CELLS = "there is neither a base of grains nor a level floor that carries some"
CORNERS = 0.5 * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])  # of a cell, in its sides


def loaded_cells(run, state):
    """Columns of the cells on which grains press or pull, and the sides (2) [L] of a cell."""
    cells = analysis_table(run, state, "base_cells", NO_CELLS)
    loaded = (cells["pressure"] != 0.0) | (cells["shear_x"] != 0.0) | (cells["shear_y"] != 0.0)
    if not loaded.any():
        raise NotDrawn("nothing rests on the base")
    side = np.array([cells.attributes["side_x"], cells.attributes["side_y"]])
    return {name: values[loaded] for name, values in cells.items()}, side


def nearest_cells(cells, fraction):
    """Those of the cells, nearest to the middle of the load, that hold this fraction of it: few grains that have rolled far away
    would make the heap small in a picture. `cells` themselves where nothing presses."""
    load = np.abs(cells["pressure"])
    if not load.sum() > 0.0:
        return cells
    away = np.hypot(*(cells[axis] - np.average(cells[axis], weights=load) for axis in "xy"))
    order = np.argsort(away, kind="stable")
    reached = np.searchsorted(np.cumsum(load[order]), fraction * load.sum())
    near = away <= away[order[min(reached, len(order) - 1)]]
    return {name: values[near] for name, values in cells.items()}


def corners_of(cells, side):
    """Corners (K, 4, 2) [L] of cells with these sides (2)."""
    return np.column_stack([cells["x"], cells["y"]])[:, None] + CORNERS * side


def add_pressure(panel, run, cells, side):
    """The cells in the colours of their pressure, with a colour bar above the axes."""
    pressure = cells["pressure"]
    largest = largest_force(pressure[pressure > 0.0]) or 1.0
    drawing = dict(cmap=style.LOAD, norm=Normalize(0.0, largest), edgecolors=style.FAINT, linewidths=0.25)
    squares = PolyCollection(corners_of(cells, side), array=pressure, **drawing)
    panel.axes.add_collection(squares, autolim=False)
    title = style.units_of(run).stress("pressure on the floor")
    colour_bar_above(panel, squares, title, extend="max" if (pressure > largest).any() else "neither")


def mean_shear_of_cells(cells, side, count):
    """Middles (K, 2) [L] of groups of `count` x `count` neighbouring cells, and the mean shear stress in each (K, 2); the stress on
    a cell that is not listed is 0."""
    place = np.column_stack([cells["x"], cells["y"]])
    number = np.rint((place - place[0]) / side).astype(int)
    groups, which = np.unique(np.floor_divide(number - number.min(axis=0), count), axis=0, return_inverse=True)
    which = which.reshape(-1)
    means = np.column_stack([np.bincount(which, weights=cells[name]) / count**2 for name in ("shear_x", "shear_y")])
    first = place[0] + side * number.min(axis=0)  # the middle of the cell of least x and y
    return first + side * (count * groups + 0.5 * (count - 1)), means
