# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Contact dynamics through the program: packings, resuming, the series of the solver, refused scenes."""

import signal
import subprocess

import h5py
import numpy as np
import pytest

from conftest import PROGRAM, Grains, Laboratory, summary, text_attribute
from interruption import wait_until

SEQUENTIAL = """
[method]
kind = "contact-dynamics"
critical_angle = 50
tolerance = 1e-4
[base]
kind = "contiguous"
count = 12
[source]
kind = "sequential"
count = %d
[stop]
at_rest = 0.01
time = 2000
[output]
series = 5
"""


def places(folder):
    with h5py.File(folder / "run.h5") as file:
        return file["grains/position"][:], file["grains/fixed"][:] != 0


# Long after the last grain came to rest, the base carries the weight (residuals of 1e-4 with either sign), and no overlap
# exceeds 1e-3 of a radius plus the amount that a step may add.
def test_grains_are_deposited_one_by_one(lab):
    found = summary(lab.run((SEQUENTIAL % 40).replace("at_rest = 0.01\ntime = 2000", "time = 400")))
    assert found["status"] == "finished" and found["grains"] == 40
    assert found["max_overlap"] < 2e-3
    assert abs(found["weight_error"]) < 1e-3
    solver = found["solver"]
    assert solver["steps"] == found["steps"] and solver["tolerance"] == 1e-4
    # The limit on sweeps is for steps that cycle. In this small packing 1 % of the steps do; none would mean another solver.
    assert solver["unconverged"] <= 0.05 * solver["steps"]


def test_solver_has_series(lab):
    folder = lab.run(SEQUENTIAL % 10)
    with h5py.File(folder / "run.h5") as file:
        solver = {name: data[:] for name, data in file["solver"].items()}
        assert len(solver["time"]) == len(file["series/time"])
    found = summary(folder)["solver"]
    assert solver["steps"].sum() == found["steps"]
    assert solver["unconverged"].sum() == found["unconverged"]
    assert solver["residual"].max() == found["worst_residual"] > 0
    assert (solver["sweeps"] >= 0).all() and solver["sweeps"].sum() > 0
    # At rest the creep of a converged packing is below the requested limit of 5e-3 g dt.
    assert 0 <= solver["creep_rate"][-1] < 5e-3 * 0.2237


# At 90 degrees a critical-angle packing is in equilibrium: each branch hangs on its contact, which carries any torque.
# The residual of 1e-8 g dt moves a contact by 5e-10 in a step. 112 steps, and branches of some ten discs that turn about
# their roots, amplify this by at most 1e3.
def test_packing_of_sticking_discs_does_not_move(lab):
    deposition = """
[method]
kind = "deposition"
critical_angle = 90
[base]
count = 16
[source]
count = 60
"""
    before = lab.run(deposition)
    held = f"""
[start]
from = "{before}"
[method]
kind = "contact-dynamics"
speed_limit = 0.2236
[box]
x = "periodic"
half_width = 8
[stop]
time = 25
"""
    after = lab.run(held, "--set", "method.critical_angle=90", "--set", "method.tolerance=1e-8", "--set",
                    "method.most_sweeps=50000", out="held")
    assert summary(after)["solver"]["unconverged"] == 0
    first, _ = places(before)
    last, fixed = places(after)
    moved = last - first
    moved[:, 0] -= 16 * np.round(moved[:, 0] / 16)
    assert np.abs(moved[~fixed]).max() < 1e-4
    # Without rolling friction it collapses.
    rolling = summary(lab.run(held, "--set", "method.critical_angle=20", "--set", "method.tolerance=1e-4", out="rolling"))
    assert rolling["packing"]["solid_fraction"]["mean"] > 1.1 * summary(after)["packing"]["solid_fraction"]["mean"]


