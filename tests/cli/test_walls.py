# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Walls as they stand: analyses, pistons, and sources beside walls. Units: diameter, mass, gravity."""

import math

import h5py
import numpy as np
import pytest
from conftest import Grains, datasets, number_in, summary
from wall_scenes import IMPACT, POUR, SQUARE, TRAY, grain, wall

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


# ---- pistons

def piston(mass, restitution=0.5, extra=""):
    text = IMPACT.replace("restitution = 0.5", f"restitution = {restitution}")
    return text + f"""[[plane]]
name = "p"
point = [0.0, 0.0]
normal = [0.0, 1.0]
motion = "force"
force = [0.0, -1e-12]
mass = {mass}
{extra}[[grain]]
position = [0.0, 0.51]
velocity = [0.0, -1.0]
[stop]
time = 0.2
[output]
series = 0.001
"""


# Both bodies fly apart with the asked fraction of the closing speed, and momentum is conserved.
@pytest.mark.parametrize("mass", [0.1, 1.0, 10.0])
@pytest.mark.parametrize("restitution", [0.5, 0.9])
def test_restitution_against_a_piston(lab, mass, restitution):
    out = lab.run(piston(mass, restitution))
    found = datasets(out / "run.h5")
    height, time = -found["/series/wall_displacement"][:, 0], found["/series/time"]  # it moves along its force, down
    speed = (height[-1] - height[-21]) / (time[-1] - time[-21])
    rebound = Grains(out / "run.h5").velocity[0, 1]
    assert rebound - speed == pytest.approx(restitution, abs=2e-3)
    assert rebound + mass * speed == pytest.approx(-1.0, abs=2e-3)


# A piston that has not begun to move is a wall that nothing moves.
def test_restitution_before_a_piston_starts(lab):
    out = lab.run(piston(0.1, extra="start = 5.0\n"))
    assert Grains(out / "run.h5").velocity[0, 1] == pytest.approx(0.5, abs=1e-3)


LIGHT = """[contact]
friction = 0.3
normal = { law = "hooke", stiffness = 1e4, damping = 0.3 }
tangential = { law = "linear", stiffness = 5e3, damping = 0.1 }
[grains]
polydispersity = 0.2
[base]
kind = "plane"
[[plane]]
name = "left"
point = [-8.0, 0.0]
normal = [1.0, 0.0]
[[plane]]
name = "right"
point = [8.0, 0.0]
normal = [-1.0, 0.0]
[[plane]]
name = "piston"
point = [0.0, 60.0]
normal = [0.0, -1.0]
motion = "force"
force = [0.0, -160.0]
mass = 0.08
drag = 1.0
start = 60.0
[source]
kind = "pour"
count = 200
rate = 10.0
height = 45.0
half_width = 7.0
[box]
half_width = 20.0
[stop]
time = 160.0
[output]
series = 0.5
energy = true
"""


# Sixteen or more grains press on this piston at once: it cannot follow them, and only a heavier one is accepted.
def test_a_piston_too_light_for_its_bed_is_refused(lab):
    lab.scene(LIGHT)
    message = lab.refused("check", "scene.toml", parts=["plane[2].mass = 0.08: too light for the time step", "21 grains"])
    least = number_in(message, "at least")
    assert 1.0 < least < 5.0
    lab.scene(LIGHT.replace("mass = 0.08", f"mass = {1.01 * least}"))
    assert lab("check", "scene.toml").returncode == 0


# The lightest piston that is accepted presses the bed as a heavy one does. Beds of other grains differ by 0.2, those under
# a light and a heavy piston by up to 0.15 (three seeds).
def test_the_lightest_piston_is_stable(lab):
    lab.scene(LIGHT)
    least = number_in(lab.refused("check", "scene.toml"), "at least")
    out = lab.run(LIGHT.replace("mass = 0.08", f"mass = {1.01 * least}"))
    found = datasets(out / "run.h5")
    displacement = found["/series/wall_displacement"][:, 3]
    heavy = datasets(lab.run(LIGHT.replace("mass = 0.08", "mass = 20"), out="heavy") / "run.h5")
    assert displacement[-1] == pytest.approx(heavy["/series/wall_displacement"][-1, 3], abs=0.3)
    assert np.abs(np.diff(displacement[found["/series/time"] > 80])).max() < 0.01
    supplied = found["/energy/sources"][-1] + found["/energy/walls_work"][-1]
    assert abs(found["/energy/error"][-1]) < 0.01 * supplied


