# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Forces of a heap on its base, seen from above: normal forces on base grains, or the pressure on cells of a floor, in colours;
shear as arrows of means over cells."""

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.common_axes import largest_force
from repose.pictures.run.grain_panel import AXES_HEIGHT, AXES_WIDTH, LARGEST_GRAIN, LEAST_AXES_WIDTH, stack_panels, widened
from repose.pictures.run.legends import BAR_ROW, LEGEND_ROW, colour_bar_above, legend_above
from repose.pictures.run.visible_box import Box
from repose.pictures.spheres.base_cells import add_pressure, corners_of, loaded_cells, mean_shear_of_cells, nearest_cells
from repose.pictures.spheres.panels import left_edge
from repose.pictures.spheres.places import add_circles

MARGIN = 2.0  # grain diameters around the loaded part
ARROWS = 14  # cells across the loaded part
LEAST_CELL = 3.0  # grain diameters
SHOWN_LOAD = 0.995  # of the load of a floor


def draw(run, state):
    """Figure of the time window at the end of the run."""
    if state.frame:
        raise NotDrawn("it shows the end of the run, not a frame")
    if run.base is None or not state.grains.base.any():
        return _draw_floor(run, state)
    normal, shear = run.base["normal"], np.column_stack([run.base["shear"], run.base["shear_y"]])
    loaded = (normal != 0.0) | (shear != 0.0).any(axis=1)
    if not loaded.any():
        raise NotDrawn("nothing rests on the base")
    place = np.column_stack([run.base["x"], run.base["y"]])
    panel = _panel(run, state, place[loaded], MARGIN * run.attributes["grain_diameter"])
    units = style.units_of(run)
    radius, upwards = _radii_and_order(run, state)
    seen = panel.box.near(place, radius)
    largest = largest_force(normal[normal > 0.0]) or 1.0
    edge = dict(edgecolors=style.FAINT, linewidths=0.25)
    idle, busy = (upwards[(seen & part)[upwards]] for part in (~loaded, loaded))
    add_circles(panel, place[idle], radius[idle], facecolors="white", **edge)
    drawing = dict(cmap=style.LOAD, norm=Normalize(0.0, largest), array=normal[busy], **edge)
    circles = add_circles(panel, place[busy], radius[busy], **drawing)
    title = "normal force on a base grain" + (f" ({units.force_word()})" if units.force_word() else "")
    colour_bar_above(panel, circles, title, extend="max" if (normal > largest).any() else "neither")
    cell = max(LEAST_CELL * run.attributes["grain_diameter"], np.ptp(place[loaded], axis=0).max() / ARROWS)
    middle, mean = mean_shear(place[loaded], shear[loaded], cell)
    _add_arrows(panel, middle, mean, cell, f"force in a cell of {units.length_value(cell)}", _force_value(units))
    _add_axis(panel, run)
    style.caption(panel.figure, _window(run, units))
    return panel.figure


def _draw_floor(run, state):
    every, side = loaded_cells(run, state)
    cells = nearest_cells(every, SHOWN_LOAD)
    corners = corners_of(cells, side).reshape(-1, 2)
    panel = _panel(run, state, corners, 0.5 * side.max())
    add_pressure(panel, run, cells, side)
    count = max(1, round((np.ptp(corners, axis=0) / side).max() / ARROWS))
    middle, mean = mean_shear_of_cells(cells, side, count)
    units = style.units_of(run)
    width = count * side.min()
    _add_arrows(panel, middle, mean, width, f"stress in a square of {units.length_value(width)}", units.stress_value)
    _add_axis(panel, run)
    outside = len(every["x"]) - len(cells["x"])
    note = f"; {outside} cells with less than {1.0 - SHOWN_LOAD:.1%} of the load lie outside" if outside else ""
    style.caption(panel.figure, _window(run, units) + note)
    return panel.figure


def _panel(run, state, place, margin):
    (x_min, y_min), (x_max, y_max) = place.min(axis=0) - margin, place.max(axis=0) + margin
    scale = min(AXES_WIDTH / (x_max - x_min), AXES_HEIGHT / (y_max - y_min), LARGEST_GRAIN / run.attributes["grain_diameter"])
    box = widened(Box(x_min, x_max, y_min, y_max), LEAST_AXES_WIDTH / scale)
    return stack_panels(run, state, [(box, "xy")], scale, [BAR_ROW + LEGEND_ROW], left=left_edge(run))[0]


def _radii_and_order(run, state):
    """Radii (B) [L] of the base grains, and their places from the lowest to the highest: those above cover those below."""
    grains = state.grains
    rows = np.minimum(np.searchsorted(grains.id, run.base["id"]), max(0, len(grains) - 1))
    same = grains.id[rows] == run.base["id"]
    radius = np.where(same, grains.radius[rows], 0.5 * run.attributes["grain_diameter"])
    return radius, np.argsort(np.where(same, grains.position[rows, 2], 0.0), kind="stable")


def mean_shear(place, shear, cell):
    """Middles (K, 2) [L] of the square cells of a side `cell` that hold base grains, and the mean shear force in each (K, 2)."""
    index = np.floor(place / cell).astype(int)
    cells, which = np.unique(index, axis=0, return_inverse=True)
    which = which.reshape(-1)
    count = np.bincount(which)
    means = np.column_stack([np.bincount(which, weights=shear[:, axis]) / count for axis in (0, 1)])
    return (cells + 0.5) * cell, means


def _add_arrows(panel, middle, mean, cell, what, text_of):
    """Arrows (K, 2) at places (K, 2), the longest as long as a cell; the legend says `what` they are, and the longest by
    `text_of` it."""
    largest = np.hypot(*mean.T).max()
    if not largest > 0.0:
        return
    length = cell / largest
    panel.axes.quiver(
        *middle.T, *(length * mean).T, angles="xy", scale_units="xy", scale=1.0, width=0.8 / 72.0, units="inches",
        color=style.ORANGE, pivot="middle", headwidth=4.0, headlength=4.5, headaxislength=4.0, zorder=2.5,
    )  # fmt: skip
    name = f"mean shear {what}; the longest is {text_of(largest)}"
    legend_above(panel, [Line2D([], [], color=style.ORANGE, linewidth=1.2, label=name)], down=BAR_ROW)


def _force_value(units):
    return lambda force: f"{force:.3g} {units.force_word()}".rstrip()


def _add_axis(panel, run):
    surface = run.analysis and run.analysis["cone_surface"]
    if surface:
        at = surface.attributes["axis_x"], surface.attributes["axis_y"]
        panel.axes.plot(*at, "+", color=style.INK, markersize=7, markeredgewidth=1.0, zorder=3)


def _window(run, units):
    window = run.base.attributes if run.base is not None else {}
    begin, until = window.get("window_start", run.state.time), window.get("window_end", run.state.time)
    text = f"mean over t = {begin:.6g} to {units.time_value(until)}" if begin < until else f"at t = {units.time_value(until)}"
    surface = run.analysis and run.analysis["cone_surface"]
    return text + ("; +: axis of the heap" if surface else "")
