# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The part of the plane that a picture of grains shows: the heap and the base below it."""

from dataclasses import dataclass

import numpy as np

from repose.errors import NotDrawn

# grain diameters
WIDEST_GAP = 10.0  # in x; a grain beyond a wider gap has left the heap
SIDE_MARGIN = 3.0
MARGIN = 1.0
LEAST_HEIGHT = 5.0
WIDEST_STEP = 2.0  # in y; grains in flight above a wider gap do not belong to the bed

WIDEST_SHAPE = 12.0  # width over height, at most


@dataclass(frozen=True)
class Box:
    """x_min <= x <= x_max, y_min <= y <= y_max [L]."""

    x_min: float
    x_max: float
    y_min: float
    y_max: float

    def near(self, points, reach):
        """Points (..., 2) that lie inside the box or within `reach` [L] of it; bool (...)."""
        x, y = points[..., 0], points[..., 1]
        return (
            (x >= self.x_min - reach)
            & (x <= self.x_max + reach)
            & (y >= self.y_min - reach)
            & (y <= self.y_max + reach)
        )

    @classmethod
    def around(cls, boxes):
        """The smallest box that holds all of them."""
        low, high = (
            [edge(getattr(box, f"{side}_{end}") for box in boxes) for side in "xy"] for edge, end in ((min, "min"), (max, "max"))
        )
        return cls(low[0], high[0], low[1], high[1])


def supported(state):
    """Moving grains (N, bool) that a chain of contacts links to the base or a wall; without those, all in contact."""
    held = state.grains.held
    first, second = state.contacts.grains.T
    with_wall = second < 0
    pair = state.rows(state.contacts.grains[~with_wall])
    linked = held.copy()
    linked[state.rows(first[with_wall])] = True
    if not linked.any():
        linked[pair] = True
    count = -1
    while count != np.count_nonzero(linked):
        count = np.count_nonzero(linked)
        linked[pair[linked[pair].any(axis=1)]] = True
    return linked & ~held


def periodic_sides(run):
    """(axis, low, high) of each periodic axis of the box, [L]."""
    sides = (("periodic", "x"), ("periodic_y", "y"))
    return [
        (axis, run.attributes[f"{name}_min"], run.attributes[f"{name}_max"])
        for axis, (flag, name) in enumerate(sides)
        if run.attributes.get(flag)
    ]


def wrapped(run, positions):
    """Positions (N, D) [L] brought into the box along its periodic axes."""
    for axis, low, high in periodic_sides(run):
        positions = np.array(positions, dtype=float)
        positions[:, axis] = low + (positions[:, axis] - low) % (high - low)
    return positions


def visible_box(run, state):
    """Box around the heap and the base below it, or that of the axes of the state. While any grains are supported, those
    in flight count only where they continue the bed upwards."""
    if state.axes and state.axes.box:
        return state.axes.box
    grains = state.grains
    diameter = run.attributes["grain_diameter"]
    centre, radius = wrapped(run, grains.position), grains.radius
    finite = np.isfinite(centre).all(axis=1)  # a failed run may have lost its grains to infinity
    shown = shown_grains(state, finite)
    if run.attributes["periodic"]:
        x_min, x_max = run.attributes["x_min"], run.attributes["x_max"]
    else:
        shown = largest_group(shown, centre[:, 0], WIDEST_GAP * diameter)
        x_min = (centre[shown, 0] - radius[shown]).min() - SIDE_MARGIN * diameter
        x_max = (centre[shown, 0] + radius[shown]).max() + SIDE_MARGIN * diameter
    below = grains.held & (centre[:, 0] >= x_min) & (centre[:, 0] <= x_max)
    below[shown] = True
    y_min = (centre[below, 1] - radius[below]).min() - MARGIN * diameter
    bed = ~grains.held & finite & (centre[:, 0] >= x_min) & (centre[:, 0] <= x_max)
    bed &= centre[:, 1] <= top_of_bed(centre[shown, 1].max(), centre[bed, 1], WIDEST_STEP * diameter)
    bed[shown] = True
    y_max = (centre[bed, 1] + radius[bed]).max() + MARGIN * diameter
    y_max = max(y_max, y_min + LEAST_HEIGHT * diameter, y_min + (x_max - x_min) / WIDEST_SHAPE)
    return Box(x_min, x_max, y_min, y_max)


def shown_grains(state, finite):
    """Rows of the grains that a picture is about, among the `finite` (N, bool): those that are supported, without any the
    moving ones, without these all."""
    for shown in (supported(state) & finite, ~state.grains.held & finite, finite):
        if shown.any():
            return np.flatnonzero(shown)
    raise NotDrawn("no grains")


def top_of_bed(top, heights, gap):
    """The height that is reached from `top` by steps of at most `gap` to the next of `heights`."""
    for height in np.sort(heights[heights > top]):
        if height > top + gap:
            break
        top = height
    return top


def largest_group(rows, x, gap):
    """The largest subset of `rows` whose neighbours in x lie within `gap` of each other."""
    ordered = rows[np.argsort(x[rows])]
    groups = np.split(ordered, np.flatnonzero(np.diff(x[ordered]) > gap) + 1)
    return max(groups, key=len)
