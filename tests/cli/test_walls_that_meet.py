# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Walls that meet act as one surface. Units: diameter, mass, gravity."""

import math

import numpy as np
import pytest
from conftest import Grains, datasets, summary
from wall_scenes import IMPACT, grain, wall

SEAMS = {
    "one wall": wall("a", (-5, 0), (5, 0)),
    "two pieces": wall("a", (-5, 0), (0, 0)) + wall("b", (0, 0), (5, 0)),
    "in the other order": wall("a", (0, 0), (5, 0)) + wall("b", (0, 0), (-5, 0)),
    "beside the seam": wall("a", (-5, 0), (0.03, 0)) + wall("b", (0.03, 0), (5, 0)),
    "three pieces": wall("a", (-5, 0), (-0.02, 0)) + wall("b", (-0.02, 0), (0.01, 0)) + wall("c", (0.01, 0), (5, 0)),
    "a crossing piece": wall("a", (-5, 0), (5, 0)) + wall("b", (0.02, 0), (0.3, -2)),
    "pieces laid over each other": wall("a", (-5, 0), (1, 0)) + wall("b", (-1, 0), (5, 0)),
    "a piece on a plane": "[[plane]]\nname = 'p'\npoint = [0, 0]\nnormal = [0, 1]\n" + wall("a", (0, 0), (5, 0)),
    "a slight bend": wall("a", (-5, 0.02), (0, 0)) + wall("b", (0, 0), (5, 0.02)),
    "a tip of two": wall("a", (-2, -3), (0, 0)) + wall("b", (2, -3), (0, 0)),
    "a tip of three": wall("a", (-2, -3), (0, 0)) + wall("b", (0, 0), (2, -3)) + wall("c", (0, 0), (0, -3)),
    "an end": wall("a", (0, 0), (0, -5)),
}


# The restitution is 0.5 for one contact with a fixed partner, to a part in 1e4 at this step. A bend by 0.46 degrees turns
# the velocity by as much, which costs 3e-5 of it.
@pytest.mark.parametrize("walls", SEAMS.values(), ids=SEAMS.keys())
def test_walls_that_meet_are_felt_once(lab, walls):
    out = lab.run(IMPACT + walls + grain(0.0, 0.51, 0.0, -1.0) + "[stop]\ntime = 0.1\n")
    velocity = Grains(out / "run.h5").velocity[0]
    assert np.hypot(*velocity) == pytest.approx(0.5, abs=1e-3)
    assert velocity[1] > 0.45


def test_rigid_grains_feel_walls_that_meet_once(lab):
    text = """gravity = 1.0
[method]
kind = "contact-dynamics"
time_step = 1e-3
[contact]
friction = 0.0
restitution = 0.5
"""
    rebound = {}
    for name in ("one wall", "two pieces", "a tip of three"):
        out = lab.run(text + SEAMS[name] + grain(0.0, 0.6, 0.0, -1.0) + "[stop]\ntime = 0.2\n", out=name.replace(" ", "-"))
        rebound[name] = Grains(out / "run.h5").velocity[0, 1]
    assert rebound["two pieces"] == pytest.approx(rebound["one wall"], abs=1e-6)
    assert rebound["a tip of three"] == pytest.approx(rebound["one wall"], abs=1e-6)


ROLLING = """gravity = 1.0
[method]
time_step = 2e-3
[contact]
friction = 0.5
normal = { law = "hooke", stiffness = 1e3, damping = 0.2 }
tangential = { law = "linear", stiffness = 500, damping = 0.1 }
"""


def floor(pieces, length=40.0, bend=0.0):
    """Pieces that follow each other from -5 on, each turned by `bend` degrees against the last."""
    x, y, angle, text = -5.0, 0.0, 0.0, ""
    step = length / pieces
    for k in range(pieces):
        a = math.radians(angle)
        end = (x + step * math.cos(a), y + step * math.sin(a))
        text += wall(f"w{k}", (x, y), end)
        (x, y), angle = end, angle + bend
    return text


