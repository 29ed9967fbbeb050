# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sections of walls with a plane, as lines: straight ones, and the curves in which it cuts cylinders and cones."""

from dataclasses import dataclass

import numpy as np
from matplotlib.collections import LineCollection

from repose import style

PARALLEL = 1e-9  # sine of an angle below which directions are the same
POINTS = 60  # of a curve between two of its ends
TURN = 180  # points of a circle
SHAPES = ("disc", "rectangle", "triangle", "frustum")


@dataclass(frozen=True)
class Shape:
    """A wall as it stands at the time of a picture; its own axes are side, normal x side, normal."""

    kind: str  # of SHAPES
    point: np.ndarray  # (3) [L]
    normal: np.ndarray  # (3) unit vector; the axis of a frustum
    half_length: float  # [L] radius of a disc, infinite for a plane
    side: np.ndarray  # (3) unit vector along the wall
    corners: np.ndarray  # (3, 2) [L] relative to the point, as boundaries/wall_shape.hpp defines them

    def placed(self, along_side, along_across, along_normal):
        """Positions (..., 3) [L] of places given along the wall's own axes."""
        across = np.cross(self.normal, self.side)
        parts = zip((along_side, along_across, along_normal), (self.side, across, self.normal))
        return self.point + sum(np.asarray(part)[..., None] * axis for part, axis in parts)


def perpendicular(unit):
    """A unit vector perpendicular to another."""
    other = np.eye(3)[np.argmin(np.abs(unit))]
    vector = np.cross(unit, other)
    return vector / np.linalg.norm(vector)


def shapes_at(run, state):
    """The Shapes of the walls that exist at the time of a state, where they are then."""
    if run.walls is None:
        return []
    table, count = run.walls, len(run.walls["point"])
    points, normals, sides = _moved(run, state)
    kinds = table.get("shape") or ["disc"] * count
    corners = np.asarray(table.get("corners", np.zeros((count, 6)))).reshape(count, 3, 2)
    return [
        Shape(kinds[k] or "disc", points[k], normals[k], table["half_length"][k], sides[k], corners[k])
        for k in range(count)
        if not state.time >= table["opens_at"][k]
    ]


def _moved(run, state):
    """Points (W, 3), normals and sides (W, 3) of the walls at the time of a state, as the time series records. A wall that
    turns about an axis that the file does not have stays as at the end."""
    table = run.walls
    normals = np.array(table["normal"], dtype=float)
    sides = np.array(table["side"] if "side" in table else np.zeros_like(normals), dtype=float)
    missing = ~np.any(sides != 0.0, axis=1)
    sides[missing] = [perpendicular(normal) for normal in normals[missing]] if missing.any() else sides[missing]
    series = run.series.get("wall_displacement")
    points = np.array(table["point"], dtype=float)
    if series is None or not len(series):
        return points, normals, sides
    row = np.searchsorted(run.series["time"], state.time * (1.0 + 1e-12), side="right") - 1
    moved = series[row] if row >= 0 else np.zeros(len(points))
    turns = np.asarray(table["rotates"], dtype=bool)
    last = np.array(table.get("position", points), dtype=float)
    for k in np.flatnonzero(turns):
        back = moved[k] - series[-1, k]
        axis = table["axis"][k] if "axis" in table else np.zeros(3)
        points[k] = table["centre"][k] + turned(last[k] - table["centre"][k], axis, back)
        normals[k], sides[k] = turned(normals[k], axis, back), turned(sides[k], axis, back)
    points[~turns] += moved[~turns, None] * np.asarray(table["direction"])[~turns]
    return points, normals, sides


def turned(vector, axis, angle):
    """A vector (3), turned about a unit axis by an angle in radians; unchanged for an axis of zeros."""
    if not np.any(axis):
        return vector
    along = axis * (axis @ vector)
    return along + (vector - along) * np.cos(angle) + np.cross(axis, vector) * np.sin(angle)


def section_of(shape, plane, box):
    """The lines, (points, 2) [L] each, in which a plane cuts a wall; those of an endless wall end beyond the box."""
    if shape.kind == "frustum":
        return [plane.flat(curve) for curve in _section_of_frustum(shape, plane)]
    if shape.kind in ("rectangle", "triangle"):
        return [plane.flat(line) for line in _section_of_polygon(_outline(shape), plane)]
    return [plane.flat(line) for line in _section_of_disc(shape, plane, box)]


def _outline(shape):
    """Corners (K, 3) of a flat shape."""
    if shape.kind == "triangle":
        return shape.placed(*shape.corners.T, np.zeros(3))
    half_side, half_across = shape.corners[0]
    signs = np.array([[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]])
    return shape.placed(half_side * signs[:, 0], half_across * signs[:, 1], np.zeros(4))


