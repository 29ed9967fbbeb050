# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of packings, beds and heaps beside walls, and those that have no meaning there."""

import math

import pytest
from conftest import Grains, summary
from wall_scenes import POUR, SQUARE, TRAY, wall


def test_a_packing_on_a_plane_is_measured_from_height_0(lab):
    text = """[contact]
normal = { law = "hooke", stiffness = 1e4, damping = 0.5 }
[base]
kind = "plane"
[box]
x = "periodic"
half_width = 10.0
[source]
kind = "lattice"
rows = 8
columns = 18
gap = 0.05
jitter = 1.0
[stop]
time = 20.0
"""
    out = lab.run(text)
    packing = summary(out)["packing"]
    height = Grains(out / "run.h5").position[:, 1].mean()
    assert packing["slab"]["low"] == pytest.approx(0.4 * height, rel=1e-6)
    assert packing["slab"]["high"] == pytest.approx(1.4 * height, rel=1e-6)
    assert 0.7 < packing["solid_fraction"]["mean"] < 0.92


# Between upright pieces: a square lattice over two periods of its height has the solid fraction pi / 4; the box is wider.
def test_a_packing_between_pieces_of_wall(lab):
    out = lab.run(SQUARE + TRAY + "[analysis]\npacking = true\n")
    packing = summary(out)["packing"]
    assert packing["solid_fraction"]["mean"] == pytest.approx(math.pi / 4, abs=1e-3)
    assert packing["coordination"]["mean"] == pytest.approx(4.0, abs=1e-9)


TENSION = """[contact]
normal = { law = "hooke", stiffness = 1e4, damping = 1.0 }
tangential = { law = "linear", stiffness = 5e3, damping = 0.2 }
cohesion = { law = "constant", force = 10.0 }
[[grain]]
position = [0.0, 10.0]
fixed = true
[[grain]]
position = [0.0, 9.0009]
[stop]
time = 5.0
"""


def test_a_contact_in_tension_is_a_contact(lab):
    found = summary(lab.run(TENSION))
    assert found["coordination"] == 1.0 and found["contacts"] == 1


# The moments of a level bed between walls say nothing of an angle; those of a heap do.
def test_a_bed_between_walls_has_no_angle(lab):
    sides = "".join(f"[[plane]]\nname = 's{s}'\npoint = [{-6 * s}, 0]\nnormal = [{s}, 0]\n" for s in (1, -1))
    text = POUR.replace("count = 30\nrate = 2.0", "count = 120\nrate = 20.0").replace("time = 16.0", "time = 20.0")
    found = summary(lab.run(text + sides))["angle_of_repose_deg"]
    assert found["moments"] is None


# Walls that meet at the neck of an hourglass leave its cells whole.
def test_the_core_of_an_hourglass_is_finite(lab):
    glass = "".join(wall(f"{side}{k}", (s * x, y), (s * u, v)) for side, s in (("l", -1), ("r", 1))
                    for k, (x, y, u, v) in enumerate([(5, 14, 0.8, 8), (0.8, 8, 5, 2), (5, 2, 5, 0)]))
    text = POUR.replace("count = 30\nrate = 2.0", "count = 150\nrate = 20.0").replace("half_width = 3", "half_width = 2")
    found = summary(lab.run(text.replace("time = 16.0", "time = 25.0") + glass))
    assert found["core"] is None or 0.7 < found["core"]["solid_fraction"] < 0.95


def test_a_heap_has_an_angle_by_moments(heap):
    assert 5.0 < summary(heap)["angle_of_repose_deg"]["moments"] < 45.0
