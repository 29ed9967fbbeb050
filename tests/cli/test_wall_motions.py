# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Walls that vibrate, rotate, run as belts or stop, and global damping. Units: diameter, mass, gravity."""

import math

import h5py
import numpy as np
import pytest
from conftest import Grains, datasets
from wall_scenes import grain, wall

SOFT = """[method]
time_step = 0.0005
[contact]
friction = 0.5
normal = { law = "hooke", stiffness = 1e5, damping = 0.5 }
tangential = { law = "linear", stiffness = 5e4, damping = 0.3 }
"""
RIGID = """[method]
kind = "contact-dynamics"
time_step = 0.002
[contact]
friction = 0.5
"""
METHODS = pytest.mark.parametrize("method", [SOFT, RIGID], ids=["soft", "rigid"])
OUTPUT = "[output]\nseries = 0.02\n"


def stop(time):
    return f"[stop]\ntime = {time}\n"


def one_grain(out):
    """Position, velocity and rim velocity of the only grain."""
    found = datasets(out / "run.h5")
    radius = found["/grains/radius"][0]
    return found["/grains/position"][0], found["/grains/velocity"][0], found["/grains/spin"][0] * radius


# ---- vibration

# A plate shakes a disc at 0.6 of gravity, with which it never loses it: N = m (g + a), a = -A w^2 sin(w t). Rows are
# means over 0.02, which takes (w 0.02)^2 / 24 < 1e-3 of a; the spring, of 1e5, adds (w^2 / 1e5) < 1e-3; the start of the
# motion is a jump of velocity, whose ringing the dashpot has damped after two cycles.
@METHODS
def test_a_vibrating_plate_carries_weight_and_inertia(lab, method):
    w, top = 2.0 * math.pi, 0.6
    amplitude = top / w**2
    plate = wall("plate", (-3, 0), (3, 0), "motion = 'vibration'", f"amplitude = [0, {amplitude}]", "frequency = 1.0",
                 "start = 1.0")
    found = datasets(lab.run(method + plate + grain(0, 0.5) + stop(7) + OUTPUT) / "run.h5")
    time, force = found["/series/time"], -found["/series/wall_force_y"][:, 0]
    moved = found["/series/wall_displacement"][:, 0]
    since = np.maximum(time - 1.0, 0.0)
    assert moved == pytest.approx(amplitude * np.sin(w * since), abs=1e-12)
    late = time > 3.5
    middle = time - 0.01 - 1.0
    expected = 1.0 - top * np.sin(w * middle)
    assert force[late] == pytest.approx(expected[late], abs=0.01)


# At twice gravity the disc leaves the plate where the plate accelerates down at g, and the plate is free of it for a
# while; the same bits return after a stop, for a wall is where its time says.
def test_a_strong_vibration_throws_a_disc(lab):
    amplitude = 2.0 / (2.0 * math.pi) ** 2
    plate = wall("plate", (-3, 0), (3, 0), "motion = 'vibration'", f"amplitude = [0, {amplitude}]", "frequency = 1.0")
    found = datasets(lab.run(SOFT + plate + grain(0, 0.49999) + stop(5) + OUTPUT) / "run.h5")
    force = found["/series/wall_force_y"][:, 0]
    assert 0.5 < (force == 0.0).mean() < 0.98  # impacts are short
    assert force.mean() == pytest.approx(-1.0, abs=0.15)  # it carries the weight, up to the momentum of the last throw


# ---- rotation

def drum(*lines, omega=0.5):
    return "\n".join([f"[[drum]]\nname = 'drum'\nradius = 5.0\nangular_velocity = {omega}", *lines, ""])


# A disc without rolling resistance that rolls at the bottom of a rotating drum as fast as the drum stays there.
# The drum is a polygon of 128, whose corners are 5 (1 / cos(pi/128) - 1) = 0.0015 off the circle.
@METHODS
def test_a_disc_rolls_at_the_bottom_of_a_drum(lab, method):
    out = lab.run(method + drum(omega=0.2) + grain(0, -4.5) + "spin = 2.0\n" + stop(30))
    position, velocity, rim = one_grain(out)
    assert rim == pytest.approx(1.0, abs=0.02)  # 0.2 x 5, counter-clockwise as the drum
    assert abs(position[0]) < 0.05 and position[1] == pytest.approx(-4.5, abs=0.01)
    assert np.abs(velocity).max() < 0.05


