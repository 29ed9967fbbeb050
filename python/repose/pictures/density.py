# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Centre-to-centre vectors of all contacts: lighter regions are looser (Baxter et al. 1997, Fig. 2)."""

from repose import style
from repose.field import make_field
from repose.marks import add_discs, add_lines, add_walls, centre_lines
from repose.not_drawn import NotDrawn


def draw(run, state):
    """Figure of one state."""
    if len(state.contacts) == 0:
        raise NotDrawn("no contacts")
    lines, _ = centre_lines(run, state)
    field = make_field(run, state, with_legend=False)
    width = 0.09 * run.attributes["grain_diameter"] * field.points_per_length
    add_walls(field, run, state)
    add_discs(field, run, state, state.grains.held, facecolor=style.FAINT, linewidth=0.0)
    add_lines(field, lines, min(max(width, 0.15), 0.8), style.INK)
    return field.figure