# A disc that rolls over one wall keeps its velocity; over pieces it crosses a seam every 0.5 and keeps it as well. At rest
# on the spring it neither bounces nor slips, so that nothing but the seams could stop it.
@pytest.mark.parametrize("pieces", [1, 80, 400])
def test_rolling_over_seams_costs_nothing(lab, pieces):
    text = ROLLING + floor(pieces) + grain(0.0, 0.499, 0.2, 0.0).rstrip() + "\nspin = -0.4\n[stop]\ntime = 100\n"
    grains = Grains(lab.run(text) / "run.h5")
    assert grains.velocity[0, 0] == pytest.approx(0.2, rel=1e-4)
    assert grains.position[0, 0] == pytest.approx(20.0, rel=1e-4)


# A disc that slides on a rough wall loses mu g t, and the spring of friction passes on from piece to piece.
def test_friction_passes_on_at_seams(lab):
    speed = {}
    for pieces in (1, 100):
        text = ROLLING.replace("friction = 0.5", "friction = 0.1") + floor(pieces) + grain(0.0, 0.499, 2.0) + "[stop]\ntime = 4\n"
        speed[pieces] = Grains(lab.run(text, out=f"out{pieces}") / "run.h5").velocity[0, 0]
    assert speed[1] == pytest.approx(1.6, rel=2e-3)
    assert speed[100] == pytest.approx(speed[1], rel=1e-4)


# In a corner both walls carry: on a slope of 45 degrees and a wall at a right angle to it, each takes w / sqrt(2).
def test_both_walls_of_a_corner_carry(lab):
    text = ROLLING.replace("friction = 0.5", "friction = 0.0") + wall("a", (-3, 3), (0, 0)) + wall("b", (0, 0), (3, 3))
    out = lab.run(text + grain(0.0, 0.7071) + "[stop]\ntime = 60\n[output]\nseries = 1\n")
    found = datasets(out / "run.h5")
    carried = np.hypot(found["/series/wall_force_x"][-1], found["/series/wall_force_y"][-1])
    assert carried == pytest.approx([math.sqrt(0.5)] * 2, rel=1e-3)


def test_seams_give_the_same_bits_for_any_threads(lab):
    text = ROLLING + floor(60, 30.0, 2.0) + "[source]\nkind = 'pour'\ncount = 60\nrate = 5\nheight = 8\n[stop]\ntime = 20\n"
    hashes = {summary(lab.run(text, "--threads", n, out=f"t{n}"))["state_hash"] for n in (1, 2, 3)}
    assert len(hashes) == 1


# A disc rolls to and fro in a round bowl of pieces, radius 8, from a height of 0.96. The energy budget closes: seams make no
# energy and take none. It is exact to the jumps of the second face at a bend by a little more than 3 degrees, 1.4e-3.
@pytest.mark.parametrize("bend", [0.5, 2.0, 3.5, 10.0])
def test_a_bowl_of_pieces_keeps_the_energy_budget(lab, bend):
    corners = [(8 * math.sin(math.radians(a)), 8 - 8 * math.cos(math.radians(a))) for a in np.arange(-80, 80.1, bend)]
    bowl = "".join(wall(f"w{k}", a, b) for k, (a, b) in enumerate(zip(corners, corners[1:])))
    angle = math.radians(20)
    start = grain(7.5 * math.sin(angle), 8 - 7.5 * math.cos(angle))
    out = lab.run(ROLLING + bowl + start + "[stop]\ntime = 40\n[output]\nseries = 1\nenergy = true\n")
    energy = {name: datasets(out / "run.h5")[f"/energy/{name}"] for name in ("kinetic", "gravitational", "walls", "error")}
    assert abs(energy["error"]).max() < 3e-3
    assert energy["walls"][-1] < 0.1  # of 0.46 above the lowest place