def _section_of_polygon(corners, plane):
    """The line between the two places where the outline passes through the plane."""
    height = corners[:, plane.axis] - plane.level
    ends = []
    for k in range(len(corners)):
        here, there = height[k - 1], height[k]
        if (here < 0.0) != (there < 0.0):
            ends.append(corners[k - 1] + here / (here - there) * (corners[k] - corners[k - 1]))
    return [np.array(ends)] if len(ends) == 2 else []


def _section_of_disc(shape, plane, box):
    """The chord of a disc, or a line across the box where the disc has no end."""
    upright = np.eye(3)[plane.axis]
    along = np.cross(shape.normal, upright)
    sine = np.linalg.norm(along)
    if sine < PARALLEL:
        return []
    along /= sine
    towards = upright - shape.normal * (shape.normal @ upright)  # within the wall, towards larger levels
    middle = shape.point + (plane.level - shape.point[plane.axis]) / sine**2 * towards
    half = np.sqrt(max(0.0, shape.half_length**2 - np.sum((middle - shape.point) ** 2)))
    if not np.isfinite(half):
        seen = np.array([0.5 * (box.x_min + box.x_max), 0.5 * (box.y_min + box.y_max)])
        middle = middle + along * ((seen - plane.flat(middle)) @ plane.flat(along))
        half = (box.x_max - box.x_min) + (box.y_max - box.y_min)
    return [middle + np.array([[-half], [half]]) * along] if half > 0.0 else []


def _section_of_frustum(shape, plane):
    """The curves on a surface of revolution at the level of the plane.

    A circle of radius r about the axis, at h along it, has the level c + r a cos(angle), with c linear in h and a the sine
    between the axis and the normal of the plane: it crosses at two angles, one on each branch, which meet where r a = |level -
    c|. Samples are dense there, since the branches have a vertical tangent.
    """
    (r0, h0), (r1, h1) = shape.corners[:2]
    across = np.cross(shape.normal, shape.side)
    parts = np.array([shape.side[plane.axis], across[plane.axis]])
    sine, first = np.hypot(*parts), np.arctan2(parts[1], parts[0])
    rise0, rise1 = (plane.level - shape.point[plane.axis] - h * shape.normal[plane.axis] for h in (h0, h1))
    if sine < PARALLEL:  # circles lie in planes parallel to this one
        if rise0 == rise1 or not 0.0 <= rise0 / (rise0 - rise1) <= 1.0:
            return []
        part, angle = rise0 / (rise0 - rise1), np.linspace(0.0, 2.0 * np.pi, TURN + 1)
        r, h = r0 + part * (r1 - r0), h0 + part * (h1 - h0)
        return [shape.placed(r * np.cos(angle), r * np.sin(angle), np.full(len(angle), h))]
    curves = []
    for start, end in _parts_within(np.array([rise0, rise1]), sine * np.array([r0, r1])):
        part = start + (end - start) * 0.5 * (1.0 - np.cos(np.pi * np.linspace(0.0, 1.0, POINTS)))
        r, h, rise = (a + part * (b - a) for a, b in ((r0, r1), (h0, h1), (rise0, rise1)))
        cosine = np.divide(rise, sine * r, out=np.ones_like(r), where=r > 0.0)
        half = np.arccos(np.clip(cosine, -1.0, 1.0))
        curves += [shape.placed(r * np.cos(first + s * half), r * np.sin(first + s * half), h) for s in (1.0, -1.0)]
    return curves


def _parts_within(rise, reach):
    """Intervals of [0, 1] in which |rise| <= reach, both linear between their two values."""
    ends = {0.0, 1.0}
    for difference in (rise - reach, rise + reach):
        if difference[0] != difference[1]:
            ends.add(float(np.clip(difference[0] / (difference[0] - difference[1]), 0.0, 1.0)))
    ends = sorted(ends)
    for start, end in zip(ends[:-1], ends[1:]):
        middle = 0.5 * (start + end)
        at = [values[0] + middle * (values[1] - values[0]) for values in (rise, reach)]
        if end > start and abs(at[0]) <= at[1]:
            yield start, end


def add_wall_sections(panel, run, state, plane):
    """A line for every wall that the plane cuts."""
    lines = [line for shape in shapes_at(run, state) for line in section_of(shape, plane, panel.box)]
    drawing = dict(colors=style.HELD, linewidths=1.2, zorder=0.5)
    panel.axes.add_collection(LineCollection(lines, **drawing), autolim=False)
