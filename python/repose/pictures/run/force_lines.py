# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Lines of force: the strongest, or the weakest, contact of each moving grain, its width proportional to the normal force.
Where such contacts join, they run on from grain to grain."""

import numpy as np

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import NO_FORCES, analysis_table
from repose.pictures.run.force_widths import add_forces, handle_of_force, levels_of, scale_of_forces, widest_line
from repose.pictures.run.grain_panel import make_panel
from repose.pictures.run.legends import legend_above
from repose.pictures.run.shapes import add_discs, add_walls, centre_lines

LEAST_LEVEL = 2  # of line width: that of the thinnest lines, which would be lost otherwise


def draw_strongest(run, state):
    """Figure of the strongest contacts of the last state."""
    return _draw(run, state, "strongest")


def draw_weakest(run, state):
    """Figure of the weakest contacts of the last state."""
    return _draw(run, state, "weakest")


def _draw(run, state, which):
    table = analysis_table(run, state, "force_lines", NO_FORCES)
    rows = np.unique(table[which])  # two grains may have the same
    force = np.nan_to_num(state.contacts.normal_force)
    largest = force[rows].max(initial=0.0)
    if not largest > 0.0:
        raise NotDrawn("no contact carries a force")
    panel = make_panel(run, state, with_legend=True)
    held = state.grains.held
    add_walls(panel, run, state)
    add_discs(panel, run, state, ~held, facecolor="#eff1f4", edgecolor="#d3d8df", linewidth=0.25)
    add_discs(panel, run, state, held, facecolor=style.FAINT, edgecolor="white", linewidth=0.25)
    lines, contact = centre_lines(run, state)
    level = np.maximum(LEAST_LEVEL, levels_of(force, largest))[contact]
    chosen = np.isin(contact, rows)
    horizontal = _horizontal(state, table.attributes["horizontal_within"])[contact]
    widest = widest_line(run, panel)
    for drawn, colour in ((chosen & ~horizontal, style.INK), (chosen & horizontal, style.ORANGE)):
        add_forces(panel, lines[drawn], level[drawn], widest, colour)
    weight = run.attributes["grain_weight"]
    unit = weight if weight > 0.0 else 1.0
    handles = scale_of_forces(largest / unit, widest, steps=2)
    if (chosen & horizontal).any():
        handles.append(handle_of_force(style.ORANGE, 0.4 * widest, "horizontal"))
    title = f"{which} contact" + (", in grain weights" if weight > 0.0 else "")
    legend_above(panel, handles, title)
    return panel.figure


def _horizontal(state, within):
    """Whether a contact (K) joins two grains and its normal lies within this angle [deg] of the horizontal."""
    steepness = np.abs(state.contacts.normal[:, 1])
    return (state.contacts.grains[:, 1] >= 0) & (steepness <= np.sin(np.radians(within)))
