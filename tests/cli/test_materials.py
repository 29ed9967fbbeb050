# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Laws and materials from scene files, and the report of `repose check` on them. Units: diameter, mass, gravity."""

import math
import re
from pathlib import Path

import numpy as np
import pytest
from conftest import Grains, assert_same_bits, datasets, summary

HOOKE = "normal = { law = 'hooke', stiffness = 1e4, %s }\n"
TWO = """[[grain]]
position = [0.0, 0.0]
diameter = %g
%s
[[grain]]
position = [1.2, 0.0]
velocity = [-0.5, 0.0]
[stop]
time = 2
"""


def rebound(lab, contact, first=1.0, more="", tail="", out="out"):
    """The relative speed after a head-on impact over that before."""
    text = "gravity = 0\n[method]\ntime_step = 1e-4\n[contact]\n" + contact + TWO % (first, more) + tail
    velocity = Grains(lab.run(text, out=out) / "run.h5").velocity[:, 0]
    return (velocity[1] - velocity[0]) / 0.5


# The dashpot uses the velocities of the half step, which is of first order in w dt = 0.01 to 0.02.
@pytest.mark.parametrize("law", ["law = 'hooke', stiffness = 1e4", "law = 'hertz', stiffness = 1e5"])
@pytest.mark.parametrize("restitution", [0.2, 0.8])
@pytest.mark.parametrize("first, more", [(1.0, ""), (0.4, ""), (1.0, "fixed = true")])
def test_restitution_is_as_requested(lab, law, restitution, first, more):
    contact = f"normal = {{ {law}, restitution = {restitution} }}\n"
    assert rebound(lab, contact, first, more) == pytest.approx(restitution, abs=5e-3)


# C = d m_red gives e = exp(-pi b / w), b = d / 2, w^2 = k / m_red - b^2, if the dashpot may pull.
def test_viscosity(lab):
    rate, reduced = 30.0, 0.5
    contact = HOOKE % f"viscosity = {rate}, attraction = true"
    w = math.sqrt(1e4 / reduced - rate**2 / 4)
    assert rebound(lab, contact) == pytest.approx(math.exp(-math.pi * rate / 2 / w), abs=2e-3)


def test_materials_meet_by_the_law_of_their_pair(lab):
    """Steel on steel has 0.9, steel on rubber 0.2; parameters that the pair does not set are those of [contact]."""
    contact = HOOKE % "restitution = 0.9"
    tail = "[[material]]\nname = 'steel'\n[[material]]\nname = 'rubber'\n[[pair]]\nfirst = 'rubber'\nsecond = 'steel'\n" \
        "friction = 0.1\nnormal = { law = 'hooke', stiffness = 1e4, restitution = 0.2 }\n"
    assert rebound(lab, contact, tail=tail) == pytest.approx(0.9, abs=5e-3)
    assert rebound(lab, contact, more="material = 'rubber'", tail=tail, out="mixed") == pytest.approx(0.2, abs=5e-3)


def test_density_of_a_material(lab):
    text = "[[material]]\nname = 'a'\n[[material]]\nname = 'b'\ndensity = 3\n" + TWO % (0.5, "material = 'b'")
    assert Grains(lab.run(text) / "run.h5").mass.tolist() == [0.75, 1.0]


def test_a_scene_of_materials_repeats_itself(lab):
    text = """[contact]
rolling = { law = "spring", friction = 0.1 }
cohesion = { law = "constant", force = 0.3 }
normal = { law = "hertz", stiffness = 2e4, restitution = 0.5 }
tangential = { law = "mindlin", ratio = 0.7 }
[[material]]
name = "stone"
[[material]]
name = "glass"
density = 1.2
[[pair]]
first = "glass"
second = "stone"
friction = 0.2
[base]
kind = "row"
half_width = 10
material = "glass"
[[plane]]
point = [-9, 0]
normal = [1, 0]
material = "glass"
[source]
kind = "pour"
count = 30
rate = 2
height = 10
[stop]
time = 40
"""
    first = lab.run(text, out="first")
    second = lab.run((first / "scene.toml").read_text(), "--threads", "2", out="second")
    assert (first / "scene.toml").read_text() == (second / "scene.toml").read_text()
    assert_same_bits(first / "run.h5", second / "run.h5")
    materials = datasets(first / "run.h5")["/grains/material"]
    assert (materials[:21] == 1).all() and (materials[21:] == 0).all()
    # A pair that sets only friction has the other parameters of [contact].
    assert (first / "scene.toml").read_text().count("stiffness = 20000.0") == 2


