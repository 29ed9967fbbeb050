# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Walls as they stand: analyses, walls that meet, pistons, and sources beside walls. Units: diameter, mass, gravity."""

import math

import h5py
import numpy as np
import pytest
from conftest import Grains, datasets, number_in, summary

HOOKE = "[contact]\nfriction = 0.0\nnormal = { law = 'hooke', stiffness = 1e4, restitution = 0.5 }\n"
IMPACT = "gravity = 0.0\n[method]\ntime_step = 2e-5\n" + HOOKE


def wall(name, start, end, *lines):
    return "\n".join([f"[[wall]]\nname = '{name}'\nfrom = {list(start)}\nto = {list(end)}", *lines, ""])


# ---- analyses see walls where they stand

BED = """[method]
time_step = 0.001
[contact]
normal = { law = "hooke", stiffness = 1e4, damping = 0.5 }
[base]
kind = "row"
half_width = 12.0
[box]
x = "periodic"
half_width = 12.5
[source]
kind = "lattice"
rows = 14
columns = 25
[stop]
time = 5.0
"""


# A settled triangular lattice has the solid fraction pi / sqrt(12) = 0.9069, and the overlaps of its grains add 5e-4.
@pytest.mark.parametrize("walls", [
    "",
    wall("far above", (-12, 40), (-12, 50)),
    wall("beside the top", (3, 13.2), (3, 20)),
    wall("opened", (-20, 6), (20, 6.1), "opens_at = 0"),
    wall("gone", (-12, 40), (12, 40), "motion = 'velocity'", "velocity = [0, 5]"),
], ids=lambda text: text.split("'")[1] if text else "none")
def test_walls_elsewhere_do_not_cut_cells(lab, walls):
    assert summary(lab.run(BED + walls))["core"]["solid_fraction"] == pytest.approx(0.9074, abs=2e-4)


# A container of pieces of wall, tight around 5 x 4 discs at rest: all cells but those of the top are closed unit squares.
SQUARE = "gravity = 1.0\n[contact]\nnormal = { law = 'hooke', stiffness = 1e7, damping = 0.5 }\n[stop]\ntime = 0.02\n" + "".join(
    f"[[grain]]\nposition = [{x + 0.5}, {y + 0.5}]\n" for y in range(4) for x in range(5))
TRAY = wall("left", (0, 9), (0, 0)) + wall("floor a", (0, 0), (2, 0)) + wall("floor b", (2, 0), (9, 0)) + wall("right", (5, 0), (5, 9))


def cells(out):
    with h5py.File(out / "analysis.h5") as file:
        return {name: item[()] for name, item in file["voronoi"].items()}


def test_pieces_that_meet_close_cells(lab):
    found = cells(lab.run(SQUARE + TRAY))
    assert found["closed"].tolist() == [1] * 15 + [0] * 5
    assert found["area"][:15] == pytest.approx(1.0, abs=1e-4)


# The right side has moved away by 0.4 within the 0.02: the cells beside it are larger by as much, and no others.
def test_cells_end_at_a_wall_where_it_is(lab):
    moved = TRAY.replace("to = [5, 9]", "to = [5, 9]\nmotion = 'velocity'\nvelocity = [20.0, 0.0]")
    area = cells(lab.run(SQUARE + moved))["area"][:15].reshape(3, 5)
    assert area[:, :4] == pytest.approx(1.0, abs=2e-3)
    assert area[:, 4] == pytest.approx(1.4, abs=5e-3)


# Without the right side the cells there reach to the cut-off: larger than a closed one, open, and in no mean.
@pytest.mark.parametrize("right", ["opens_at = 0.0", "motion = 'velocity'\nvelocity = [500.0, 0.0]"])
def test_cells_beside_a_wall_that_is_gone_are_open(lab, right):
    found = cells(lab.run(SQUARE + TRAY.replace("to = [5, 9]", "to = [5, 9]\n" + right)))
    assert found["closed"][:15].reshape(3, 5).tolist() == [[1, 1, 1, 1, 0]] * 3
    assert (found["area"][[4, 9, 14]] > 1.5).all()
