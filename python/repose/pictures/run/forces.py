# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Force network: a line between the centres of each pair in contact, its width proportional to the normal force."""

import numpy as np

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.common_axes import largest_force, sizes_of_forces
from repose.pictures.run.force_widths import add_forces, handle_of_force, levels_of, scale_of_forces, widest_line
from repose.pictures.run.grain_panel import make_panel
from repose.pictures.run.legends import legend_above
from repose.pictures.run.shapes import add_discs, add_walls, centre_lines


def draw(run, state):
    """Figure of one state; forces in grain weights, or in the units of the scene where there is no gravity."""
    largest = largest_of(run, state)
    panel = make_panel(run, state, with_legend=True)
    add_network(panel, run, state, largest)
    return panel.figure


def largest_of(run, state):
    """The force of the widest line, in the unit of the picture; NotDrawn without a force."""
    largest = state.axes.largest_force if state.axes else largest_force(sizes_of_forces(state))
    if not largest > 0.0:
        raise NotDrawn("no contact carries a force")
    return largest / _unit(run)


def _unit(run):
    weight = run.attributes["grain_weight"]
    return weight if weight > 0.0 else 1.0


def add_network(panel, run, state, largest):
    """Walls, grains and forces of a state, with their legend above the axes."""
    held = state.grains.held
    add_walls(panel, run, state)
    add_discs(panel, run, state, ~held, facecolor="#eff1f4", edgecolor="#d3d8df", linewidth=0.25)
    add_discs(panel, run, state, held, facecolor=style.FAINT, edgecolor="white", linewidth=0.25)
    add_force_lines(panel, run, state, *centre_lines(run, state), largest)


def add_force_lines(panel, run, state, lines, contact, largest):
    """Lines (K, 2, 2) [L] of the forces in the contacts of these rows (K), with their legend above the axes."""
    force = np.nan_to_num(state.contacts.normal_force[contact] / _unit(run))
    widest = widest_line(run, panel)
    level = levels_of(np.abs(force), largest)
    handles = []
    for chosen, colour, name in _kinds(force, state.contacts.sliding[contact]):
        add_forces(panel, lines[chosen], level[chosen], widest, colour)
        if (chosen & (level > 0)).any() and name:
            handles.append(handle_of_force(colour, 0.4 * widest, name))
    title = "normal force in grain weights" if run.attributes["grain_weight"] > 0.0 else "normal force"
    legend_above(panel, scale_of_forces(largest, widest) + handles, title)


def _kinds(force, sliding):
    """(mask of the contacts, colour, name in the legend), in order of drawing."""
    attractive = force < 0.0
    return (
        (~attractive & ~sliding, style.INK, None),
        (~attractive & sliding, style.ORANGE, "sliding"),
        (attractive, style.BLUE, "attractive"),
    )