def test_cohesion_holds_up_to_its_force(lab):
    """A disc below a fixed one hangs on an attraction of 1.5 weights, and falls with one of 0.5."""
    for force, hangs in ((1.5, True), (0.5, False)):
        text = f"[contact]\n{HOOKE % 'damping = 0.5'}cohesion = {{ law = 'constant', force = {force} }}\n" + """[[grain]]
position = [0.0, 0.0]
fixed = true
[[grain]]
position = [0.0, -0.9999]
[stop]
time = 10
"""
        y = Grains(lab.run(text, out=f"out{force}") / "run.h5").position[1, 1]
        assert (y == pytest.approx(-1.0 + 0.5e-4, abs=1e-6)) if hangs else y < -10.0


def test_rolling_friction_makes_heaps_steeper(lab):
    """Rolling friction 0.3 against none. Of eight seeds each, heights are 11.0 and 9.9 with standard deviations of 0.5 and 0.3,
    so that the means of five differ by 1.2 within 0.3 (standard error).
    """
    heap = "[contact]\nnormal = { law = 'hooke', stiffness = 5e3 }\n%s[base]\nkind = 'row'\nhalf_width = 15\n" \
        "[source]\nkind = 'pour'\ncount = 120\nrate = 2\nheight = 12\nhalf_width = 1\n[stop]\nat_rest = 1e-5\ntime = 400\n"
    free, rolling = (
        np.mean([summary(lab.run(f"seed = {seed}\n" + heap % more, out=f"{kind}{seed}"))["heap_height"] for seed in range(1, 6)])
        for kind, more in (("free", ""), ("rolling", "rolling = { law = 'spring', friction = 0.3 }\n")))
    assert 0.6 < rolling - free < 1.8


# Constant: 2/3 mu_r g = 0.04, so the disc stops after v^2/(2 a) = 12.5 and then creeps to rest within 3e-3.
# Viscous: v = exp(-2/3 b t). The slip spring leaves an error of some m g / k_t = 2e-4 times the path.
def test_example_of_rolling(lab):
    example = Path(__file__).parents[2] / "examples/rolling.toml"
    assert lab("run", example, "--out", "constant", "--quiet").returncode == 0
    assert Grains(lab.path / "constant/run.h5").position[0, 0] == pytest.approx(12.5, abs=0.01)
    text = example.read_text().replace('law = "constant", friction = 0.06', 'law = "viscous", friction = 10, rate = 0.3')
    out = lab.run(text.replace("time = 40.0", "time = 10.0"), out="viscous")
    assert Grains(out / "run.h5").velocity[0, 0] == pytest.approx(math.exp(-2.0), abs=1e-3)


def test_check_prints_each_pair(lab):
    lab.scene("[contact]\n" + HOOKE % "restitution = 0.7" + """[[material]]
name = "stone"
[[material]]
name = "wood"
[[pair]]
first = "stone"
second = "wood"
normal = { law = "hertz", stiffness = 1e5, restitution = 0.4 }
[source]
kind = "pour"
count = 100
rate = 1
height = 10
[base]
kind = "plane"
[stop]
time = 10
""")
    said = lab("check", "scene.toml").stdout
    rows = {}
    for line in said.splitlines():
        found = re.match(r"  (\S.*\S) +" + r" +".join([r"([-0-9.e]+)"] * 5) + "$", line)
        if found:
            rows[found.group(1).strip()] = [float(x) for x in found.groups()[1:]]
    assert set(rows) == {"stone and stone", "stone and wood", "wood and wood"}
    restitution, duration, one, column, steps = rows["stone and stone"]
    assert restitution == pytest.approx(0.7, abs=1e-4) and one == pytest.approx(1e-4)
    # pi / w of the undamped contact is 0.0222; damping makes the contact a little longer.
    assert 0.0222 < duration < 0.026
    assert column == pytest.approx(7.2e-4, rel=0.02)  # sqrt(100 * 0.9 / sqrt(3)) grains
    step = float(re.search(r"time step +([0-9.e-]+)", said).group(1))
    assert steps == pytest.approx(duration / step, rel=2e-2)
    assert rows["stone and wood"][0] == pytest.approx(0.4, abs=1e-4)
    assert rows["stone and wood"][2] == pytest.approx(1e-5 ** (2 / 3), rel=1e-2)


