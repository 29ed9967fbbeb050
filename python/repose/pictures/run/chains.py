# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Clusters of strong contacts: those above the mean force that share grains, the largest in colour; and the directions of
contacts. A cluster branches, so it is no chain."""

import numpy as np
from matplotlib.lines import Line2D

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import NO_FORCES, analysis_table
from repose.pictures.run.grain_panel import BOTTOM, LEFT, RIGHT, make_panels
from repose.pictures.run.legends import LEGEND_ROW, legend_above
from repose.pictures.run.shapes import add_discs, add_lines, add_walls, centre_lines

WIDEST = 0.5  # grain diameters: line width of forces at and above the WIDEST_PERCENTILE of those in clusters
WIDEST_PERCENTILE = 99.5
LEVELS = 16  # of line width
LEAST_CONTACTS = 3  # of a cluster that gets its own colour
HISTOGRAM = 1.05  # inch, its height
HANDLE_WIDTH, REST_OF_LEGEND = 0.58, 2.45  # inch


def draw(run, state):
    """Figure of the last state."""
    chains, forces = (analysis_table(run, state, group, NO_FORCES) for group in ("chains", "forces"))
    chain = chains["chain"]
    if not (chain >= 0).any():
        raise NotDrawn("no contact carries more than the mean force")
    panel = make_panels(run, state, [LEGEND_ROW], below=HISTOGRAM + BOTTOM)[0]
    held = state.grains.held
    add_walls(panel, run, state)
    add_discs(panel, run, state, ~held, facecolor="#eff1f4", edgecolor="#d3d8df", linewidth=0.25)
    add_discs(panel, run, state, held, facecolor=style.FAINT, edgecolor="white", linewidth=0.25)
    space = int((panel.figure.get_figwidth() - REST_OF_LEGEND) / HANDLE_WIDTH)
    own = min(len(style.SERIES), space, np.count_nonzero(chains["contacts"] >= LEAST_CONTACTS))
    _add_chains(panel, run, state, np.minimum(chain, own), own)
    handles = [_handle(style.SERIES[k], f"{chains['contacts'][k]}") for k in range(own)]
    others = len(chains["contacts"]) - own
    if others:
        kind = ("others" if others > 1 else "other") if own else "small"
        handles.append(_handle(style.GREY, f"{others} {kind}"))
    legend_above(panel, handles, "contacts per strong cluster")
    _histogram(panel, forces)
    return panel.figure


def _add_chains(panel, run, state, chain, own):
    """Lines of the contacts of each cluster; clusters from number `own` on are grey."""
    size = np.abs(np.nan_to_num(state.contacts.normal_force))
    largest = np.percentile(size[chain >= 0], WIDEST_PERCENTILE)
    level = np.ceil(LEVELS * np.minimum(size / largest, 1.0)).astype(int)
    lines, contact = centre_lines(run, state)
    widest = WIDEST * run.attributes["grain_diameter"] * panel.points_per_length
    for k, colour in [(own, style.GREY), *((k, style.SERIES[k]) for k in reversed(range(own)))]:
        for step in range(1, LEVELS + 1):
            drawn = ((chain == k) & (level == step))[contact]
            if drawn.any():
                add_lines(panel, lines[drawn], widest * step / LEVELS, colour)


def _handle(colour, name):
    return Line2D([], [], color=colour, linewidth=2.0, solid_capstyle="butt", label=name)


def _histogram(panel, forces):
    """Directions of all contacts above the force threshold, and of those above the mean force."""
    width, height = panel.figure.get_size_inches()
    axes = panel.figure.add_axes(
        [LEFT / width, BOTTOM / height, 1.0 - (LEFT + RIGHT) / width, (HISTOGRAM - 0.1) / height]
    )
    direction = forces["direction_deg"]
    width = 180.0 / len(direction)
    edges = direction[0] + width * (np.arange(len(direction) + 2) - 0.5)  # once more beyond 180, where the first bin ends
    axes.axhline(1.0 / 180.0, color=style.GREY, linewidth=0.7, linestyle=":", label="isotropic")
    for name, colour, label in (
        ("direction_all", style.GREY, "all contacts"),
        ("direction_strong", style.ORANGE, "above the mean force"),
    ):
        axes.stairs([*forces[name], forces[name][0]], edges, color=colour, linewidth=1.2, label=label)
    axes.set_xlim(0.0, 180.0)
    top = np.nanmax([*forces["direction_all"], *forces["direction_strong"], 1.0 / 180.0])
    axes.set_ylim(0.0, 1.35 * top)
    axes.set_xticks(range(0, 181, 30))
    axes.locator_params(axis="y", nbins=4)
    axes.set_xlabel("direction of the contact from the horizontal (deg)")
    axes.set_ylabel("density (1/deg)")
    axes.legend(loc="upper right", ncol=3)
