# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of spheres against closed forms. Units: grain diameter, grain mass, gravity; z points upwards."""

import math

import h5py
import numpy as np
import pytest
from conftest import datasets, summary

# A sphere that slides on a plane ends rolling at 5/7 of its speed. Soft contacts sink by 1/k of a diameter, so the lever
# is that much shorter: 1e-5 for k = 1e5. Rigid ones are exact to the tolerance of the solver and the error of the step in
# which sliding ends.
SLIDING = """dimension = 3
[method]
kind = "{method}"
{more}
[[plane]]
point = [0.0, 0.0, 0.0]
normal = [0.0, 0.0, 1.0]
[[grain]]
position = [0.0, 0.0, {height}]
velocity = [{vx}, {vy}, 0.0]
[contact]
friction = 0.5
[stop]
time = 8
[output]
frames = 0
"""
SOFT = """normal = { law = "hooke", stiffness = 1e5, restitution = 0.5 }
tangential = { law = "linear", stiffness = 5e4, damping = 0.5 }
"""


@pytest.mark.parametrize("method", ["soft", "contact-dynamics"])
@pytest.mark.parametrize("angle", [0.0, 40.0, 217.0])
def test_a_sliding_sphere_ends_rolling(lab, method, angle):
    speed = 2.0
    vx, vy = speed * math.cos(math.radians(angle)), speed * math.sin(math.radians(angle))
    soft = method == "soft"
    scene = SLIDING.format(method=method, more="" if soft else "time_step = 0.002", vx=vx, vy=vy,
                           height=0.5 - (1e-5 if soft else 0.0))
    out = lab.run(scene.replace("friction = 0.5\n", "friction = 0.5\n" + (SOFT if soft else "")))
    with h5py.File(out / "run.h5") as run:
        velocity = run["grains/velocity"][0]
        spin = run["grains/spin"][0]
        assert run.attrs["dimension"] == 3
    tolerance = 1e-4 if soft else 2e-3
    np.testing.assert_allclose(velocity, np.array([vx, vy, 0.0]) * 5 / 7, atol=tolerance * speed)
    # It rolls: omega x (-R z) = -v.
    np.testing.assert_allclose(np.cross(spin, [0.0, 0.0, -0.5]), -velocity, atol=5e-4)


# Three fixed spheres that touch carry a fourth: each contact with W / (3 cos), cos = sqrt(2/3). Soft contacts give way by
# less than 1e-5 of a diameter, which changes the cosine by as much.
FOUR = """dimension = 3
[method]
kind = "{method}"
[[grain]]
position = [0.0, 0.5773502691896258, 0.0]
fixed = true
[[grain]]
position = [0.5, -0.2886751345948129, 0.0]
fixed = true
[[grain]]
position = [-0.5, -0.2886751345948129, 0.0]
fixed = true
[[grain]]
position = [0.0, 0.0, 0.8164965809277260]
[contact]
friction = 0.0
{laws}
[stop]
time = 30
"""


@pytest.mark.parametrize("method, laws", [("soft", SOFT.replace('"linear", stiffness = 5e4, damping = 0.5', '"none"')), ("contact-dynamics", "")])
def test_three_spheres_carry_a_fourth(lab, method, laws):
    out = lab.run(FOUR.format(method=method, laws=laws))
    found = datasets(out / "run.h5")
    carries = found["/contacts/grains"][:, 1] == 3
    np.testing.assert_allclose(found["/contacts/normal_force"][carries], 1.0 / (3.0 * math.sqrt(2.0 / 3.0)), rtol=5e-5)
    assert carries.sum() == 3
    assert abs(summary(out)["weight_error"]) < 1e-4