# Rolling resistance carries a disc up to where the tangential force, m g sin, over the normal one is mu_r. It rolls there
# as fast as the drum. A constant torque damps nothing, so the disc swings about that place, with the period
# 2 pi (1.5 x 4.5)^(1/2) = 16.3 of a disc that rolls in a bowl; the mean over two periods is the place. Where a seam passes, the rolling
# spring lags behind the normal force for about 0.01 of 0.5, which lowers the mean by a few per cent of soft grains.
@pytest.mark.parametrize("method", [SOFT + 'rolling = { law = "spring", friction = 0.2 }\n',
                                    RIGID + "rolling_friction = 0.2\n"], ids=["soft", "rigid"])
def test_rolling_resistance_carries_a_disc_up_a_drum(lab, method):
    angle = math.atan(0.2)
    there = grain(4.5 * math.sin(angle), -4.5 * math.cos(angle)) + "spin = 1.0\n"
    out = lab.run(method + drum(omega=0.1) + there + stop(32.6) + "[output]\ntrack = 0.2\n")
    with h5py.File(out / "run.h5") as file:
        x, y = np.concatenate([file[f"track/{name}/position"][()] for name in file["track"]]).T
    angles = np.arctan2(x, -y)
    assert angles.mean() == pytest.approx(angle, abs=0.012)
    assert np.ptp(angles) < 0.1


# The power of the drum on a disc that is carried up and rolls there is dissipated: the budget closes.
def test_the_work_of_a_drum_is_booked(lab):
    method = SOFT + 'rolling = { law = "spring", friction = 0.2 }\n'
    found = datasets(lab.run(method + drum(omega=0.2) + grain(0, -4.5) + stop(40) + OUTPUT + "energy = true\n")
                     / "run.h5")
    work = found["/energy/walls_work"][-1]
    assert work > 1.0
    assert abs(found["/energy/error"]).max() < 0.01 * work


# One wall that turns about its end by a quarter, and stops.
@METHODS
def test_a_wall_turns_and_stops(lab, method):
    arm = wall("arm", (0, 0), (4, 0), "motion = 'rotation'", "centre = [0, 0]",
               f"angular_velocity = {0.5 * math.pi}", "start = 1.0", "stop = 2.0")
    found = datasets(lab.run(method + arm + grain(2, -20) + stop(3) + OUTPUT) / "run.h5")
    assert found["/walls/position"][0] == pytest.approx([0.0, 2.0], abs=1e-9)
    assert found["/walls/normal"][0] == pytest.approx([-1.0, 0.0], abs=1e-9)
    time, angle = found["/series/time"], found["/series/wall_displacement"][:, 0]
    assert angle == pytest.approx(0.5 * math.pi * np.clip(time - 1.0, 0.0, 1.0), abs=1e-9)


def test_a_plane_cannot_rotate(lab):
    scene = lab.scene("[[plane]]\npoint = [0, 0]\nnormal = [0, 1]\nmotion = 'rotation'\ncentre = [0, 0]\nangular_velocity = 1.0\n"
              + stop(1))
    lab.refused("check", scene, parts=["plane[0].motion", "endless", "[[wall]]"])


def test_a_motion_cannot_stop_before_it_starts(lab):
    scene = lab.scene(wall("w", (0, 0), (1, 0), "motion = 'velocity'", "velocity = [1, 0]", "start = 3", "stop = 2") + stop(1))
    lab.refused("check", scene, parts=["wall[0].stop", "after its start"])


# ---- belts

# A disc that is put on a belt of speed V slides until v + rim = V, with v = V/3 (the rim gains twice as much); the belt
# does the work m V^2 / 3. The wall stays where it is.
@METHODS
def test_a_belt_drives_a_disc_and_stays(lab, method):
    belt = wall("belt", (-2, 0), (30, 0), "motion = 'belt'", "speed = 3.0")
    out = lab.run(method + belt + grain(0, 0.5) + stop(6) + OUTPUT)
    _, velocity, rim = one_grain(out)
    assert velocity[0] == pytest.approx(1.0, abs=5e-3)
    assert abs(rim) == pytest.approx(2.0, abs=1e-2)
    found = datasets(out / "run.h5")
    assert found["/walls/position"][0] == pytest.approx(found["/walls/point"][0], abs=0)


def test_the_work_of_a_belt_is_booked(lab):
    belt = wall("belt", (-2, 0), (30, 0), "motion = 'belt'", "speed = 3.0")
    found = datasets(lab.run(SOFT + belt + grain(0, 0.49999) + stop(6) + OUTPUT + "energy = true\n") / "run.h5")
    assert found["/energy/walls_work"][-1] == pytest.approx(3.0, abs=0.01)
    assert abs(found["/energy/error"]).max() < 0.01