# A block on a piston under a force: piston and load rise together with the acceleration (F - W)/(M + m).
def test_piston_lifts_a_load(lab):
    folder = lab.run("""
[method]
kind = "contact-dynamics"
time_step = 0.01
tolerance = 1e-10
[[plane]]
name = "lift"
point = [0, 0]
normal = [0, 1]
motion = "force"
force = [0, 5]
mass = 2
[[grain]]
position = [0, 0.5]
[[grain]]
position = [3, 0.5]
[stop]
time = 2
""")
    with h5py.File(folder / "run.h5") as file:
        displacement = file["series/wall_displacement"][-1]
    # Leapfrog is exact at whole steps, except for the first half step.
    assert abs(displacement[0] - 0.5 * (5 - 2) / 4 * 2**2) < 1e-6


# A run that Ctrl-C or kill -9 stops in the middle ends, after resuming, with the same bits as an undisturbed run.
@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_resuming_gives_the_same_bits(lab, how, tmp_path):
    text = SEQUENTIAL % 110 + "checkpoint = 0.02\n"
    whole = summary(lab.run(text))
    scene = tmp_path / "cut.toml"
    scene.write_text(text)
    folder = tmp_path / "cut"
    process = subprocess.Popen([PROGRAM, "run", scene, "--out", folder, "--quiet"])
    wait_until(folder, 0.4 * whole["time"])
    process.send_signal(how)
    assert process.wait() == (130 if how == signal.SIGINT else -signal.SIGKILL)
    subprocess.run([PROGRAM, "resume", folder, "--threads", "2", "--quiet"], check=True)
    again = summary(folder)
    assert again["state_hash"] == whole["state_hash"]
    assert again["solver"]["contact_iterations"] == whole["solver"]["contact_iterations"]


# A disc that cannot roll slides on a floor with friction 0.4 at rest and 0.1 above the slip speed 0.5. So dv/dt = -0.1
# down to v = 0.5, then dv/dt = -mu(v) g with mu = 0.4 - 0.6 v, and v = 0.5 exp(0.6 t) - (0.4/0.6)(exp(0.6 t) - 1). From
# 1.0 it slows to 0.5 after a time of 5, and stops where exp(0.6 t) = 4. Each step uses the slip speed before it, which
# gives an error of the order of dt.
def test_friction_weakens_with_slip(lab):
    folder = lab.run("""
[method]
kind = "contact-dynamics"
time_step = 0.001
[contact]
friction = 0.4
rolling_friction = inf
weakening_velocity = 0.5
dynamic_friction = 0.1
[base]
kind = "plane"
[[grain]]
position = [0, 0.5]
velocity = [1, 0]
[stop]
time = 9
[output]
frames = 1
series = 1
""")
    with h5py.File(folder / "run.h5") as file:
        energy, t = file["series/kinetic_energy_per_grain"][:], file["series/time"][:]
    speed = np.sqrt(2 * energy)
    early, late = t <= 4.5, (t > 5.5) & (t < 7)
    weak = lambda s: 0.5 * np.exp(0.6 * s) - (0.4 / 0.6) * (np.exp(0.6 * s) - 1)
    assert np.abs(speed - (1 - 0.1 * t))[early].max() < 1e-3
    assert late.any() and np.abs(speed[late] - weak(t[late] - 5)).max() < 3e-3
    assert speed[-1] < 1e-9


def test_unconverged_steps_warn_or_stop(tmp_path):
    text = SEQUENTIAL % 30
    short = ["--set", "method.most_sweeps=3"]
    scene = tmp_path / "short.toml"
    scene.write_text(text)
    warned = subprocess.run([PROGRAM, "run", scene, "--out", tmp_path / "a", *short], capture_output=True, text=True)
    assert warned.returncode == 0
    assert "did not converge" in warned.stdout
    stopped = subprocess.run([PROGRAM, "run", scene, "--out", tmp_path / "b", *short, "--set",
                              "method.unconverged=error"], capture_output=True, text=True)
    assert stopped.returncode == 1
    assert "did not converge" in stopped.stderr
    assert summary(tmp_path / "b")["status"] == "failed"


