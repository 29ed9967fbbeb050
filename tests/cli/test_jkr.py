# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Adhesion by Johnson, Kendall and Roberts in scenes: pull-off, runs that continue, messages. Units: d, m, g."""

import math
import re
from pathlib import Path

import pytest
from conftest import LIMIT, Grains, datasets, number_in
from interruption import assert_same_run, resumed, started, wait_until

EXAMPLE = Path(__file__).parents[2] / "examples/adhesion.toml"
WALL = "[[plane]]\npoint = [0, 0]\nnormal = [0, -1]\n"


def laws(energy, normal="law = 'hertz', stiffness = 1e4"):
    return f"[contact]\nnormal = {{ {normal} }}\ncohesion = {{ law = 'jkr', surface_energy = {energy} }}\n"


def hanging(lab, text, out):
    return Grains(lab.run(text, out=out) / "run.h5").position[-1, 1]


# From rest at zero overlap the disc swings, undamped where it is stretched: it falls unless the mean pull from there to
# pull-off, 0.961 of the pull-off force, exceeds its weight. On a wall R* = 1/2.
@pytest.mark.parametrize("wall", [False, True])
@pytest.mark.parametrize("pull, hangs", [(1.1, True), (0.9, False)])
def test_pull_off(lab, wall, pull, hangs):
    energy = pull / (1.5 * math.pi * (0.5 if wall else 0.25))
    support = WALL if wall else "[[grain]]\nposition = [0.0, 0.5]\nfixed = true\n"
    y = hanging(lab, laws(energy) + support + "[[grain]]\nposition = [0.0, -0.4999]\n[stop]\ntime = 10\n", "out")
    assert (-0.502 < y < -0.5) if hangs else y < -10.0


def test_example(lab):
    said = lab("check", EXAMPLE).stdout
    assert re.search(r"adhesion +any two: pull-off force 1.1", said), said
    for number, options in enumerate(([], ["--set", "contact.cohesion.surface_energy=0.764"])):
        assert lab("run", EXAMPLE, "--out", f"o{number}", "--quiet", *options).returncode == 0
    assert Grains(lab.path / "o0/run.h5").position[1, 1] > -1.01
    assert Grains(lab.path / "o1/run.h5").position[1, 1] < -10.0


# A disc on a ceiling, whose weight is 0.91 of the pull-off force, so that the contact is stretched; and one below a disc.
CEILING = 1.1 / (1.5 * math.pi * 0.5)
HANGING = laws(CEILING) + WALL + "[[grain]]\nposition = [0.0, -0.49999]\n"
BELOW = "[[grain]]\nposition = [3.0, -3.0]\nfixed = true\n[[grain]]\nposition = [3.0, -3.99499]\ndiameter = 0.99\n"


def overlaps(out):
    return datasets(out / "run.h5")["/contacts/relative_overlap"]


def test_bonds_continue_in_another_run(lab):
    """A contact that does not overlap holds in a run that starts from this one. The disc swings: the run ends at the
    first of some times when the contact is stretched."""
    for k in range(20):
        out = lab.run(HANGING + f"[stop]\ntime = {1 + 0.01 * k}\n", out=f"out{k}")
        if overlaps(out)[0] < 0:
            break
    assert overlaps(out)[0] < 0
    more = lab.run(f"{laws(CEILING)}{WALL}[start]\nfrom = '{out.name}'\n[stop]\ntime = 5\n", out="more")
    assert len(overlaps(more)) == 1 and Grains(more / "run.h5").position[0, 1] > -0.51


def test_a_resumed_run_has_the_same_bits(lab):
    """Two threads, the account of energy, bonds to a wall and to a disc that is stretched and swings for ever."""
    lab.text = HANGING.replace(f"{CEILING}", "0.96") + BELOW + \
        "[method]\ntime_step = 2e-5\n[output]\ncheckpoint = 1e-3\nenergy = true\n[stop]\ntime = 60\n"
    whole = lab.run(lab.text, out="whole")
    assert len(overlaps(whole)) == 2
    out = lab.path / "cut"
    process = started(lab, out)
    wait_until(out, 20.0)
    process.kill()
    process.communicate(timeout=LIMIT)
    resumed(lab, out, "--threads", "2")
    assert_same_run(whole, out)


def test_check_with_moduli(lab):
    """The modulus of the materials: overlap without load is a^2/(3 R), a^3 = 9 pi w R^2/(2 E); here under a tiny weight."""
    lab.scene("[[material]]\nname = 'a'\nyoung_modulus = 1e5\npoisson_ratio = 0.25\n"
              + laws(200.0, "law = 'hertz', restitution = 0.5") + "[[grain]]\nposition = [0, 0]\n[stop]\ntime = 1\n")
    said = lab("check", "scene.toml").stdout
    row = re.search(r"any two +" + r" +".join([r"([-0-9.e]+)"] * 5), said)
    modulus, radius = 1e5 / (2 * (1 - 0.25**2)), 0.25
    a = (9 * math.pi * 200.0 * radius**2 / (2 * modulus)) ** (1 / 3)
    assert float(row[3]) == pytest.approx(a**2 / (3 * radius), rel=2e-2)
    assert number_in(said, "pull-off force") == pytest.approx(1.5 * math.pi * 200.0 * radius, rel=1e-3)


def test_jkr_needs_hertz_and_an_energy(lab):
    tail = "[[grain]]\nposition = [0, 0]\n[stop]\ntime = 1\n"
    lab.scene(laws(1.0, "law = 'hooke'") + tail)
    said = lab.refused("run", "scene.toml", parts=["scene.toml:3: contact.cohesion.law = \"jkr\": needs contact.normal.law = \"hertz\""])
    assert len(said.strip().splitlines()) == 1
    lab.scene(laws(1e5) + tail)
    lab.refused("run", "scene.toml", parts=["contact.cohesion.surface_energy = 100000: a bond to a wall would bridge a gap"])
    lab.scene(laws(0.0) + tail)
    lab.refused("run", "scene.toml", parts=["contact.cohesion.surface_energy = 0: must be > 0 [M/T^2]"])
