# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The hybrid method through the program: lattice piles at rest, discs that are dropped, resuming, refused scenes."""

import signal
import subprocess
import time
from pathlib import Path

import h5py
import numpy as np
import pytest

from conftest import PROGRAM, summary, text_attribute

PILE = """
[method]
kind = "hybrid"
stiffness = 1e5
static_friction = 0.6
relax = true
[base]
kind = "plane"
[source]
kind = "lattice"
rows = 45
[box]
half_width = 30
[stop]
time = 0.2
[output]
series = 0.1
"""

DROPPED = """
[method]
kind = "hybrid"
[contact]
restitution = 0.5
friction = 0.3
rolling_friction = 0.1
[base]
kind = "row"
half_width = 8
[source]
kind = "pour"
count = 25
rate = 2.0
height = 8
half_width = 2
[stop]
time = 24
[output]
series = 2
"""

ONE_DISC = """
[method]
kind = "hybrid"
[base]
kind = "plane"
[[grain]]
position = [0, 0.5]
[stop]
time = 1
"""


def contacts_of(folder):
    with h5py.File(folder / "run.h5") as file:
        return {name: data[()] for name, data in file["contacts"].items()}


# The equilateral pile of Liffman, Chan and Hughes: (42) and (44) hold to 0.5 %, the weight to 1e-6, and no disc touches
# its neighbour in the row. Measured: 5e-4 and 2e-4.
def test_equilateral_pile(lab):
    folder = lab.run(PILE)
    contacts = contacts_of(folder)
    grains = contacts["grains"]
    on_ground = grains[:, 1] < 0
    normal = contacts["normal_force"][on_ground]
    across = contacts["tangential_force"][on_ground].ravel()
    assert len(normal) == 45
    assert normal.sum() == pytest.approx(1035, rel=1e-6)
    assert np.abs(normal / 23 - 1).max() < 0.005
    # On the discs, along the tangent (-1, 0) of the ground: what they exert on it to the right.
    expected = (2 * np.arange(1, 46) - 46) / (2 * np.sqrt(3))
    assert np.abs(across - expected).max() < 0.005 * expected.max()
    assert not ((np.abs(contacts["normal"][:, 1]) < 0.1) & ~on_ground).any()
    found = summary(folder)
    assert found["status"] == "finished"
    assert found["collisions"]["hard"] == 0 and found["collisions"]["iterations"] > 0
    assert found["collisions"]["worst_residual"] <= 1e-7


# Poured discs fly, collide, turn soft and part again; their counts are there row by row. In the end the base carries
# the weight.
def test_discs_collide_hard_and_come_to_rest_soft(lab):
    folder = lab.run(DROPPED)
    found = summary(folder)
    counts = found["collisions"]
    assert counts["hard"] > 25 and counts["softened"] > 25 and counts["hardened"] > 0
    assert abs(found["weight_error"]) < 0.05  # some still roll
    with h5py.File(folder / "run.h5") as file:
        series = {name: data[:] for name, data in file["collisions"].items()}
    for name in ("hard", "softened", "hardened", "iterations", "steps"):
        assert series[name].sum() == counts[name], name
    assert series["hard"][-1] < series["hard"].max()


def test_threads_change_no_bit(lab):
    one = lab.run(DROPPED, "--threads", "1", "--set", "stop.time=10", out="one")
    two = lab.run(DROPPED, "--threads", "2", "--set", "stop.time=10", out="two")
    assert text_attribute(one / "run.h5", "state_hash") == text_attribute(two / "run.h5", "state_hash")


# Interrupted and resumed, it ends in the state of a run that was not.
def test_resumed_run_has_the_same_bits(lab):
    whole = lab.run(DROPPED, out="whole")
    process = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", "parts", "--quiet"], cwd=lab.path,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(0.4)
    process.send_signal(signal.SIGINT)
    process.wait()
    if summary(lab.path / "parts")["status"] == "interrupted":
        assert lab("resume", "parts", "--quiet").returncode == 0
    parts = lab.path / "parts"
    assert text_attribute(whole / "run.h5", "state_hash") == text_attribute(parts / "run.h5", "state_hash")


