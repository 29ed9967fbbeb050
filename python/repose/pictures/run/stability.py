# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The mode of the smallest eigenvalue of the stiffness matrix: an arrow on each grain, along its displacement. Below zero the
pile is unstable, and begins to move like this or the other way round."""

import numpy as np
from matplotlib.lines import Line2D

from repose import style
from repose.pictures.run.analysis_parts import analysis_table
from repose.pictures.run.grain_panel import make_panel
from repose.pictures.run.legends import legend_above
from repose.pictures.run.shapes import add_discs, add_walls
from repose.pictures.run.visible_box import wrapped

LONGEST = 2.5  # grain diameters: the arrow of the largest displacement
SHORTEST = 0.15  # grain diameters: shorter arrows are left out
WIDTH = 0.14  # grain diameters


def draw(run, state):
    """Figure of the last state."""
    mode = analysis_table(run, state, "stability", "its stability was not analysed (repose analyse DIR --stability)")
    smallest = float(mode.attributes["smallest"])
    panel = make_panel(run, state, with_legend=True)
    held = state.grains.held
    add_walls(panel, run, state)
    add_discs(panel, run, state, ~held, facecolor="#eff1f4", edgecolor="#d3d8df", linewidth=0.25)
    add_discs(panel, run, state, held, facecolor=style.FAINT, edgecolor="white", linewidth=0.25)
    diameter = run.attributes["grain_diameter"]
    arrow = LONGEST * diameter * mode["displacement"]
    centre = wrapped(run, state.grains.position[state.rows(mode["id"])])
    long = np.hypot(*arrow.T) > SHORTEST * diameter
    colour = style.ORANGE if smallest < 0.0 else style.BLUE
    panel.axes.quiver(
        *(centre - 0.5 * arrow)[long].T, *arrow[long].T, angles="xy", scale_units="xy", scale=1.0, units="xy",
        width=WIDTH * diameter, headwidth=3.2, headlength=3.5, headaxislength=3.2, minlength=0.1, color=colour, zorder=2.0,
    )  # fmt: skip
    unit = " grain weights per diameter" if run.attributes["grain_weight"] > 0.0 else ""
    kind = "unstable" if smallest < 0.0 else "stable"
    handle = Line2D([], [], color=colour, linewidth=1.5, label=f"{kind}: {smallest:.4g}{unit}")
    legend_above(panel, [handle], "mode of the smallest eigenvalue")
    return panel.figure