@pytest.mark.parametrize("more, said", [
    ("method.critical_angle=91", "method.critical_angle = 91: must be >= 0 and <= 90"),
    ("contact.friction=-1", "contact.friction = -1: must be >= 0, or inf"),
    ("contact.rolling_friction=0.3", "method.critical_angle = 50 says 1.19175"),
    ("contact.restitution=1.5", "contact.restitution = 1.5: must be >= 0 and <= 1"),
    ("contact.normal.law=hooke", "contact.normal"),
    ("contact.weakening_velocity=0.1", "infinite friction cannot weaken"),
    ("contact.weakening_velocity=0.1", "contact.dynamic_friction: missing"),
    ("method.tolerance=0", "method.tolerance = 0: must be > 0"),
    ("method.most_sweeps=0", "method.most_sweeps = 0: must be a whole number from 1"),
    ("method.unconverged=maybe", "method.unconverged"),
    ("method.time_step=1", "radii of the smallest grain in a step; at most 1"),
    ("gravity=0", "needs gravity > 0"),
    ("source.half_width=50", "grains must be released within the box"),
    ("output.energy=true", "output.energy"),
])
def test_refused(tmp_path, more, said):
    scene = tmp_path / "scene.toml"
    scene.write_text(SEQUENTIAL % 30)
    tried = subprocess.run([PROGRAM, "run", scene, "--out", tmp_path / "out", "--set", more], capture_output=True,
                           text=True)
    assert tried.returncode == 2
    assert said in tried.stderr, tried.stderr
    assert not (tmp_path / "out").exists()


def test_sequential_source_needs_contact_dynamics(tmp_path):
    scene = tmp_path / "scene.toml"
    scene.write_text("[source]\nkind = \"sequential\"\n[stop]\ntime = 1\n")
    tried = subprocess.run([PROGRAM, "check", scene], capture_output=True, text=True)
    assert tried.returncode == 2 and "source.kind" in tried.stderr


RIGID_HEAP = """[method]
kind = "contact-dynamics"
tolerance = 1e-5
[contact]
friction = 0.5
[base]
kind = "row"
half_width = 12
[source]
kind = "pour"
count = 60
rate = 1.0
height = 10
half_width = 2
[stop]
at_rest = 1e-5
time = 400
"""


def message(out):
    return text_attribute(out / "run.h5", "message")


def contact_forces(out):
    with h5py.File(out / "run.h5") as file:
        pairs = [tuple(pair) for pair in file["contacts/grains"][()]]
        return dict(zip(pairs, zip(file["contacts/normal_force"][()], file["contacts/tangential_force"][()])))


# A rested heap that starts a new run has the forces with which it rested, from the first step on. The bound is 2 % rms
# of the mean force; the solver's tolerance leaves less.
@pytest.mark.parametrize("steps", [1, 2, 50])
def test_a_rested_heap_starts_with_its_forces(tmp_path, steps):
    lab = Laboratory(tmp_path)
    first = lab.run(RIGID_HEAP, out="first")
    assert "at rest" in message(first)
    with h5py.File(first / "run.h5") as file:
        step = file.attrs["time_step"]
    before = contact_forces(first)
    scene = RIGID_HEAP[:RIGID_HEAP.index("[base]")].replace("[contact]", f"time_step = {step!r}\n[contact]")
    second = lab.run(f"[start]\nfrom = 'first'\n{scene}[stop]\ntime = {steps * step!r}\n[output]\nseries = {step!r}\n",
                     out="second")
    after = contact_forces(second)
    mean = np.mean([normal for normal, _ in before.values()])
    none = (0.0, 0.0)
    change = [np.subtract(after.get(pair, none), before.get(pair, none)) for pair in before.keys() | after.keys()]
    assert np.sqrt(np.mean(np.sum(np.square(change), axis=1))) < 0.02 * mean
    with h5py.File(second / "run.h5") as file:
        weight = file["grains/mass"][()][file["grains/fixed"][()] == 0].sum()
        carried = file["base/normal"][()].sum()  # in weights of a nominal grain
    assert carried * Grains(second / "run.h5").moving("mass").mean() == pytest.approx(weight, rel=2e-3)


