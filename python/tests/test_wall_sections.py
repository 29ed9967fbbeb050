# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sections of walls with a plane, against closed forms and against the equations of the surfaces."""

import numpy as np
import pytest
from synthetic_spheres import cone, walls_of, write_spheres

import repose
from repose.pictures.run.visible_box import Box
from repose.pictures.spheres.places import Plane
from repose.pictures.spheres.wall_sections import Shape, perpendicular, section_of, shapes_at, turned

BOX = Box(-10.0, 10.0, -10.0, 10.0)
SIDE = Plane(0, 2, 1, 0.0)
UP = np.array([0.0, 0.0, 1.0])
X = np.array([1.0, 0.0, 0.0])


def shape(kind, normal=UP, point=(0.0, 0.0, 0.0), half_length=np.inf, corners=((0, 0), (0, 0), (0, 0)), side=None):
    normal = np.array(normal) / np.linalg.norm(normal)
    side = perpendicular(normal) if side is None else np.array(side)
    return Shape(kind, np.array(point, dtype=float), normal, half_length, side, np.array(corners, dtype=float))


def sorted_ends(lines):
    return sorted([tuple(np.round(end, 9)) for end in (line[0], line[-1])] for line in lines)


def test_a_plane_is_a_line_across_the_box():
    ((start, end),) = section_of(shape("disc", [0.6, 0.0, 0.8], [1.0, 3.0, 2.0]), SIDE, BOX)
    for place in (start, end):
        assert 0.6 * (place[0] - 1.0) + 0.8 * (place[1] - 2.0) == pytest.approx(0.0, abs=1e-9)
    assert np.hypot(*(end - start)) > 20.0 * np.sqrt(2.0)


def test_a_plane_that_is_parallel_is_not_cut():
    assert section_of(shape("disc", [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]), SIDE, BOX) == []


@pytest.mark.parametrize("offset, half", [(0.0, 5.0), (3.0, 4.0), (5.5, None)])
def test_the_chord_of_a_disc(offset, half):
    """3, 4, 5."""
    lines = section_of(shape("disc", UP, [1.0, offset, 2.0], half_length=5.0), SIDE, BOX)
    if half is None:
        assert lines == []
    else:
        np.testing.assert_allclose(sorted(lines[0][:, 0]), [1.0 - half, 1.0 + half])
        np.testing.assert_allclose(lines[0][:, 1], 2.0)


def test_an_oblique_disc():
    """Its plane is turned about x, so that its centre is 1 above the plane along its own slope of 0.8: a chord of 2 sqrt(3)."""
    lines = section_of(shape("disc", [0.0, 0.6, 0.8], [0.0, 0.8, 0.0], half_length=2.0), SIDE, BOX)
    np.testing.assert_allclose(sorted(lines[0][:, 0]), [-np.sqrt(3.0), np.sqrt(3.0)])
    np.testing.assert_allclose(lines[0][:, 1], 0.6)


def test_a_rectangle_and_a_triangle():
    rectangle = shape("rectangle", UP, [1.0, 0.5, 2.0], corners=[[3.0, 1.0], [0, 0], [0, 0]], side=X)
    assert sorted_ends(section_of(rectangle, SIDE, BOX)) in ([[(-2.0, 2.0), (4.0, 2.0)]], [[(4.0, 2.0), (-2.0, 2.0)]])
    assert section_of(rectangle, Plane(0, 2, 1, 1.6), BOX) == []
    triangle = shape("triangle", UP, [0.0, 0.0, 1.0], corners=[[-2.0, -1.0], [2.0, -1.0], [0.0, 1.0]], side=X)
    np.testing.assert_allclose(sorted(section_of(triangle, SIDE, BOX)[0][:, 0]), [-1.0, 1.0])


@pytest.mark.parametrize("level, x", [(0.0, 5.0), (3.0, 4.0), (6.0, None)])
def test_an_upright_cylinder_is_two_lines(level, x):
    lines = section_of(shape("frustum", corners=[[5.0, -1.0], [5.0, 7.0], [0, 0]], side=X), Plane(0, 2, 1, level), BOX)
    if x is None:
        assert lines == []
    else:
        assert sorted([sorted(ends) for ends in sorted_ends(lines)]) == [[(-x, -1.0), (-x, 7.0)], [(x, -1.0), (x, 7.0)]]


