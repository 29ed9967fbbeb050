# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Spheres and walls in a plane of space: which axes a picture shows, where the plane is, and what lies in it."""

from dataclasses import dataclass

import numpy as np
from matplotlib.collections import EllipseCollection

from repose.pictures.run.visible_box import periodic_sides, wrapped

AXES = "xyz"


@dataclass(frozen=True)
class Plane:
    """A plane perpendicular to an axis; a picture of it shows the two others."""

    across: int  # axis to the right
    up: int  # axis upwards
    axis: int  # perpendicular to it
    level: float  # [L] along `axis`

    @property
    def names(self):
        """Of the axes of the picture."""
        return AXES[self.across] + AXES[self.up]

    def flat(self, vectors):
        """The two shown components of vectors (..., 3)."""
        return vectors[..., [self.across, self.up]]

    def distance(self, run, positions):
        """Signed distance [L] of positions (..., 3) from the plane; from the nearest image where its axis is periodic."""
        distance = positions[..., self.axis] - self.level
        for axis, low, high in periodic_sides(run):
            if axis == self.axis:
                distance = distance - (high - low) * np.round(distance / (high - low))
        return distance


def upright_plane(box):
    """The vertical plane y = 0, or the one through the middle of the box where that does not lie in it."""
    low, high = box.low[1], box.high[1]
    return Plane(0, 2, 1, 0.0 if low < 0.0 < high else 0.5 * (low + high))


def images(run, positions, axes):
    """Positions (K, 3) with their images at the periodic sides along these axes, and the row of each."""
    rows = np.arange(len(positions))
    for axis, low, high in periodic_sides(run):
        if axis in axes:
            shift = (high - low) * np.eye(3)[axis]
            positions = np.concatenate([positions, positions - shift, positions + shift])
            rows = np.tile(rows, 3)
    return positions, rows


def circles_in(run, state, plane, box):
    """Sections of spheres with a plane that a box of the picture shows: centres (K, 2) [L], radii (K) [L], rows of their
    grains (K)."""
    centre, radius = wrapped(run, state.grains.position), state.grains.radius
    with np.errstate(invalid="ignore"):  # a failed run may have lost its grains to infinity
        apart = plane.distance(run, centre)
        cut = np.flatnonzero(np.abs(apart) < radius)
    places, copy = images(run, centre[cut], (plane.across, plane.up))
    row = cut[copy]
    centre, radius = plane.flat(places), np.sqrt(radius[row] ** 2 - apart[row] ** 2)
    seen = box.near(centre, radius)
    return centre[seen], radius[seen], row[seen]


def add_circles(panel, centre, radius, **drawing):
    """Circles with centres (K, 2) and radii (K) [L] in the order in which they are given; the collection."""
    axes = panel.axes
    flat = dict(widths=2.0 * radius, heights=2.0 * radius, angles=np.zeros(len(radius)), units="xy")
    circles = EllipseCollection(offsets=centre, offset_transform=axes.transData, **flat, **drawing)
    axes.add_collection(circles, autolim=False)
    return circles
