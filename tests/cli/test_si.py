# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes in SI units, with materials by density, Young's modulus and Poisson's ratio."""

import math
import re
from pathlib import Path

import h5py
import pytest
from conftest import Grains, datasets, number_in, summary

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


REDUCED = {"d": 1.0, "m": 1.0, "t": 1.0, "g": 1.0}
POWERS = {"d": 2.0**-8, "m": 2.0**-10, "t": 2.0**-4, "g": 1.0}  # t^2 = d/g: scaling by powers of two rounds nothing
BEADS = {"d": 5e-3, "m": 5.1e-4, "t": math.sqrt(5e-3 / 9.81), "g": 9.81}


def twin(units, law):
    """Thirty grains poured between two walls, with every length, mass and time in `units`."""
    d, m, t, g = (units[name] for name in "dmtg")
    system = "reduced" if units is REDUCED else "SI"
    stiffness = {"hooke": 1e4 * m / t**2, "hertz": 1e5 * m / (math.sqrt(d) * t**2)}[law]
    tangential = "{ law = 'mindlin', damping = 0.2 }" if law == "hertz" else f"{{ law = 'linear', stiffness = {5e3 * m / t**2!r}, damping = 0.2 }}"
    return f"""units = '{system}'
gravity = {g!r}
[grains]
diameter = {d!r}
mass = {m!r}
polydispersity = 0.2
[contact]
normal = {{ law = '{law}', stiffness = {stiffness!r}, damping = 0.3 }}
tangential = {tangential}
[base]
kind = "row"
half_width = {4 * d!r}
spacing = {d!r}
[source]
kind = "pour"
count = 30
rate = {7.7 / t!r}
height = {2.5 * d!r}
half_width = {2 * d!r}
[stop]
time = {3.001 * t!r}
[output]
series = {t!r}
frames = {t!r}
window = {t!r}
[method]
time_step = {0.002 * t!r}
"""


def scaled(lab, units, law, out):
    """Grains, contact forces and numbers of a run, over its units."""
    found = datasets(lab.run(twin(units, law), out=out) / "run.h5")
    d, m, t = units["d"], units["m"], units["t"]
    return (found["/grains/position"] / d, found["/grains/velocity"] * (t / d), found["/grains/mass"] / m,
            found["/contacts/normal_force"] * (t**2 / (m * d)))


@pytest.mark.parametrize("law", ["hooke", "hertz"])
def test_a_scene_in_si_is_its_reduced_twin(lab, law):
    """By powers of two to the last bit. In units of beads to rounding, which collisions multiply by ten in 0.3 units of time:
    3e-11 in velocities and 3e-9 in forces, whose stiffness is 1e4 and more, at time 3, but 0.4 at time 8."""
    reduced = scaled(lab, REDUCED, law, "reduced")
    for name, first, second in zip(("position", "velocity", "mass", "force"), reduced, scaled(lab, POWERS, law, "powers"), strict=True):
        assert (first == second).all(), name
    for name, first, second in zip(("position", "velocity", "mass", "force"), reduced, scaled(lab, BEADS, law, "beads"), strict=True):
        assert first.shape == second.shape and abs(first - second).max() < 1e-7, name


def test_measures_of_si_are_those_of_the_twin(lab):
    """Lengths, times and masses of summary.json scale with the units, ratios and angles do not."""
    lab.run(twin(REDUCED, "hooke"), out="reduced")
    lab.run(twin(POWERS, "hooke"), out="powers")
    first, second = summary(lab.path / "reduced"), summary(lab.path / "powers")
    assert first["coordination"] == second["coordination"] and first["angle_of_repose_deg"] == second["angle_of_repose_deg"]
    assert second["heap_height"] == first["heap_height"] * POWERS["d"]
    assert second["time"] == first["time"] * POWERS["t"]


