# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Discs, planes and the lines between centres, as collections."""

import numpy as np
from matplotlib.collections import EllipseCollection, LineCollection

from repose import style


def draw_discs(axes, state, chosen, face, edge, line_width=0.3):
    """Filled circles of the chosen grains (boolean mask)."""
    diameter = 2.0 * state.radius[chosen]
    discs = EllipseCollection(
        diameter,
        diameter,
        np.zeros_like(diameter),
        units="xy",
        offsets=state.position[chosen],
        transOffset=axes.transData,
        facecolors=face,
        edgecolors=edge,
        linewidths=line_width,
        rasterized=chosen.sum() > style.MOST_VECTORS,
    )
    axes.add_collection(discs)


def draw_planes(axes, run, window):
    """The trace of every plane through the window."""
    if not run.has("planes"):
        return
    reach = 2.0 * (window[1] - window[0] + window[3] - window[2])
    for point, normal in zip(run.values("planes/point"), run.values("planes/normal")):
        along = np.array([-normal[1], normal[0]])
        centre = np.array([0.5 * (window[0] + window[1]), 0.5 * (window[2] + window[3])])
        foot = centre - normal * np.dot(centre - point, normal)
        ends = np.array([foot - reach * along, foot + reach * along])
        axes.plot(ends[:, 0], ends[:, 1], color=style.BLACK, linewidth=1.0, scalex=False, scaley=False)


def centre_lines(run, state):
    """Line segments (K, 2, 2) [L] from the first to the second partner of each contact, and the contact of each (K).

    To a plane the line ends at the plane; across a periodic boundary it is drawn as two halves, one at either side.
    """
    if len(state.pairs) == 0:
        return np.empty((0, 2, 2)), np.empty(0, dtype=int)
    first = state.places(state.pairs[:, 0])
    to_plane = state.pairs[:, 1] < 0
    second = np.where(to_plane, first, state.places(np.maximum(state.pairs[:, 1], 0)))
    start = state.position[first]
    end = state.position[second]
    mean_diameter = state.radius[first] + state.radius[second]
    way = -state.normal * (mean_diameter - state.overlap)[:, None]
    way[to_plane] *= 0.5
    end = np.where(to_plane[:, None], start + way, end)
    number = np.arange(len(state.pairs))
    lines = np.stack([start, end], axis=1)
    if not run.attribute("periodic"):
        return lines, number
    width = float(run.attribute("x_max")) - float(run.attribute("x_min"))
    across = ~to_plane & (np.abs(end[:, 0] - start[:, 0]) > 0.5 * width)
    here = np.stack([start[across], start[across] + 0.5 * way[across]], axis=1)
    there = np.stack([end[across], end[across] - 0.5 * way[across]], axis=1)
    return (
        np.concatenate([lines[~across], here, there]),
        np.concatenate([number[~across], number[across], number[across]]),
    )


def draw_lines(axes, lines, **how):
    axes.add_collection(LineCollection(lines, rasterized=len(lines) > style.MOST_VECTORS, capstyle="round", **how))