# The spheres of a bed, of two sizes and at random, in a box with a floor: floor and walls carry the weight, the state is
# that of one thread, and a run that was interrupted ends in the same bits.
BED = """dimension = 3
seed = 5
grains = { polydispersity = 0.2 }
box = { x = "periodic", half_width = 4.0, y = "periodic", half_depth = 5.0 }
base = { kind = "plane" }
source = { kind = "crystal", structure = "sc", columns = 6, rows = 7, layers = 6, gap = 0.2, jitter = 0.9 }
[contact]
friction = 0.4
normal = { law = "hooke", stiffness = 2000, restitution = 0.4 }
tangential = { law = "linear", stiffness = 1000 }
[stop]
at_rest = 1e-6
time = 200
"""


def test_the_floor_carries_a_bed(lab):
    out = lab.run(BED)
    assert abs(summary(out)["weight_error"]) < 1e-6
    assert summary(out)["grains"] == 252
    with h5py.File(out / "run.h5") as run:
        position = run["grains/position"][:]
        assert (np.abs(position[:, 0]) <= 4.0).all() and (np.abs(position[:, 1]) <= 5.0).all()
        assert (position[:, 2] > 0.39).all()


def test_the_fabric_is_that_of_numpy(lab):
    out = lab.run(BED)
    with h5py.File(out / "run.h5") as run:
        counts = (run["contacts/grains"][:, 1] >= 0) & (run["contacts/normal_force"][:] > 0.2)
        normal = run["contacts/normal"][:][counts]
    value, axis = np.linalg.eigh(normal.T @ normal / len(normal))
    fabric = summary(out)["fabric"]
    for k in range(3):
        assert fabric[f"eigenvalue_{k + 1}"] == pytest.approx(value[2 - k], abs=1e-12)
        assert fabric[f"axis_{k + 1}"][2] >= 0.0
        assert abs(np.dot(fabric[f"axis_{k + 1}"], axis[:, 2 - k])) == pytest.approx(1.0, abs=1e-9)


def test_bits_do_not_depend_on_threads(lab):
    one = lab.run(BED, "--threads", "1", out="one")
    two = lab.run(BED, "--threads", "2", out="two")
    assert summary(one)["state_hash"] == summary(two)["state_hash"]


# Energy supplied, stored and dissipated agree at the error of the scheme; a sphere that bounces loses what restitution
# takes.
def test_the_energy_budget_closes(lab):
    out = lab.run(BED.replace("at_rest = 1e-6\n", "") + "[output]\nenergy = true\n")
    with h5py.File(out / "run.h5") as run:
        error = run["energy/error"][:]
        supplied = run["energy/sources"][-1]
    assert supplied > 100.0
    assert np.abs(error[-1]) < 0.03 * supplied


# The vertical is an axis like any other for what moves: gravity along -x on a plane that faces x, instead of -z on one
# that faces z. The same bits, but for the order in which components are summed: 1e-9.
def test_directions_are_equal(lab):
    turned = SLIDING.format(method="soft", more="", vx=0.3, vy=1.1, height=0.5).replace(
        "friction = 0.5\n", "friction = 0.5\n" + SOFT)
    upright = lab.run(turned, out="upright")
    level = turned.replace("normal = [0.0, 0.0, 1.0]", "normal = [1.0, 0.0, 0.0]")
    level = level.replace("position = [0.0, 0.0, 0.5]", "position = [0.5, 0.0, 0.0]")
    level = level.replace("velocity = [0.3, 1.1, 0.0]", "velocity = [0.0, 0.3, 1.1]")
    level = level.replace("dimension = 3\n", "dimension = 3\ngravity_direction = [-1.0, 0.0, 0.0]\n")
    sideways = lab.run(level, out="sideways")
    with h5py.File(upright / "run.h5") as a, h5py.File(sideways / "run.h5") as b:
        for name in ("position", "velocity", "spin"):
            np.testing.assert_allclose(np.roll(a[f"grains/{name}"][:], 1, axis=1), b[f"grains/{name}"][:], atol=1e-9)


