# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""A line between the centres of each pair in contact: lighter regions are looser (Baxter et al. 1997, Fig. 2)."""

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.grain_panel import make_panel
from repose.pictures.run.shapes import add_discs, add_lines, add_walls, centre_lines


def draw(run, state):
    """Figure of one state."""
    if len(state.contacts) == 0:
        raise NotDrawn("no contacts")
    lines, _ = centre_lines(run, state)
    panel = make_panel(run, state, with_legend=False)
    width = 0.09 * run.attributes["grain_diameter"] * panel.points_per_length
    add_walls(panel, run, state)
    add_discs(panel, run, state, state.grains.held, facecolor=style.FAINT, linewidth=0.0)
    add_lines(panel, lines, min(max(width, 0.15), 0.8), style.INK)
    return panel.figure
