# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes in SI units, with materials by density, Young's modulus and Poisson's ratio."""

import math
import re
from pathlib import Path

import pytest
from conftest import Grains, number_in

SILO = Path(__file__).parents[2] / "examples/si-silo.toml"
D, DENSITY, YOUNG, POISSON = 5e-3, 7800.0, 1e8, 0.3
MASS = DENSITY * math.pi / 6 * D**3
MODULUS = YOUNG / (2 * (1 - POISSON**2))
STEEL = f"[[material]]\nname = 'steel'\ndensity = {DENSITY}\nyoung_modulus = {YOUNG}\npoisson_ratio = {POISSON}\n"
HERTZ = "[contact]\nnormal = { law = 'hertz', restitution = 0.6 }\n"
SIZE = f"units = 'SI'\n[grains]\ndiameter = {D}\n"
FLOOR = "[[plane]]\npoint = [0, 0]\nnormal = [0, 1]\n"


def bead(diameter=D, height=None, more=""):
    return f"[[grain]]\nposition = [0.0, {height or 0.5 * diameter}]\ndiameter = {diameter}\n{more}\n"


def test_a_bead_has_the_mass_of_a_sphere_and_rests_by_its_modulus(lab):
    """k = 4/3 E* sqrt(R) on a wall; the bead of half the diameter has a quarter of the mass: discs of one thickness."""
    text = SIZE + STEEL + HERTZ + FLOOR + bead() + bead(D / 2).replace("[0.0,", "[0.02,") + "[stop]\ntime = 0.2\n"
    grains = Grains(lab.run(text) / "run.h5")
    assert grains.mass == pytest.approx([MASS, MASS / 4], rel=1e-12)
    for k, diameter in enumerate((D, D / 2)):
        stiffness = 4 / 3 * MODULUS * math.sqrt(diameter / 2)
        overlap = (grains.mass[k] * 9.81 / stiffness) ** (2 / 3)
        assert diameter / 2 - grains.position[k, 1] == pytest.approx(overlap, rel=1e-3)


def test_two_materials_meet_by_their_moduli(lab):
    """A steel bead on a floor of rubber: 1/E* is the sum of both compliances; rubber has its own density."""
    rubber = "[[material]]\nname = 'rubber'\ndensity = 1100\nyoung_modulus = 1e6\npoisson_ratio = 0.5\n"
    text = SIZE + STEEL + rubber + HERTZ + FLOOR + "material = 'rubber'\n" + bead() + \
        bead().replace("[0.0,", "[0.02,").replace("\n\n", "\nmaterial = 'rubber'\n") + "[stop]\ntime = 0.4\n"
    grains = Grains(lab.run(text) / "run.h5")
    assert grains.mass == pytest.approx([MASS, MASS * 1100 / DENSITY], rel=1e-12)
    modulus = 1 / ((1 - POISSON**2) / YOUNG + 0.75 / 1e6)
    overlap = (MASS * 9.81 / (4 / 3 * modulus * math.sqrt(D / 2))) ** (2 / 3)
    assert D / 2 - grains.position[0, 1] == pytest.approx(overlap, rel=1e-3)


def test_a_scene_with_moduli_repeats_itself(lab):
    text = SIZE + STEEL + HERTZ + "tangential = { law = 'mindlin' }\n" + FLOOR + bead(height=0.01) + "[stop]\ntime = 0.05\n"
    first = lab.run(text, out="first")
    second = lab.run((first / "scene.toml").read_text(), out="second")
    assert (first / "scene.toml").read_text() == (second / "scene.toml").read_text()
    assert (Grains(first / "run.h5").position == Grains(second / "run.h5").position).all()
    assert float(re.search(r"\nratio = ([0-9.]+)", (first / "scene.toml").read_text())[1]) == pytest.approx(1.4 / 1.7)


def test_check_prints_masses_overlaps_and_sound(lab):
    said = lab("check", SILO).stdout
    assert "units            SI: m, kg, s, N, Pa\n" in said
    assert number_in(said, "mass") == pytest.approx(MASS, rel=1e-3)
    assert number_in(said, "weight") == pytest.approx(MASS * 9.81, rel=1e-3)
    stiffness = 4 / 3 * MODULUS * math.sqrt(D / 4)
    overlap = (MASS * 9.81 / stiffness) ** (2 / 3)
    row = re.search(r"any two +" + r" +".join([r"([-0-9.e]+)"] * 5), said)
    assert float(row[3]) == pytest.approx(overlap / D, rel=1e-2)
    assert float(row[4]) < 5e-3
    assert number_in(said, "sound") == pytest.approx(math.sqrt(1.5 * stiffness * math.sqrt(overlap) / MASS) * D, rel=1e-2)
    assert "warning" not in said


def test_the_silo_carries_its_weight(lab):
    """Floor and walls carry the weight of 100 beads at rest, and the walls some of it."""
    result = lab("run", SILO, "--out", "out", "--quiet", "--set", "source.count=100", "--set", "stop.time=0.9")
    assert result.returncode == 0, result.stderr
    grains = Grains(lab.path / "out/run.h5")
    assert len(grains.mass) == 100 and abs(grains.position[:, 0]).max() < 0.05
    assert abs(grains.velocity).max() < 0.02


END = "[stop]\ntime = 1\n"
WRONG = {
    "mass and density": (SIZE + "mass = 1e-3\n" + STEEL + HERTZ + bead() + END,
                         "scene.toml:4: grains.mass = 0.001: follows from the density of the materials"),
    "neither": (SIZE + HERTZ.replace("restitution = 0.6", "stiffness = 1e6") + bead() + END, "grains.mass: missing"),
    "density of one": (SIZE + STEEL + "[[material]]\nname = 'b'\nyoung_modulus = 1\npoisson_ratio = 0\n" + HERTZ + bead() + END,
                       "material[1].density: missing"),
    "stiffness and moduli": (SIZE + STEEL + HERTZ.replace("law = 'hertz'", "law = 'hertz', stiffness = 1e6") + bead() + END,
                             "contact.normal.stiffness = 1000000: the stiffness follows from the young_modulus"),
    "hooke with moduli": (SIZE + STEEL + HERTZ.replace("hertz", "hooke") + bead() + END,
                          "contact.normal.law = \"hooke\": must be \"hertz\""),
    "ratio against moduli": (SIZE + STEEL + HERTZ + "tangential = { law = 'mindlin', ratio = 0.5 }\n" + bead() + END,
                             "contact.tangential.ratio = 0.5: the poisson_ratio of the materials gives 0.823529"),
    "no ratio": (SIZE + STEEL.replace(f"poisson_ratio = {POISSON}\n", "") + HERTZ + bead() + END,
                 "material[0].poisson_ratio: missing: every material has young_modulus and poisson_ratio, or none has"),
    "ratio too large": (SIZE + STEEL.replace("0.3", "0.6") + HERTZ + bead() + END,
                        "material[0].poisson_ratio = 0.6: must be > -1 and <= 0.5"),
    "negative modulus": (SIZE + STEEL.replace(f"{YOUNG}", "-1") + HERTZ + bead() + END, "material[0].young_modulus = -1: must be > 0"),
    "zero density": (SIZE + STEEL.replace(f"{DENSITY}", "0") + HERTZ + bead() + END, "material[0].density = 0: must be > 0"),
}


@pytest.mark.parametrize("name", WRONG)
def test_contradictions_are_refused(lab, name):
    text, part = WRONG[name]
    lab.scene(text)
    said = lab.refused("run", "scene.toml", parts=[part])
    assert len(said.strip().splitlines()) == 1, said
