# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The part of space that pictures of spheres show: the heap and the base below it."""

from dataclasses import dataclass

import numpy as np

from repose.pictures.run.visible_box import (
    LEAST_HEIGHT,
    MARGIN,
    SIDE_MARGIN,
    WIDEST_GAP,
    WIDEST_SHAPE,
    WIDEST_STEP,
    Box,
    largest_group,
    periodic_sides,
    shown_grains,
    top_of_bed,
    wrapped,
)


@dataclass(frozen=True)
class SpaceBox:
    """low <= position <= high [L], both along x, y and z."""

    low: "tuple[float, float, float]"
    high: "tuple[float, float, float]"

    @classmethod
    def around(cls, boxes):
        """The smallest box that holds all of them."""
        return cls(
            tuple(float(side) for side in np.min([box.low for box in boxes], axis=0)),
            tuple(float(side) for side in np.max([box.high for box in boxes], axis=0)),
        )

    def face(self, across, up):
        """The side of the box that two axes span."""
        return Box(self.low[across], self.high[across], self.low[up], self.high[up])

    def holds(self, points):
        """Points (N, 3) that lie inside; bool (N)."""
        return ((points >= self.low) & (points <= self.high)).all(axis=1)


def space_box(run, state):
    """Box around the heap and the base below it, chosen as in two dimensions, or that of the axes of the state."""
    if state.axes and state.axes.box:
        return state.axes.box
    grains, diameter = state.grains, run.attributes["grain_diameter"]
    centre, radius = wrapped(run, grains.position), grains.radius
    finite = np.isfinite(centre).all(axis=1)
    shown = shown_grains(state, finite)
    sides = {axis: (low, high) for axis, low, high in periodic_sides(run)}
    for axis in (0, 1):
        if axis not in sides:
            shown = largest_group(shown, centre[:, axis], WIDEST_GAP * diameter)
    for axis in {0, 1} - sides.keys():
        low, high = centre[shown, axis] - radius[shown], centre[shown, axis] + radius[shown]
        sides[axis] = (low.min() - SIDE_MARGIN * diameter, high.max() + SIDE_MARGIN * diameter)
    above = finite.copy()
    for axis, (low, high) in sides.items():
        above &= (centre[:, axis] >= low) & (centre[:, axis] <= high)
    below = grains.held & above
    below[shown] = True
    z_min = (centre[below, 2] - radius[below]).min() - MARGIN * diameter
    bed = ~grains.held & above
    bed &= centre[:, 2] <= top_of_bed(centre[shown, 2].max(), centre[bed, 2], WIDEST_STEP * diameter)
    bed[shown] = True
    z_max = (centre[bed, 2] + radius[bed]).max() + MARGIN * diameter
    width = max(high - low for low, high in sides.values())
    z_max = max(z_max, z_min + LEAST_HEIGHT * diameter, z_min + width / WIDEST_SHAPE)
    low, high = ([float(sides[axis][end]) for axis in (0, 1)] for end in (0, 1))
    return SpaceBox((*low, float(z_min)), (*high, float(z_max)))
