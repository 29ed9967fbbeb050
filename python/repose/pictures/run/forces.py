# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Force network: a line between the centres of each pair in contact, its width proportional to the normal force."""

import numpy as np
from matplotlib.lines import Line2D

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.common_axes import largest_force, sizes_of_forces
from repose.pictures.run.grain_panel import make_panel
from repose.pictures.run.legends import legend_above
from repose.pictures.run.shapes import add_discs, add_lines, add_walls, centre_lines

WIDEST = 0.5  # grain diameters
LEVELS = 32  # of line width; lines below half a level are left out


def draw(run, state):
    """Figure of one state; forces in grain weights, or in the units of the scene where there is no gravity."""
    weight = run.attributes["grain_weight"]
    unit = weight if weight > 0.0 else 1.0
    force = np.nan_to_num(state.contacts.normal_force / unit)
    size = np.abs(force)
    largest = (state.axes.largest_force if state.axes else largest_force(sizes_of_forces(state))) / unit
    if not largest > 0.0:
        raise NotDrawn("no contact carries a force")
    lines, contact = centre_lines(run, state)
    panel = make_panel(run, state, with_legend=True)
    held = state.grains.held
    add_walls(panel, run, state)
    add_discs(panel, run, state, ~held, facecolor="#eff1f4", edgecolor="#d3d8df", linewidth=0.25)
    add_discs(panel, run, state, held, facecolor=style.FAINT, edgecolor="white", linewidth=0.25)

    widest = WIDEST * run.attributes["grain_diameter"] * panel.points_per_length
    level = np.round(LEVELS * np.minimum(size / largest, 1.0)).astype(int)
    handles = []
    for chosen, colour, name in _kinds(force, state.contacts.sliding):
        for k in range(1, LEVELS + 1):
            drawn = (chosen & (level == k))[contact]
            if drawn.any():
                add_lines(panel, lines[drawn], widest * k / LEVELS, colour)
        if (chosen & (level > 0)).any() and name:
            handles.append(_handle(colour, 0.4 * widest, name))
    scale = [_handle(style.INK, widest * part / largest, f"{part:g}") for part in _round_steps(largest)]
    scale.append(_handle(style.INK, widest, f"≥ {largest:.3g}"))
    title = "normal force in grain weights" if weight > 0.0 else "normal force"
    legend_above(panel, scale + handles, title)
    return panel.figure


def _kinds(force, sliding):
    """(mask of the contacts, colour, name in the legend), in order of drawing."""
    attractive = force < 0.0
    return (
        (~attractive & ~sliding, style.INK, None),
        (~attractive & sliding, style.ORANGE, "sliding"),
        (attractive, style.BLUE, "attractive"),
    )


def _handle(colour, width, name):
    return Line2D([], [], color=colour, linewidth=width, solid_capstyle="butt", label=name)


def _round_steps(largest):
    """Three values of the sequence 1, 2, 5, 10, ... below `largest`, ascending."""
    power = np.floor(np.log10(largest))
    sequence = [step * 10.0 ** (power + k) for k in (-1, 0) for step in (1, 2, 5)]
    return [value for value in sequence if value <= 0.8 * largest][-3:]