@pytest.mark.parametrize("text, message", [
    ("dimension = 4\nstop = { time = 1 }\n", "dimension = 4: must be a whole number from 2 to 3"),
    ("dimension = 3\nstop = { time = 1 }\n[[grain]]\nposition = [0.0, 1.0]\n",
     "grain[0].position = [ 0, 1 ]: must be a list of three numbers, has 2"),
    ("dimension = 3\nstop = { time = 1 }\nmethod = { kind = 'hybrid' }\n[[grain]]\nposition = [0.0, 1.0, 0.0]\n",
     'method.kind = "hybrid": must be one of'),
    ("dimension = 3\nstop = { time = 1 }\nbase = { kind = 'row' }\n[[grain]]\nposition = [0.0, 1.0, 0.0]\n",
     'base.kind = "row": must be one of'),
    ("dimension = 3\nstop = { time = 1 }\n[[wall]]\nfrom = [0.0, 0.0]\nto = [1.0, 0.0]\n"
     "[[grain]]\nposition = [0.0, 1.0, 0.0]\n", "wall[0].shape"),
    ("dimension = 3\ngravity_direction = [0.0, 0.0, 0.0]\nstop = { time = 1 }\n[[grain]]\nposition = [0.0, 1.0, 0.0]\n",
     "gravity_direction = [0, 0, 0]: must have a direction"),
])
def test_bad_input(lab, text, message):
    lab.scene(text)
    lab.refused("check", "scene.toml", parts=[message])


# A pipe filled by rain: floor and side carry the weight, and nobody leaves through the wall.
PIPE = """dimension = 3
seed = 3
grains = { polydispersity = 0.1 }
box = { half_width = 6.0 }
base = { kind = "plane" }
source = { kind = "rain", count = 120, rate = 20.0, height = 12.0, opening = "disc", radius = 2.0 }
[[wall]]
name = "pipe"
%s
[contact]
friction = 0.4
normal = { law = "hooke", stiffness = 2000, restitution = 0.4 }
tangential = { law = "linear", stiffness = 1000, damping = 0.5 }
[stop]
at_rest = 1e-6
time = 300
"""
CYLINDER = 'shape = "cylinder"\nfrom = [0.0, 0.0, -1.0]\nto = [0.0, 0.0, 20.0]\nradius = 2.6\n'


def test_a_pipe_carries_part_of_the_weight(lab):
    out = lab.run(PIPE % CYLINDER)
    found = summary(out)
    assert found["grains"] == 120 and found["grains_lost"] == 0 and found["warnings"] == []
    assert abs(found["weight_error"]) < 1e-6
    floor, pipe = found["walls"]["force_z"]
    assert found["walls"]["name"] == ["base", "pipe"]
    # Both push upwards: the grains press on them downwards.
    assert floor < 0.0 and pipe < -1.0
    with h5py.File(out / "run.h5") as run:
        position, radius = run["grains/position"][:], run["grains/radius"][:]
        shapes = [name.decode() for name in run["walls/shape"][:]]
    assert (np.hypot(position[:, 0], position[:, 1]) + radius < 2.6 + 0.05).all()
    assert shapes == ["plane", "frustum"]
    assert found["angle_of_repose_deg"]["mean"] is None, "a pipe has no free flanks"


def stl_of_pipe(path, radius=2.6, low=-1.0, high=20.0, sides=24):
    """An upright prism of two triangles a side, whose faces lie at the radius, as ASCII STL."""
    corners = [(radius / math.cos(math.pi / sides) * math.cos(2 * math.pi * (k + 0.5) / sides),
                radius / math.cos(math.pi / sides) * math.sin(2 * math.pi * (k + 0.5) / sides)) for k in range(sides)]
    lines = ["solid pipe"]
    for k, (a, b) in enumerate(zip(corners, corners[1:] + corners[:1])):
        for triangle in (((*a, low), (*b, low), (*b, high)), ((*a, low), (*b, high), (*a, high))):
            lines += ["facet normal 0 0 0", "outer loop", *(f"vertex {x:.9g} {y:.9g} {z:.9g}" for x, y, z in triangle),
                      "endloop", "endfacet"]
    path.write_text("\n".join(lines + ["endsolid pipe", ""]))