def test_a_cone_through_its_axis_is_a_v():
    lines = section_of(shape("frustum", corners=[[0.0, 0.0], [3.0, 4.0], [0, 0]], side=X), SIDE, BOX)
    assert sorted([sorted(ends) for ends in sorted_ends(lines)]) == [[(-3.0, 4.0), (0.0, 0.0)], [(0.0, 0.0), (3.0, 4.0)]]


def test_a_cylinder_along_the_normal_of_the_plane_is_a_circle():
    wall = shape("frustum", [0.0, 1.0, 0.0], [1.0, -1.0, 2.0], corners=[[2.0, 0.0], [2.0, 4.0], [0, 0]])
    (circle,) = section_of(wall, SIDE, BOX)
    np.testing.assert_allclose(np.hypot(circle[:, 0] - 1.0, circle[:, 1] - 2.0), 2.0)
    np.testing.assert_allclose(circle[0], circle[-1], atol=1e-12)
    assert section_of(wall, Plane(0, 2, 1, 3.5), BOX) == []


@pytest.mark.parametrize("seed", range(12))
def test_sections_of_oblique_cones_lie_on_them_and_have_no_gap(seed):
    """Every point has the distance from the axis that the line has there. Branches end on the rims or meet each other: each
    end that is on no rim is the end of another branch."""
    random = np.random.default_rng(seed)
    radii, half = random.uniform(0.0, 3.0, 2), random.uniform(1.0, 3.0)
    wall = shape("frustum", random.normal(size=3), random.uniform(-1.0, 1.0, 3), corners=[[radii[0], -half], [radii[1], half], [0, 0]])
    plane = Plane(0, 2, 1, random.uniform(-0.5, 0.5))
    lines = section_of(wall, plane, BOX)
    assert lines
    ends = []
    for line in lines:
        space = np.insert(line, 1, plane.level, axis=1) - wall.point
        along = space @ wall.normal
        distance = np.linalg.norm(space - along[:, None] * wall.normal, axis=1)
        part = (along + half) / (2.0 * half)
        assert (part > -1e-9).all() and (part < 1.0 + 1e-9).all()
        # At the ends of a branch the angle is the arc cosine of nearly 1, exact to the root of the rounding.
        np.testing.assert_allclose(distance, radii[0] + part * (radii[1] - radii[0]), atol=1e-7)
        ends += [(line[k], min(abs(part[k]), abs(part[k] - 1.0)) < 1e-9) for k in (0, -1)]
    for k, (end, on_rim) in enumerate(ends):
        others = [np.hypot(*(end - other)) for j, (other, _) in enumerate(ends) if j != k]
        assert on_rim or min(others) < 1e-6


def test_walls_are_where_the_time_series_says(tmp_path):
    """One that moves along z by 0.1 a row, one that turns about y by 0.01 a row, one that has opened."""
    import h5py

    rows = dict(name="a", point=[0.0, 0.0, -3.0], normal=UP, direction=UP), dict(
        name="b", point=[2.0, 0.0, 0.0], normal=[np.cos(0.39), 0.0, -np.sin(0.39)], rotates=1, axis=[0.0, 1.0, 0.0], half_length=1.0
    ), dict(name="c", point=[0.0, 0.0, 9.0], normal=UP, opens_at=5.0)
    folder = write_spheres(tmp_path / "run", cone(3.0), walls=walls_of(*rows))
    with h5py.File(folder / "run.h5", "a") as file:
        file["series/wall_displacement"][...] = np.arange(40.0)[:, None] * [0.1, 0.01, 0.0]
        file["walls/position"][0] = [0.0, 0.0, -3.0 + 3.9]
        file["walls/position"][1] = 2.0 * np.array([np.cos(0.39), 0.0, -np.sin(0.39)])
    run = repose.open(folder)
    early = shapes_at(run, repose.run_folder.State(3.0, 0, run.state.grains, run.state.contacts))
    assert [len(early), len(shapes_at(run, run.state))] == [3, 2]
    np.testing.assert_allclose(early[0].point, [0.0, 0.0, -2.7])
    np.testing.assert_allclose(early[1].normal, [np.cos(0.03), 0.0, -np.sin(0.03)], atol=1e-12)
    np.testing.assert_allclose(early[1].point, 2.0 * early[1].normal, atol=1e-12)
    np.testing.assert_allclose(shapes_at(run, run.state)[0].point, [0.0, 0.0, 0.9])


def test_turning_about_an_axis():
    np.testing.assert_allclose(turned(X, UP, np.pi / 2.0), [0.0, 1.0, 0.0], atol=1e-15)
    np.testing.assert_allclose(turned(X, np.zeros(3), 1.0), X)