def test_units_stand_in_files_and_tables(lab):
    folder = lab.run(twin(POWERS, "hooke"), out="powers")
    with h5py.File(folder / "run.h5") as file:
        units = {name: file[name].attrs["unit"] for name in ("grains/position", "grains/velocity", "grains/mass", "contacts/normal_force", "series/wall_pressure") if name in file}
    assert {name: unit.decode() if isinstance(unit, bytes) else unit for name, unit in units.items()} == {
        "grains/position": "m", "grains/velocity": "m/s", "grains/mass": "kg", "contacts/normal_force": "kg m/s^2"}
    assert lab("export", folder, "--to", "csv", "--out", "tables").returncode == 0
    text = (lab.path / "tables/grains.csv").read_text()
    assert "# position: [m] centre\n" in text and "# velocity: [m/s]" in text


def test_library_materials_fill_in_what_is_left_out(lab):
    """What the scene gives stands; the rest is that of the table, in which each number has an error and a source."""
    text = "units = 'SI'\n[[material]]\nlibrary = 'steel'\nyoung_modulus = '100 MPa'\n" + HERTZ + "[grains]\ndiameter = 5e-3\n" + FLOOR + bead() + "[stop]\ntime = 0.05\n"
    folder = lab.run(text)
    written = (folder / "scene.toml").read_text()
    for line in ('library = "steel"', 'name = "steel"', "density = 7850.0", "young_modulus = 100000000.0", "poisson_ratio = 0.3 "):
        assert line in written, line
    assert Grains(folder / "run.h5").mass[0] == pytest.approx(7850 * math.pi / 6 * D**3, rel=1e-12)
    table = lab("reference", "materials").stdout
    for name in ("steel", "glass", "acrylic", "sand", "sugar"):
        rows = [line.split(" | ") for line in table.splitlines() if line.startswith(f"| `{name}`")]
        assert [row[1] for row in rows] == ["`density`", "`young_modulus`", "`poisson_ratio`"]
        assert all(float(row[2]) > float(row[3]) > 0 and len(row[-1]) > 10 for row in rows)


def test_the_modulus_of_quartz_follows_from_its_sources(lab):
    """E = 9 K G/(3 K + G), nu = (3 K - 2 G)/(2 (3 K + G)) with K = 37 GPa, G = 44 GPa."""
    rows = {line.split(" | ")[1]: float(line.split(" | ")[2]) for line in lab("reference", "materials").stdout.splitlines() if "`sand`" in line}
    bulk, shear = 37.0, 44.0
    assert rows["`young_modulus`"] / 1e9 == pytest.approx(9 * bulk * shear / (3 * bulk + shear), abs=0.1)
    assert rows["`poisson_ratio`"] == pytest.approx((3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)), abs=5e-4)


LIBRARY_WRONG = {
    "unknown": ("units = 'SI'\n[[material]]\nlibrary = 'cheese'\n" + HERTZ + "[grains]\ndiameter = 5e-3\n" + bead() + END,
                "material[0].library = \"cheese\": must be one of \"none\", \"steel\", \"glass\", \"acrylic\", \"sand\", \"sugar\""),
    "not SI": ("[[material]]\nname = 'a'\nlibrary = 'steel'\n" + bead() + END, "material[0].library"),
    "hooke": ("units = 'SI'\n[[material]]\nlibrary = 'steel'\n" + HERTZ.replace("hertz", "hooke") + "[grains]\ndiameter = 5e-3\n" + bead() + END,
              "contact.normal.law = \"hooke\": must be \"hertz\""),
}


@pytest.mark.parametrize("name", LIBRARY_WRONG)
def test_wrong_library_materials_are_refused(lab, name):
    text, part = LIBRARY_WRONG[name]
    lab.scene(text)
    assert len(lab.refused("run", "scene.toml", parts=[part]).strip().splitlines()) == 1


def test_the_silo_of_the_page_follows_janssens_law(lab):
    """The sinking floor mobilises friction at the walls, so that it carries about a third of the weight. One filling differs
    from the law with the measured stress ratio and friction by less than three of the errors that the summary states."""
    assert lab("run", SILO.with_name("si-janssen.toml"), "--out", "out", "--quiet").returncode == 0
    column = summary(lab.path / "out")["column"]
    assert 0.15 < column["load_ratio"] < 0.5 and column["friction"] > 0.1 and column["janssen_error"] < 0.1
    assert abs(column["janssen_ratio"] - column["load_ratio"]) < 3 * column["janssen_error"]