@pytest.mark.parametrize("more, part", [
    ('[[wall]]\nfrom = [-2, 1]\nto = [2, 1]', "endless walls alone"),
    ('[[plane]]\npoint = [0, -5]\nnormal = [0, 1]\nmotion = "velocity"\nvelocity = [0, 1]', "stand still"),
    ('[[load]]\ngrain = 0\nforce = [0, -1]', "knows no loads"),
])
def test_what_it_does_not_know_is_refused(lab, more, part):
    lab.scene(ONE_DISC + more + "\n")
    lab.refused("check", "scene.toml", parts=[part])


def test_laws_that_it_does_not_know_are_refused(lab):
    lab.scene(ONE_DISC)
    lab.refused("check", "scene.toml", "--set", "contact.tangential_restitution=0.5", parts=["must be 0"])
    lab.refused("check", "scene.toml", "--set", "gravity=0", parts=["without gravity it must be given"])
    lab.refused("check", "scene.toml", "--set", "contact.friction=inf", parts=["method.static_friction"])


# A pile on ground too smooth for it cannot be brought to rest: the run fails and names a grain.
def test_relaxation_without_an_equilibrium_is_an_error(lab):
    lab.scene(PILE)
    result = lab("run", "scene.toml", "--out", "out", "--quiet", "--set", "method.static_friction=0.1", "--set",
                 "source.rows=10")
    assert result.returncode == 1
    assert "grain" in result.stderr


# Against the impulses by hand, (12), (16) and (19): P_n = (1 + e) m_n v_n, and along the surfaces P_t = m_n v_t/3 where they
# stick, mu P_n where they slip. Places at the touch have the rounding of its time alone.
def test_few_bodies_collide_as_by_hand(lab):
    result = lab("run", Path(__file__).parents[2] / "examples" / "collisions.toml", "--out", "out", "--quiet")
    assert result.returncode == 0, result.stderr
    with h5py.File(lab.path / "out" / "run.h5") as file:
        velocity, spin = file["grains/velocity"][()], file["grains/spin"][()]
    e, mu = 0.8, 0.2
    np.testing.assert_allclose(velocity[:2], [[0.1, 0.0], [0.9, 0.0]], atol=1e-12)
    for first, height, spinning, sticks in ((2, 0.7, 20.0, False), (4, 0.1, 0.0, True)):
        normal = np.array([-np.sqrt(1.0 - height**2), -height])  # from the disc at rest to the other
        tangent = np.array([-normal[1], normal[0]])
        across = tangent[0] - 0.5 * spinning
        pressed = 0.5 * (1.0 + e) * -normal[0]
        along = -np.sign(across) * min(abs(across) / 6.0, mu * pressed)
        assert (abs(along) < mu * pressed) == sticks
        impulse = pressed * normal + along * tangent
        np.testing.assert_allclose(velocity[first], [1.0, 0.0] + impulse, atol=1e-12)
        np.testing.assert_allclose(velocity[first + 1], -impulse, atol=1e-12)
        np.testing.assert_allclose(spin[first : first + 2], [spinning - 4.0 * along, -4.0 * along], atol=1e-11)
    np.testing.assert_allclose(velocity[6:8], [[0.64, 0.0], [1.44, 0.0]], atol=1e-12)
    # The wall: v_t = -R w, P_t = m v_t/3 at most 0.2 (1 + e).
    np.testing.assert_allclose(velocity[8], [-0.2 * 1.8, e], atol=1e-12)
    np.testing.assert_allclose(velocity[9:].sum(axis=0), [1.0, 0.0], atol=1e-10)
    assert summary(lab.path / "out")["collisions"]["hard"] >= 6
