# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Grains, cells, walls and contacts as shapes of exact size, many to a path, which keeps vector files small."""

import numpy as np
from matplotlib.collections import PathCollection, PolyCollection
from matplotlib.path import Path

from repose import style
from repose.pictures.run.visible_box import periodic_sides, wrapped

SHAPES_PER_PATH = 500

# Unit circle of four cubic curves, exact to 0.03 % of the radius.
_K = 4.0 / 3.0 * (np.sqrt(2.0) - 1.0)
_QUARTER = np.array([[1.0, _K], [_K, 1.0], [0.0, 1.0]])
_TURN = np.array([[0.0, 1.0], [-1.0, 0.0]])  # turns row vectors by +90 degrees
_CIRCLE = np.concatenate(
    [[[1.0, 0.0]], *(_QUARTER @ np.linalg.matrix_power(_TURN, k) for k in range(4)), [[1.0, 0.0]]]
)
_CIRCLE_CODES = np.array([Path.MOVETO] + [Path.CURVE4] * 12 + [Path.CLOSEPOLY], dtype=Path.code_type)
_LINE_CODES = np.array([Path.MOVETO, Path.LINETO], dtype=Path.code_type)


def _add_shapes(axes, shapes, codes, **drawing):
    """Adds shapes (K, points, 2) [L] of one colour and line width."""
    paths = []
    for start in range(0, len(shapes), SHAPES_PER_PATH):
        part = shapes[start : start + SHAPES_PER_PATH]
        path = Path(part.reshape(-1, 2), np.tile(codes, len(part)))
        path.should_simplify = False
        paths.append(path)
    axes.add_collection(PathCollection(paths, sizes=None, **drawing), autolim=False)


def add_discs(panel, run, state, chosen, **drawing):
    """Discs of the chosen grains (N, bool) that the panel shows, with their images at a periodic side."""
    centre = wrapped(run, state.grains.position)[chosen]
    radius = state.grains.radius[chosen]
    if run.attributes["periodic"]:
        period = np.array([run.attributes["x_max"] - run.attributes["x_min"], 0.0])
        centre = np.concatenate([centre, centre - period, centre + period])
        radius = np.tile(radius, 3)
    seen = panel.box.near(centre, radius)
    _add_shapes(panel.axes, centre[seen, None] + radius[seen, None, None] * _CIRCLE, _CIRCLE_CODES, **drawing)


def add_lines(panel, lines, width, colour):
    """Lines (K, 2, 2) [L] of one width [points]."""
    seen = panel.box.near(lines, 0.0).any(axis=1)
    drawing = dict(facecolor="none", edgecolor=colour, linewidth=width, capstyle="round")
    _add_shapes(panel.axes, lines[seen], _LINE_CODES, **drawing)


def add_cells(panel, run, cells, **drawing):
    """Polygons, (points, 2) [L] each, coloured by the `array` in `drawing`, with their images at a periodic side."""
    array = drawing.pop("array", None)
    drawn, cell_of = [], []
    period = run.attributes["x_max"] - run.attributes["x_min"] if run.attributes["periodic"] else 0.0
    for k, cell in enumerate(cells):
        home = wrapped(run, cell.mean(axis=0)[None])[0] - cell.mean(axis=0)
        for shift in (0.0, -period, period) if period else (0.0,):
            placed = cell + home + [shift, 0.0]
            if panel.box.near(placed, 0.0).any():
                drawn.append(placed)
                cell_of.append(k)
    collection = PolyCollection(drawn, **drawing)
    if array is not None:
        collection.set_array(array[cell_of])
    panel.axes.add_collection(collection, autolim=False)
    return collection


def add_walls(panel, run, state):
    """A line for every wall that exists at the time of the state, where the wall is at that time."""
    if run.walls is None:
        return
    for wall, (point, normal) in enumerate(zip(*wall_places(run, state))):
        if state.time >= run.walls["opens_at"][wall]:
            continue
        half_length = run.walls["half_length"][wall]
        along = np.array([-normal[1], normal[0]])
        if np.isfinite(half_length):
            ends = np.stack([point - half_length * along, point + half_length * along])
            panel.axes.plot(*ends.T, color=style.HELD, linewidth=1.2, zorder=0.5, scalex=False, scaley=False)
        else:
            panel.axes.axline(point, point + along, color=style.HELD, linewidth=1.2, zorder=0.5)


def wall_places(run, state):
    """A point of each wall (W, 2) [L] and its unit normal (W, 2) at the time of the state, as the time series records."""
    points = np.array(run.walls["point"], dtype=float)
    normals = np.array(run.walls["normal"], dtype=float)
    series = run.series.get("wall_displacement")
    if series is None or not len(series):
        return points, normals
    row = np.searchsorted(run.series["time"], state.time * (1.0 + 1e-12), side="right") - 1
    moved = series[row] if row >= 0 else np.zeros(len(points))
    turns = np.asarray(run.walls["rotates"], dtype=bool)
    if turns.any():
        centre = run.walls["centre"][turns]
        points[turns] = centre + turned(points[turns] - centre, moved[turns])
        normals[turns] = turned(normals[turns], (moved - series[-1])[turns])  # they are those of the last row
    return points + moved[:, None] * run.walls["direction"], normals


def turned(vectors, angles):
    """Vectors (K, 2), turned counter-clockwise by angles (K) in radians."""
    sine, cosine = np.sin(angles), np.cos(angles)
    x, y = vectors.T
    return np.stack([x * cosine - y * sine, y * cosine + x * sine], axis=1)


def centre_lines(run, state):
    """Lines (K, 2, D) [L] from the first grain of a contact to the second, and the row of the contact of each (K).

    The line of a contact with a wall ends on the wall. A contact across a periodic side has two lines, one from each
    grain, which end beyond the side.
    """
    grains, contacts = state.grains, state.contacts
    centre = wrapped(run, grains.position)
    first = state.rows(contacts.grains[:, 0])
    with_wall = contacts.grains[:, 1] < 0
    start = centre[first]
    end = start - contacts.normal * grains.radius[first, None]
    end[~with_wall] = centre[state.rows(contacts.grains[~with_wall, 1])]
    lines, contact = np.stack([start, end], axis=1), np.arange(len(contacts))
    shift = np.zeros_like(lines)
    for axis, low, high in periodic_sides(run):
        period = high - low
        shift[:, 1, axis] = -period * np.round((end - start)[:, axis] / period)
    across = (shift[:, 1] != 0.0).any(axis=1)
    shift_back = -shift[across][:, ::-1]
    return np.concatenate([lines + shift, lines[across] + shift_back]), np.append(contact, contact[across])