# ---- sources

def most_energy(out):
    return datasets(out / "run.h5")["/series/kinetic_energy_per_grain"].max()


# A fall from height 20 gives 20; no grain is born inside the shelf, which would shoot it away. There is room for one grain
# at a time beside it, until that has fallen by a diameter in 1.41.
def test_grains_are_not_born_in_a_wall(lab):
    out = lab.run(POUR + wall("shelf", (-2, 20), (3, 20.2)))
    assert most_energy(out) <= 20.0
    assert 8 <= summary(out)["grains_released"] <= 12


# The opening from -3 to 3 is closed until the gate has gone; grains wait until then.
def test_grains_wait_for_a_gate(lab):
    out = lab.run(POUR + wall("gate", (-4, 20), (4, 20), "opens_at = 5"))
    found = datasets(out / "run.h5")
    assert (found["/series/grains"][found["/series/time"] < 4.95] == 0).all()
    assert summary(out)["grains_released"] > 10 and most_energy(out) <= 20.0


# A plane sweeps through the opening from the left: grains come to lie in front of it, never behind.
def test_grains_are_not_born_behind_a_plane(lab):
    plane = "[[plane]]\nname = 'pusher'\npoint = [-5, 0]\nnormal = [1, 0]\nmotion = 'velocity'\nvelocity = [0.5, 0]\n"
    out = lab.run(POUR + plane)
    assert most_energy(out) <= 20.0
    assert (Grains(out / "run.h5").position[:, 0] > -5 + 0.5 * 16 + 0.4).all()


@pytest.mark.parametrize("walls, part", [
    (wall("lid", (-9, 20.1), (9, 20.1)), 'source.height = 20: no grain ever finds room there: wall "lid" is in the way'),
    ("[[plane]]\nname = 'roof'\npoint = [0, 15]\nnormal = [0, -1]\n", 'wall "roof" is in the way'),
])
def test_sources_without_any_room_are_refused(lab, walls, part):
    lab.scene(POUR + walls)
    lab.refused("check", "scene.toml", parts=[part])


def test_grains_of_the_start_in_walls_are_refused(lab):
    text = "[contact]\nnormal = { law = 'hooke', stiffness = 1e4 }\n[base]\nkind = 'plane'\n[stop]\ntime = 1\n"
    lattice = "[source]\nkind = 'lattice'\nrows = 4\ncolumns = 6\ngap = 0.05\n"
    lab.scene(text + lattice + wall("post", (1.0, 0.0), (1.0, 2.0)))
    lab.refused("check", "scene.toml", parts=['source.kind = "lattice": grain at', 'wall "post" presses into it by'])
    lab.scene(text + lattice + wall("post", (9.0, 0.0), (9.0, 2.0)))
    assert lab("check", "scene.toml").returncode == 0
    lab.scene(text + grain(0.0, 0.2))
    lab.refused("check", "scene.toml", parts=['grain[0].position = [0, 0.2]: wall "base" presses into it by 0.3 diameters'])


# Rigid discs laid down one by one come to lie on pieces of wall too, not under or in them.
def test_discs_are_laid_on_pieces_of_wall(lab):
    text = """[method]
kind = "contact-dynamics"
[contact]
friction = 0.5
rolling_friction = 0.1
[base]
kind = "plane"
[source]
kind = "sequential"
count = 12
half_width = 5
[stop]
time = 40
"""
    out = lab.run(text + wall("shelf", (-3, 4), (3, 4)))
    height = Grains(out / "run.h5").position[:, 1]
    assert (height > 0.49).all()
    assert ((height < 3.51) | (height > 4.49)).all() and (height > 4.0).any()
