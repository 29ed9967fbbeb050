# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The grains of a packing, coloured by the number of grains that each touches; the slab that is measured."""

import numpy as np
from matplotlib.patches import Patch

from repose import style
from repose.field import LEGEND_ROW, legend_above, make_fields
from repose.marks import add_discs
from repose.pictures.needed import packing_of

MOST = 6  # neighbours that have a colour of their own; more look the same


def draw(run, state):
    """Figure of the last state."""
    packing = packing_of(run, state)
    grains = state.grains
    neighbours = np.minimum(packing["neighbours"][np.searchsorted(packing["id"], grains.id)], MOST)
    field = make_fields(run, state, [LEGEND_ROW])[0]
    edge = min(0.3, 0.04 * run.attributes["grain_diameter"] * field.points_per_length)
    keys = []
    for count, colour in enumerate(style.NEIGHBOURS):
        chosen = (neighbours == count) & ~grains.base
        if chosen.any():
            add_discs(field, run, state, chosen, facecolor=colour, edgecolor="white", linewidth=edge)
            keys.append(Patch(facecolor=colour, label=f"{count}{'+' if count == MOST else ''}"))
    add_discs(field, run, state, grains.base, facecolor=style.HELD, edgecolor="white", linewidth=edge)
    for end in ("slab_low", "slab_high"):
        if field.box.y_min < packing.attributes[end] < field.box.y_max:
            field.axes.axhline(packing.attributes[end], color=style.INK, linewidth=0.8, linestyle="--")
    legend_above(field, keys, "touching grains")
    return field.figure