# Below a belt its surface runs backwards, as that of a real one: a disc pressed to it from below is driven the other way.
def test_a_belt_runs_back_below(lab):
    belt = wall("belt", (-20, 0), (20, 0), "motion = 'belt'", "speed = 3.0")
    push = "[[load]]\ngrain = 0\nforce = [0, 2]\n"
    out = lab.run(SOFT + belt + grain(0, -0.49999) + push + stop(4))
    _, velocity, _ = one_grain(out)
    assert velocity[0] == pytest.approx(-1.0, abs=5e-3)


# Pressure and shear on one wall: a disc between a floor and a piston whose surface runs at V rolls at V/2, and the piston
# keeps its force. Its normal points down, so its surface runs to the left.
def test_a_piston_presses_and_shears(lab):
    piston = ("[[plane]]\nname = 'piston'\npoint = [0, 1]\nnormal = [0, -1]\nmotion = 'force'\nforce = [0, -5]\nmass = 20.0\n"
              "drag = 20.0\nsurface_speed = 0.4\n")
    floor = "[[plane]]\nname = 'floor'\npoint = [0, 0]\nnormal = [0, 1]\n"
    out = lab.run(SOFT + piston + floor + grain(0, 0.5) + stop(10) + OUTPUT)
    position, velocity, rim = one_grain(out)
    assert velocity[0] == pytest.approx(-0.2, abs=2e-3) and abs(rim) == pytest.approx(0.2, abs=2e-3)
    found = datasets(out / "run.h5")
    force = found["/series/wall_force_y"][-50:, 0]  # of the grain on the piston
    assert force == pytest.approx(5.0, abs=0.01)
    scene = lab.scene(RIGID + piston + floor + grain(0, 0.5) + stop(1))
    lab.refused("check", scene, parts=["plane[0].surface_speed", "not that of a piston"])


# ---- global damping

FLIGHT = "[method]\ntime_step = 0.001\n{}\n[box]\nfloor = -1000\n" + grain(0, 0)


# dv/dt = -g - c v: v = -(g/c) (1 - exp(-c t)). Leapfrog is of second order: (c dt)^2 / 12 < 1e-7.
def test_viscous_damping_limits_the_speed_of_a_fall(lab):
    out = lab.run(FLIGHT.format("viscous_damping = 0.5") + stop(3) + OUTPUT + "energy = true\n")
    _, velocity, _ = one_grain(out)
    late = 3.0 - 0.0005  # velocities are those of half a step before
    assert velocity[1] == pytest.approx(-2.0 * (1.0 - math.exp(-0.5 * late)), abs=1e-6)
    energy = datasets(out / "run.h5")
    assert abs(energy["/energy/error"]).max() < 1e-6 and energy["/energy/drag"][-1] > 1.0


def test_local_damping_takes_a_fraction_of_gravity(lab):
    out = lab.run(FLIGHT.format("local_damping = 0.3") + stop(2) + OUTPUT + "energy = true\n")
    _, velocity, _ = one_grain(out)
    assert velocity[1] == pytest.approx(-0.7 * (2.0 - 0.0005), abs=1e-9)
    energy = datasets(out / "run.h5")
    assert abs(energy["/energy/error"]).max() < 1e-6  # of the first half step, (g dt)^2 / 8
    assert energy["/energy/drag"][-1] == pytest.approx(0.3 * -energy["/energy/gravitational"][-1], rel=1e-6)


# Local damping acts on the net force alone: at rest it changes nothing, whatever the fraction.
def test_local_damping_leaves_equilibrium_as_it_is(lab):
    bed = SOFT.replace("time_step = 0.0005", "time_step = 0.0005\nlocal_damping = FRACTION") + wall("floor", (-3, 0), (3, 0))
    heights = [one_grain(lab.run(bed.replace("FRACTION", a) + grain(0, 0.6) + stop(30), out=f"out{a}"))[0][1] for a in ("0", "0.7")]
    assert heights == pytest.approx([0.5 - 1e-5] * 2, abs=1e-9)


def test_damped_runs_have_the_same_bits_for_any_threads(lab):
    bed = SOFT.replace("time_step = 0.0005", "time_step = 0.0005\nlocal_damping = 0.2\nviscous_damping = 0.1")
    scene = bed + drum() + "".join(grain(x, -3.5 + 0.2 * x) for x in (-2.2, -1.1, 0.0, 1.1, 2.2)) + stop(3)
    one = Grains(lab.run(scene, "--threads", "1", out="one") / "run.h5")
    two = Grains(lab.run(scene, "--threads", "2", out="two") / "run.h5")
    assert (one.position == two.position).all()