BODY = "[[grain]]\nposition = [0.0, 1.0]\n[stop]\ntime = 1\n"
WRONG = {
    "damping twice": ("[contact]\nnormal = { law = 'hooke', damping = 0.1, restitution = 0.5 }\n" + BODY,
                      "scene.toml:2: contact.normal.restitution: only one of damping and restitution may be given"),
    "restitution above one": ("[contact]\nnormal = { law = 'hooke', restitution = 1.5 }\n" + BODY,
                              "contact.normal.restitution = 1.5: must be > 0 and <= 1"),
    "restitution too small": ("[contact]\nnormal = { law = 'hooke', restitution = 1e-12 }\n" + BODY,
                              "contact.normal.restitution = 1e-12: is less than any damping"),
    "mindlin with hooke": ("[contact]\nnormal = { law = 'hooke' }\ntangential = { law = 'mindlin' }\n" + BODY,
                           "contact.tangential.law = \"mindlin\": needs contact.normal.law = \"hertz\""),
    "rolling without friction": ("[contact]\nrolling = { law = 'spring' }\n" + BODY, "contact.rolling.friction: missing"),
    "viscous rolling without rate": ("[contact]\nrolling = { law = 'viscous', friction = 0.1 }\n" + BODY,
                                     "contact.rolling.rate: missing"),
    "constant rolling at once": ("[contact]\nrolling = { law = 'constant', friction = 0.1, full_at = 0 }\n" + BODY,
                                 "contact.rolling.full_at = 0: must be > 0"),
    "viscous without rate": ("[contact]\ntangential = { law = 'viscous' }\n" + BODY, "contact.tangential.rate: missing"),
    "unknown material": (BODY + "[[plane]]\npoint = [0, 0]\nnormal = [0, 1]\nmaterial = 'gold'\n",
                         "plane[0].material = \"gold\": must be one of \"grain\""),
    "material twice": (BODY + "[[material]]\nname = 'a'\n[[material]]\nname = 'a'\n", "material[1].name = \"a\": is used twice"),
    "material without a name": (BODY + "[[material]]\ndensity = 2\n", "material[0].name: missing"),
    "pair twice": (BODY + "[[material]]\nname = 'a'\n[[material]]\nname = 'b'\n" + "[[pair]]\nfirst = 'a'\nsecond = 'b'\n"
                   "[[pair]]\nfirst = 'b'\nsecond = 'a'\n", "pair[1].second = \"a\": this pair is given twice"),
    "negative cohesion": ("[contact]\ncohesion = { law = 'constant', force = -1 }\n" + BODY, "contact.cohesion.force = -1: must be >= 0"),
}


@pytest.mark.parametrize("name", WRONG)
def test_wrong_laws_are_refused(lab, name):
    text, part = WRONG[name]
    lab.scene(text)
    said = lab.refused("run", "scene.toml", parts=[part])
    assert len(said.strip().splitlines()) == 1, said


def test_scene_numbers_are_finite(lab):
    out = lab.run("[contact]\n" + HOOKE % "restitution = 0.5" + BODY)
    assert "nan" not in (out / "scene.toml").read_text()
    assert all(np.isfinite(x).all() for name, x in datasets(out / "run.h5").items()
               if x.dtype.kind == "f" and "analysis" not in name and "walls" not in name)
