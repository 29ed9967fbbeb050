# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Panels of the directions of contacts from the vertical, pooled over the members of a point (Bratberg 2003, paper one,
Fig. 9)."""

import numpy as np
from matplotlib.ticker import MaxNLocator

from repose import style
from repose.errors import NotDrawn


def draw(axes, study, panel):
    """pi p(theta), which is 1 where all directions are equally frequent; an outline for each point."""
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    points = panel["points"]
    for k, (point, label) in enumerate(zip(points, panel.get("labels", points))):
        direction, density = _pooled(study, point)
        angle = np.radians(np.concatenate([direction, direction + 180.0]))
        closed = np.append(np.tile(density, 2), density[0])
        colour = style.SERIES[k % len(style.SERIES)]
        axes.plot(np.append(angle, angle[0]), closed, color=colour, linewidth=1.1, label=label)
        axes.fill(np.append(angle, angle[0]), closed, color=style.pale(colour, 0.25), zorder=0.5)
    axes.set_thetagrids(range(0, 360, 30), [f"{k if k <= 180 else k - 360}°" for k in range(0, 360, 30)])
    axes.yaxis.set_major_locator(MaxNLocator(3, prune="lower"))
    axes.grid(color=style.FAINT, linewidth=0.4)
    if len(points) > 1:
        axes.legend(loc="lower right", bbox_to_anchor=(1.25, -0.1))


def _pooled(study, point):
    """Middles of the bins [deg], and the density of all contacts of the members."""
    count, direction = 0.0, None
    for run in study.runs(point):
        table = run.analysis and run.analysis.packing and run.analysis.packing.parts["directions"]
        if not table:
            raise NotDrawn(f"{point}: no directions of contacts were measured")
        count, direction = count + table["count"], table["direction_deg"]
    return direction, count / count.sum() * len(count)