# A grain that rolls on is not at rest, however many others are; and rest does not depend on the rows of the series.
@pytest.mark.parametrize("series", [0.5, 1e12])
def test_at_rest_is_a_maximum_over_grains(tmp_path, series):
    lab = Laboratory(tmp_path)
    still = "".join(f"[[grain]]\nposition = [{-2 - 1.5 * k}, 0.5]\n" for k in range(40))
    rolling = "[[grain]]\nposition = [0.0, 0.5]\nvelocity = [0.3, 0.0]\nspin = -0.6\n"
    floor = "[method]\nkind = 'contact-dynamics'\n[base]\nkind = 'plane'\n[box]\nhalf_width = 100\n"
    stop = f"[stop]\nat_rest = 1e-2\ntime = 60\n[output]\nseries = {series}\n"
    moving = lab.run(floor + still + rolling + stop, out="moving")
    assert "stop.time" in message(moving)
    at_rest = lab.run(floor + still + stop, out="still")
    assert "at rest" in message(at_rest) and summary(at_rest)["time"] < 12.0


# No admissible impulse lifts the disc out of the notch: a normal impulse R and friction 0.35 R lift by
# 2 R (0.312 - 0.95 x 0.35) < 0. A fall of 2.688 gives the largest kinetic energy.
def test_a_jamming_notch_creates_no_energy(tmp_path):
    lab = Laboratory(tmp_path)
    fixed = "".join(f"[[grain]]\nposition = [{x}, 0.0]\nfixed = true\n" for x in (-0.95, 0.95))
    scene = ("[method]\nkind = 'contact-dynamics'\ntime_step = 0.01\n[contact]\nfriction = 0.35\nrestitution = 0.9\n"
             f"{fixed}[[grain]]\nposition = [0.0, 3.0]\n[stop]\ntime = 20\n[output]\nseries = 0.01\n")
    out = lab.run(scene)
    with h5py.File(out / "run.h5") as file:
        energy = file["series/kinetic_energy_per_grain"][()]
        assert file["solver/impacts_reduced"][()].sum() == summary(out)["solver"]["impacts_reduced"] > 0
    assert 2.5 < energy.max() <= 2.688 and energy[-1] < 1e-12
    assert 0.0 <= summary(out)["solver"]["restitution_kept"] < 1.0
    # Without friction nothing jams, and no restitution is lost.
    free = lab.run(scene.replace("friction = 0.35", "friction = 0.0"), out="free")
    assert summary(free)["solver"]["impacts_reduced"] == 0 and summary(free)["solver"]["restitution_kept"] == 1.0


# Dropped by one diameter, a disc returns to a quarter of it at e = 0.5; the bound is 2 %.
def test_a_bounce_at_the_automatic_step(tmp_path):
    lab = Laboratory(tmp_path)
    out = lab.run("[method]\nkind = 'contact-dynamics'\n[contact]\nrestitution = 0.5\n[[plane]]\npoint = [0, 0]\n"
                  "normal = [0, 1]\n[[grain]]\nposition = [0.0, 1.5]\n[stop]\ntime = 2.1\n")
    grains = Grains(out / "run.h5")
    with h5py.File(out / "run.h5") as file:
        step = file.attrs["time_step"]
    assert 0.1 < step < 0.3
    speed = grains.velocity[0, 1] - 0.5 * step  # velocities are half a step before the positions
    assert grains.position[0, 1] - 0.5 + 0.5 * speed**2 == pytest.approx(0.25, rel=0.02)
    assert grains.position[0, 1] > 0.55
