# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The grains of a packing, coloured by the number of their contacts, and the slab that is measured."""

import numpy as np
from matplotlib.patches import Patch

from repose import style
from repose.pictures.run.analysis_parts import measured_packing
from repose.pictures.run.grain_panel import make_panels
from repose.pictures.run.legends import LEGEND_ROW, legend_above
from repose.pictures.run.shapes import add_discs

MOST = 6  # contacts; grains with more have the same colour


def draw(run, state):
    """Figure of the last state."""
    packing = measured_packing(run, state)
    grains = state.grains
    neighbours = np.minimum(packing["neighbours"][np.searchsorted(packing["id"], grains.id)], MOST)
    panel = make_panels(run, state, [LEGEND_ROW])[0]
    edge = min(0.3, 0.04 * run.attributes["grain_diameter"] * panel.points_per_length)
    handles = []
    for count, colour in enumerate(style.NEIGHBOURS):
        chosen = (neighbours == count) & ~grains.base
        if chosen.any():
            add_discs(panel, run, state, chosen, facecolor=colour, edgecolor="white", linewidth=edge)
            handles.append(Patch(facecolor=colour, label=f"{count}{'+' if count == MOST else ''}"))
    add_discs(panel, run, state, grains.base, facecolor=style.HELD, edgecolor="white", linewidth=edge)
    for end in ("slab_low", "slab_high"):
        if panel.box.y_min < packing.attributes[end] < panel.box.y_max:
            panel.axes.axhline(packing.attributes[end], color=style.INK, linewidth=0.8, linestyle="--")
    legend_above(panel, handles, "contacts per grain")
    return panel.figure
