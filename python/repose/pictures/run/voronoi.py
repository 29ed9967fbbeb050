# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Voronoi cells of the grains in the heap, coloured by the solid fraction of each; open cells are grey."""

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.patches import Patch

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import analysis_table
from repose.pictures.run.grain_panel import make_panels
from repose.pictures.run.legends import BAR_ROW, colour_bar_above
from repose.pictures.run.shapes import add_cells, add_discs, add_walls

PERCENTILES = (1.0, 99.0)  # of the closed cells, which the colour scale spans
STEP = 0.02  # in solid fraction; the scale ends at multiples of it


def draw(run, state):
    """Figure of the last state."""
    voronoi = analysis_table(run, state, "voronoi", "there is no heap")
    solid_fraction, offset = voronoi["solid_fraction"], voronoi["offset"]
    cells = [voronoi["vertices"][start:end] for start, end in zip(offset[:-1], offset[1:])]
    bounded = np.array([len(cell) > 2 for cell in cells], dtype=bool)
    closed = bounded & voronoi["closed"].astype(bool) & np.isfinite(solid_fraction)
    if not closed.any():
        raise NotDrawn("no Voronoi cell is closed")
    scale = _scale(solid_fraction[closed])
    panel = make_panels(run, state, [BAR_ROW])[0]
    add_walls(panel, run, state)
    width = 0.05 * run.attributes["grain_diameter"] * panel.points_per_length
    edge = dict(edgecolor="white", linewidth=min(0.4, width))
    add_cells(panel, run, [cells[k] for k in np.flatnonzero(bounded & ~closed)], facecolor=style.FAINT, **edge)
    shown = [cells[k] for k in np.flatnonzero(closed)]
    colours = add_cells(panel, run, shown, array=solid_fraction[closed], cmap=style.PACKING, norm=scale, **edge)
    add_discs(panel, run, state, state.grains.held, facecolor=style.HELD, edgecolor="white", linewidth=0.25)
    below, above = (solid_fraction[closed] < scale.vmin).any(), (solid_fraction[closed] > scale.vmax).any()
    extend = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}[below, above]
    handles = [Patch(facecolor=style.FAINT, label="open cell")] if (bounded & ~closed).any() else []
    colour_bar_above(panel, colours, "solid fraction of the cell", handles, extend)
    return panel.figure


def _scale(values):
    low, high = np.percentile(values, PERCENTILES)
    low, high = STEP * np.floor(low / STEP), STEP * np.ceil(high / STEP)
    return Normalize(low, max(high, low + STEP))