def test_a_surface_from_a_file(lab):
    stl_of_pipe(lab.path / "pipe.stl")
    out = lab.run(PIPE % 'shape = "surface"\nfile = "pipe.stl"\n')
    found = summary(out)
    assert found["grains_lost"] == 0 and abs(found["weight_error"]) < 1e-6
    assert len(found["walls"]["name"]) == 1 + 48 and found["walls"]["name"][1] == "pipe 0"
    # The run keeps the surface: its scene can be run again from its own folder.
    (lab.path / "pipe.stl").unlink()
    again = lab("run", "out/scene.toml", "--out", "again", "--quiet")
    assert again.returncode == 0, again.stderr
    assert summary(lab.path / "again")["state_hash"] == found["state_hash"]
    lab.scene(PIPE % 'shape = "surface"\nfile = "pipe.stl"\n')
    lab.refused("check", "scene.toml", parts=["wall[0].file", "pipe.stl"])


# Drop and roll: a loose packing in which every sphere has three supports. Published solid fraction 0.582 (Visscher and
# Bolsterli 1972); 0.5808 +- 0.001 was seen in this scene with 8000 spheres. The mean coordination of a packing in which
# each sphere comes with three contacts is 6, but for the spheres near the edges of the slab.
def test_deposited_spheres(lab):
    out = lab.run("""dimension = 3
method = { kind = "deposition", critical_angle = 0 }
box = { x = "periodic", half_width = 7.0 }
source = { count = 3000 }
""")
    packing = summary(out)["packing"]
    assert abs(packing["solid_fraction"]["mean"] - 0.581) < 0.006
    assert summary(out)["angle_of_repose_deg"]["mean"] is None  # a bed is no cone, however rough
    assert abs(packing["coordination"]["mean"] - 6.0) < 0.1
    with h5py.File(out / "run.h5") as run:
        assert (np.bincount(run["contacts/grains"][:].max(axis=1)) <= 3).all()


def test_deposited_spheres_form_a_cone(lab):
    """Two estimators of the angle agree: the line through the surface, and the moments of the positions of the spheres. They
    differed by 0.6 deg, and each by 0.7 from sector to sector (seed 1)."""
    out = lab.run("""dimension = 3
method = { kind = "deposition", critical_angle = 0 }
source = { count = 6000, radius = 1.0 }
analysis = { bin_width = 1.0 }
""")
    angle = summary(out)["angle_of_repose_deg"]
    assert abs(angle["mean"] - angle["sectors"]) < 2.0
    assert abs(angle["mean"] - angle["moments"]) < 2.0
    assert 0.0 < angle["sectors_error"] < 2.0


def test_a_run_resumes_to_the_same_bits(lab):
    whole = lab.run(PIPE % CYLINDER, out="whole")
    lab.scene(PIPE % CYLINDER)
    stopped = lab.shell("timeout --foreground -s INT 1 $REPOSE run scene.toml --out cut --quiet; echo $?")
    if stopped.stdout.strip() != "0":
        resumed = lab("resume", "cut", "--quiet")
        assert resumed.returncode == 0, resumed.stderr
    assert summary(lab.path / "cut")["state_hash"] == summary(whole)["state_hash"]


def test_what_knows_discs_alone_refuses_spheres(lab):
    lab.run(PIPE % CYLINDER, "--set", "stop.time=1")
    for verb in (["view", "out", "--no-browser"], ["export", "out", "--to", "html"],
                 ["export", "out", "--to", "contact-problem"]):
        lab.refused(*verb, parts=["spheres"])
    lab.refused("analyse", "out", "--stability", parts=["two dimensions"])
