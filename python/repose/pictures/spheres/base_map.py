# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Forces of a heap on the spheres of its base, seen from above: normal forces in colours, shear as arrows of means over cells."""

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.common_axes import largest_force
from repose.pictures.run.grain_panel import AXES_HEIGHT, AXES_WIDTH, LARGEST_GRAIN, LEAST_AXES_WIDTH, stack_panels, widened
from repose.pictures.run.legends import BAR_ROW, LEGEND_ROW, colour_bar_above, legend_above
from repose.pictures.run.visible_box import Box
from repose.pictures.spheres.panels import left_edge
from repose.pictures.spheres.places import add_circles

MARGIN = 2.0  # grain diameters around the loaded part
ARROWS = 14  # cells across the loaded part
LEAST_CELL = 3.0  # grain diameters


def draw(run, state):
    """Figure of the time window at the end of the run."""
    if state.frame:
        raise NotDrawn("it shows the end of the run, not a frame")
    if run.base is None:
        raise NotDrawn("there is no base of grains")
    normal, shear = run.base["normal"], np.column_stack([run.base["shear"], run.base["shear_y"]])
    loaded = (normal != 0.0) | (shear != 0.0).any(axis=1)
    if not loaded.any():
        raise NotDrawn("nothing rests on the base")
    place = np.column_stack([run.base["x"], run.base["y"]])
    panel = _panel(run, state, place[loaded])
    units = style.units_of(run)
    radius = _radii(run, state)
    seen = panel.box.near(place, radius)
    largest = largest_force(normal[normal > 0.0]) or 1.0
    edge = dict(edgecolors=style.FAINT, linewidths=0.25)
    idle, busy = seen & ~loaded, seen & loaded
    add_circles(panel, place[idle], radius[idle], facecolors="white", **edge)
    drawing = dict(cmap=style.LOAD, norm=Normalize(0.0, largest), array=normal[busy], **edge)
    circles = add_circles(panel, place[busy], radius[busy], **drawing)
    title = "normal force on a base grain" + (f" ({units.force_word()})" if units.force_word() else "")
    colour_bar_above(panel, circles, title, extend="max" if (normal > largest).any() else "neither")
    _add_arrows(panel, run, place[loaded], shear[loaded], units)
    _add_axis(panel, run)
    style.caption(panel.figure, _window(run, units))
    return panel.figure


def _panel(run, state, place):
    margin = MARGIN * run.attributes["grain_diameter"]
    (x_min, y_min), (x_max, y_max) = place.min(axis=0) - margin, place.max(axis=0) + margin
    scale = min(AXES_WIDTH / (x_max - x_min), AXES_HEIGHT / (y_max - y_min), LARGEST_GRAIN / run.attributes["grain_diameter"])
    box = widened(Box(x_min, x_max, y_min, y_max), LEAST_AXES_WIDTH / scale)
    return stack_panels(run, state, [(box, "xy")], scale, [BAR_ROW + LEGEND_ROW], left=left_edge(run))[0]


def _radii(run, state):
    """Of the base grains (B) [L]."""
    grains = state.grains
    rows = np.minimum(np.searchsorted(grains.id, run.base["id"]), max(0, len(grains) - 1))
    same = grains.id[rows] == run.base["id"]
    return np.where(same, grains.radius[rows], 0.5 * run.attributes["grain_diameter"])


def mean_shear(place, shear, cell):
    """Middles (K, 2) [L] of the square cells of a side `cell` that hold base grains, and the mean shear force in each (K, 2)."""
    index = np.floor(place / cell).astype(int)
    cells, which = np.unique(index, axis=0, return_inverse=True)
    which = which.reshape(-1)
    count = np.bincount(which)
    means = np.column_stack([np.bincount(which, weights=shear[:, axis]) / count for axis in (0, 1)])
    return (cells + 0.5) * cell, means


def _add_arrows(panel, run, place, shear, units):
    extent = np.ptp(place, axis=0).max()
    cell = max(LEAST_CELL * run.attributes["grain_diameter"], extent / ARROWS)
    middle, mean = mean_shear(place, shear, cell)
    largest = np.hypot(*mean.T).max()
    if not largest > 0.0:
        return
    length = cell / largest
    panel.axes.quiver(
        *middle.T, *(length * mean).T, angles="xy", scale_units="xy", scale=1.0, width=0.8 / 72.0, units="inches",
        color=style.ORANGE, pivot="middle", headwidth=4.0, headlength=4.5, headaxislength=4.0, zorder=2.5,
    )  # fmt: skip
    name = f"mean shear force in a cell of {units.length_value(cell)}; the longest is {largest:.3g} {units.force_word()}".rstrip()
    legend_above(panel, [Line2D([], [], color=style.ORANGE, linewidth=1.2, label=name)], down=BAR_ROW)


def _add_axis(panel, run):
    surface = run.analysis and run.analysis["cone_surface"]
    if surface:
        at = surface.attributes["axis_x"], surface.attributes["axis_y"]
        panel.axes.plot(*at, "+", color=style.INK, markersize=7, markeredgewidth=1.0, zorder=3)


def _window(run, units):
    window = run.base.attributes
    begin, until = window.get("window_start", run.state.time), window.get("window_end", run.state.time)
    text = f"mean over t = {begin:.6g} to {units.time_value(until)}" if begin < until else f"at t = {units.time_value(until)}"
    surface = run.analysis and run.analysis["cone_surface"]
    return text + ("; +: axis of the heap" if surface else "")
