# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Upright section of a heap of spheres, coloured by the solid fraction of their Voronoi cells; open cells are grey."""

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.patches import Patch

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import analysis_table
from repose.pictures.run.legends import BAR_ROW, colour_bar_above
from repose.pictures.run.space_box import space_box
from repose.pictures.spheres.panels import edge_width, make_views
from repose.pictures.spheres.places import add_circles, circles_in, upright_plane
from repose.pictures.spheres.section import where
from repose.pictures.spheres.wall_sections import add_wall_sections

PERCENTILES = (1.0, 99.0)  # of the closed cells, which the colours span
STEP = 0.02  # in solid fraction; the scale ends at multiples of it


def draw(run, state):
    """Figure of the last state."""
    cells = analysis_table(run, state, "voronoi", "there is no heap")
    fraction = np.full(len(state.grains), np.nan)
    closed = cells["closed"].astype(bool) & np.isfinite(cells["solid_fraction"])
    if not closed.any():
        raise NotDrawn("no Voronoi cell is closed")
    fraction[state.rows(cells["id"][closed])] = cells["solid_fraction"][closed]
    low, high = np.percentile(cells["solid_fraction"][closed], PERCENTILES)
    low, high = STEP * np.floor(low / STEP), STEP * np.ceil(high / STEP)
    plane = upright_plane(space_box(run, state))
    (panel,) = make_views(run, state, [plane], [BAR_ROW], remark=where(run, plane))
    add_wall_sections(panel, run, state, plane)
    centre, radius, row = circles_in(run, state, plane, panel.box)
    held = state.grains.held[row]
    known = np.isfinite(fraction[row]) & ~held
    edge = edge_width(run, panel)
    for chosen, colour in ((held, style.HELD), (~held & ~known, style.FAINT)):
        add_circles(panel, centre[chosen], radius[chosen], facecolors=colour, edgecolors="white", linewidths=0.5 * edge)
    drawing = dict(edgecolors="white", linewidths=0.5 * edge, cmap=style.PACKING, norm=Normalize(low, max(high, low + STEP)))
    circles = add_circles(panel, centre[known], radius[known], array=fraction[row[known]], **drawing)
    handles = [Patch(facecolor=style.FAINT, label="open cell")] if (~held & ~known).any() else []
    colour_bar_above(panel, circles, "solid fraction of the cell", handles, extend="both")
    return panel.figure
