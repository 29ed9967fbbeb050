# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The discs of a heap, each species in its colour, and the lines through its flanks that give the angles of repose."""

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from repose import style
from repose.pictures.run.grain_panel import make_panels
from repose.pictures.run.legends import LEGEND_ROW, legend_above
from repose.pictures.run.shapes import add_discs, add_walls
from repose.pictures.run.species import kinds_of, members_of

FLANKS = (("left", 1.0, style.ORANGE), ("right", -1.0, style.PURPLE))  # name, sign of a slope that descends outwards


def draw(run, state):
    """Figure of one state; a frame has no lines along the flanks, as those belong to the last state."""
    flanks = [] if state.frame or run.surface is None else list(_flanks(run.surface))
    kinds = kinds_of(run)
    with_flanks = bool(flanks) or (state.axes is not None and run.surface is not None)
    rows = (len(kinds) > 1) + with_flanks
    panel = make_panels(run, state, [rows * LEGEND_ROW])[0]
    edge = min(0.5, 0.06 * run.attributes["grain_diameter"] * panel.points_per_length)
    held = state.grains.held
    add_walls(panel, run, state)
    member = members_of(kinds, state.grains)
    for k in range(len(kinds)):
        add_discs(panel, run, state, ~held & (member == k), facecolor=_colour(k), edgecolor=style.GRAIN_EDGE, linewidth=edge)
    add_discs(panel, run, state, held, facecolor=style.HELD, edgecolor="white", linewidth=0.5 * edge)
    for line, extension in flanks:
        panel.axes.add_line(extension)
        panel.axes.add_line(line)
    if len(kinds) > 1:
        legend_above(panel, [_patch(k, kind) for k, kind in enumerate(kinds)], "grains")
    if flanks:
        down = (rows - 1) * LEGEND_ROW
        legend_above(panel, [line for line, _ in flanks], "angle of repose", down)
    return panel.figure


def _colour(k):
    return style.SPECIES[k % len(style.SPECIES)]


def _patch(k, kind):
    return Patch(facecolor=_colour(k), edgecolor=style.GRAIN_EDGE, linewidth=0.4, label=kind.name)


def _flanks(surface):
    """For each flank with a line: the line over the bins that it was fitted to, and its extension down to the base."""
    values = surface.attributes
    used = surface["used"].astype(bool)
    half_bin = 0.5 * values["bin_width"]
    for name, outward, colour in FLANKS:
        slope, intercept = values[f"{name}_slope"], values[f"{name}_intercept"]
        x = surface["x"][used & (outward * (values["apex_x"] - surface["x"]) > 0.0)]
        if not np.isfinite([slope, intercept]).all() or len(x) == 0:
            continue
        ends = np.array([x.min() - half_bin, x.max() + half_bin])
        angle = np.degrees(np.arctan(outward * slope))
        label = f"{name} flank {angle:.1f}°"
        line = Line2D(ends, values["base_y"] + slope * ends + intercept, color=colour, linewidth=1.3, label=label)
        foot = -intercept / slope if outward * slope > 0.0 else np.nan
        outer = ends[0] if outward > 0.0 else ends[1]
        tail_y = values["base_y"] + np.array([slope * outer + intercept, 0.0])
        yield line, Line2D([outer, foot], tail_y, color=colour, linewidth=0.7, linestyle="--")
