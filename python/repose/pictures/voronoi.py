# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Voronoi cells of the grains in the heap, coloured by the solid fraction of each; open cells are grey."""

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.patches import Patch

from repose import style
from repose.field import BAR_ROW, bar_above, make_fields
from repose.marks import add_cells, add_discs, add_walls
from repose.not_drawn import NotDrawn
from repose.pictures.needed import analysed

PERCENTILES = (1.0, 99.0)  # of the closed cells, within the colour scale
STEP = 0.02  # the scale ends at multiples of it


def draw(run, state):
    """Figure of the last state."""
    voronoi = analysed(run, state, "voronoi", "no heap")
    solid_fraction, offset = voronoi["solid_fraction"], voronoi["offset"]
    cells = [voronoi["vertices"][start:end] for start, end in zip(offset[:-1], offset[1:])]
    bounded = np.array([len(cell) > 2 for cell in cells], dtype=bool)
    closed = bounded & voronoi["closed"].astype(bool) & np.isfinite(solid_fraction)
    if not closed.any():
        raise NotDrawn("no cell is closed")
    scale = _scale(solid_fraction[closed])
    field = make_fields(run, state, [BAR_ROW])[0]
    add_walls(field, run, state)
    width = 0.05 * run.attributes["grain_diameter"] * field.points_per_length
    edge = dict(edgecolor="white", linewidth=min(0.4, width))
    add_cells(field, run, [cells[k] for k in np.flatnonzero(bounded & ~closed)], facecolor=style.FAINT, **edge)
    shown = [cells[k] for k in np.flatnonzero(closed)]
    colours = add_cells(field, run, shown, array=solid_fraction[closed], cmap=style.PACKING, norm=scale, **edge)
    add_discs(field, run, state, state.grains.held, facecolor=style.HELD, edgecolor="white", linewidth=0.25)
    below, above = (solid_fraction[closed] < scale.vmin).any(), (solid_fraction[closed] > scale.vmax).any()
    extend = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}[below, above]
    keys = [Patch(facecolor=style.FAINT, label="open cell")] if (bounded & ~closed).any() else []
    bar_above(field, colours, "solid fraction of the cell", keys, extend)
    return field.figure


def _scale(values):
    low, high = np.percentile(values, PERCENTILES)
    low, high = STEP * np.floor(low / STEP), STEP * np.ceil(high / STEP)
    return Normalize(low, max(high, low + STEP))
