# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Solid fraction in colours, and a line between the centres of each pair in contact (Baxter et al. 1997, Fig. 2)."""

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.grain_panel import make_panels
from repose.pictures.run.legends import BAR_ROW, LEGEND_ROW, colour_bar_above, legend_above
from repose.pictures.run.shapes import add_discs, add_lines, add_walls, centre_lines
from repose.pictures.run.stress import LEAST, RANGE, before_walls, field_map

STEP = 0.05  # in solid fraction; the scale ends at a multiple of it
CONTACT = "pair in contact; lines are sparse where the packing is loose"


def draw(run, state):
    """Figure of one state. A frame has no colours, as the field belongs to the last state."""
    if len(state.contacts) == 0 and state.axes is None:
        raise NotDrawn("no contacts")
    table = None if state.frame or run.analysis is None else run.analysis["fields"]
    bar = BAR_ROW if table is not None or (state.axes and run.analysis and run.analysis["fields"]) else 0.0
    panel = make_panels(run, state, [LEGEND_ROW + bar])[0]
    if table is not None:
        _colours(panel, table, style.units_of(run))
    add_walls(panel, run, state)
    add_discs(panel, run, state, state.grains.held, facecolor=style.FAINT, edgecolor="white", linewidth=0.25)
    width = min(max(0.09 * run.attributes["grain_diameter"] * panel.points_per_length, 0.15), 0.8)
    add_lines(panel, centre_lines(run, state)[0], width, style.INK)
    legend_above(panel, [Line2D([], [], color=style.INK, linewidth=width, label=CONTACT)], down=bar if table is not None else 0.0)
    return panel.figure


def _colours(panel, table, units):
    """The coarse-grained solid fraction, its colour bar above the panel."""
    filled = before_walls(table, "solid_fraction")
    shown = np.ma.masked_where(filled < LEAST, filled)
    top = STEP * np.ceil((shown.max() or 1.0) / STEP)
    colours = field_map(panel, table, shown, style.LOAD, Normalize((1.0 - RANGE) * top, top))
    title = f"solid fraction, Gaussian of width {units.length_value(table.attributes['width'])}"
    colour_bar_above(panel, colours, title, extend="min")
