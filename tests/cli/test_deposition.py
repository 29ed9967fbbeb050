# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Critical-angle deposition through the program: packings, resuming, refused scenes."""

import csv
import json
import math
import signal
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest

from conftest import LIMIT, PROGRAM, Grains, datasets, summary

SCENE = """
[method]
kind = "deposition"
critical_angle = %s
[base]
kind = "%s"
count = %d
[box]
x = "%s"
[source]
count = %d
"""


def scene(angle=50, base="contiguous", width=32, x="periodic", count=1000, more=""):
    return SCENE % (angle, base, width, x, count) + more


# The triangular packing has pi / (2 sqrt 3) = 0.9069 and exactly six neighbours. The slab cuts its layers, hence 5e-4.
def test_steepest_descent_is_triangular(lab):
    found = summary(lab.run(scene(0)))
    assert abs(found["solid_fraction"] - math.pi / (2 * math.sqrt(3))) < 5e-4
    assert found["coordination"] == 6 and found["connectivity"] == [0, 0, 0, 0, 0, 0, 1]
    assert found["packing"]["regime"] == "dense ordered"


# A diameter of 0.1 is not a short sum of powers of two. Rounding grows about threefold per layer, from 1e-16 to the size
# of a disc at layer 33. Above it the packing is disordered, near the 0.82 of steepest descent on a disordered base. With
# snapped positions rounding does not grow. 94 layers; the bounds are far from both values.
@pytest.mark.parametrize("arithmetic, least, most", [("double", 0.78, 0.86), ("snapped", 0.905, 0.909)])
def test_rounding_disorders_steepest_descent(lab, arithmetic, least, most):
    found = summary(lab.run(scene(0, count=3000, more="[grains]\ndiameter = 0.1\n"), "--set",
                            f"method.arithmetic={arithmetic}"))
    assert least < found["solid_fraction"] < most


# A forest, in which each disc touches one earlier disc: z = 2. The bulk values of an independent code are 0.742 for the
# anisotropy and 30.3 deg for the direction. One packing of 50 000 discs has errors of 0.002 and 0.1 deg; the bounds are
# about four of them.
def test_sticking_at_first_touch(lab):
    found = summary(lab.run(scene(90, width=200, count=50000)))
    assert abs(found["coordination"] - 2) < 2e-3
    assert abs(found["anisotropy"] - 0.742) < 0.01
    assert abs(found["fabric_direction_deg"] - 30.3) < 0.4
    assert abs(found["solid_fraction"] - 0.357) < 0.006
    assert found["packing"]["discs_breaking_rule"] == 0 and found["max_overlap"] < 1e-12


@pytest.mark.parametrize("base", ["contiguous", "flat", "disordered"])
@pytest.mark.parametrize("x", ["periodic", "walls"])
def test_bases_and_sides(lab, base, x):
    more = "[grains]\npolydispersity = 0.3\n"
    out = lab.run(scene(20, base, 20, x, 500, more))
    found = summary(out)
    grains = Grains(out / "run.h5")
    fixed = grains.base == 1
    assert fixed.sum() == {"contiguous": 20, "flat": 0}.get(base, fixed.sum())
    if base == "disordered":  # filled until no disc fits: no two closer than a diameter, no gap of two
        gaps = np.diff(np.sort(grains.position[fixed, 0]))
        assert 10 < fixed.sum() < 20 and gaps.min() >= 1 and gaps.max() < 2
    assert (grains.position[:, 1] >= grains.radius - 0.5 - 1e-9).all()
    if x == "walls":
        assert (abs(grains.position[:, 0]) <= 10 - grains.radius + 1e-9).all()
    assert found["grains"] == 500 and found["max_overlap"] < 1e-12
    assert found["packing"]["discs_breaking_rule"] == 0
    lab.run(scene(20, base, 20, x, 500, more), out="again", expect=0)
    assert summary(lab.path / "again")["state_hash"] == found["state_hash"]


# Independent pair counting from the written positions.
def test_measures_agree_with_the_positions(lab):
    out = lab.run(scene(40, width=16, count=300))
    grains = Grains(out / "run.h5")
    x, y = grains.position.T
    dx = x[:, None] - x[None, :]
    dx -= 16 * np.round(dx / 16)
    distance = np.hypot(dx, y[:, None] - y[None, :])
    touching = (distance < 1 + 1e-9) & ~np.eye(len(x), dtype=bool)
    found = summary(out)
    mean = y[grains.base == 0].mean()
    inside = (grains.base == 0) & (y >= 0.4 * mean) & (y < 1.4 * mean)
    assert found["packing"]["discs_in_slab"] == inside.sum()
    assert abs(touching[inside].sum(axis=1).mean() - found["coordination"]) < 1e-12
    assert touching.sum() == 2 * found["contacts"]
    analysis = datasets(out / "analysis.h5")
    assert (analysis["/packing/neighbours"] == touching.sum(axis=1)).all()
    # The chords of all discs in strips of a thousandth of a diameter, over the width.
    edges = np.linspace(0.4 * mean, 1.4 * mean, 20001)
    middles = 0.5 * (edges[1:] + edges[:-1])
    half = np.sqrt(np.maximum(0, 0.25 - (y[:, None] - middles[None, :]) ** 2))
    assert abs(2 * half.sum() / (16 * len(middles)) - found["solid_fraction"]) < 1e-5


def test_discs_in_contact_are_in_one_bin_of_the_pair_correlation(lab):
    """The pairs of the example that lie from 1 to 1.1 diameters apart; rounding puts 254 of them just below 1."""
    example = Path(__file__).parents[2] / "examples/deposition.toml"
    result = lab("run", example, "--out", "out", "--quiet", "--seed", "3")
    assert result.returncode == 0, result.stderr
    pairs = datasets(lab.path / "out/analysis.h5")["/packing/radial/pairs"]
    assert pairs[:10].sum() == 0 and pairs[10] == 621


def test_the_optional_measures_are_written(lab):
    more = "[analysis]\ncorrelations = true\nstructure_factor = true\nlocal_density = true\n"
    found = datasets(lab.run(scene(60, more=more)) / "analysis.h5")
    radial = found["/packing/radial/value"]
    assert radial[:10].max() == 0 and radial[10] > 3  # none nearer than a diameter, many at a diameter
    assert (found["/packing/structure_factor/value"] > 0).all()
    bins = found["/packing/local_density/centre"]
    assert abs(found["/packing/local_density/probability"].sum() * (bins[1] - bins[0]) - 1) < 1e-9
    directions = found["/packing/directions/density"]
    assert abs(directions.sum() * 180 / len(directions) - 1) < 1e-9


def test_analyse_gives_the_same_again(lab):
    out = lab.run(scene(30))
    before = (out / "summary.json").read_bytes()
    assert lab("analyse", "out", "--quiet").returncode == 0
    assert (out / "summary.json").read_bytes() == before


def finished_bits(out):
    found = datasets(out / "run.h5")
    return {name: value.tobytes() for name, value in found.items() if not name.startswith("/series/wall")}


# An interrupted deposition resumes and ends with the same bits; so does a killed one, from its last checkpoint.
@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_resuming_gives_the_same_bits(lab, how):
    text = scene(0, width=500, count=3_000_000, more="[output]\ncheckpoint = 0.2\n")
    lab.scene(text)
    run = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", "cut", "--quiet"], cwd=lab.path)
    deadline = time.monotonic() + LIMIT
    while not list((lab.path / "cut").glob("checkpoint*")) and time.monotonic() < deadline and run.poll() is None:
        time.sleep(0.02)
    run.send_signal(how)
    run.wait()
    assert run.returncode != 0, "it had ended before it could be cut off"
    # The discs of the interrupted state are the first discs of the final state: deposited discs do not move.
    smaller = lab.run(scene(0, width=500, count=200_000), out="smaller")
    assert lab("resume", "cut", "--quiet").returncode == 0
    cut, whole = Grains(lab.path / "cut/run.h5"), Grains(smaller / "run.h5")
    assert summary(lab.path / "cut")["grains"] == 3_000_000
    assert (cut.position[: len(whole.position)] == whole.position).all()


@pytest.mark.parametrize("text, said", [
    (scene(91), "scene.toml:4: method.critical_angle = 91: must be"),
    (scene(-1), "method.critical_angle = -1: must be"),
    (scene(width=1), "scene.toml:7: base.count = 1: must be a whole number from 2"),
    (scene(more="[grains]\npolydispersity = 0.5\n[[species]]\nsizes = { kind = 'fixed', diameter = 2 }\n"),
     "grains.polydispersity = 0.5"),
    (scene(width=3, more="[[species]]\nsizes = { kind = 'fixed', diameter = 2 }\n"), "base.count = 3: the width"),
    (scene(more="[analysis]\ncontact_gap = -1e-3\n"), "analysis.contact_gap = -0.001: must be >= 0"),
    (scene(more="[analysis]\nslab = [0.5, 0.5]\n"), "analysis.slab = [0.5, 0.5]: an empty slab"),
    (scene(more="[analysis]\nslab = [3, 4]\n"), "analysis.slab = [3, 4]: an empty slab"),
    (scene(more="[contact]\nfriction = 0.5\n"), "scene.toml:12: contact: unknown key"),
    (scene(count=0), "source.count = 0: must be a whole number from 1"),
    (scene(base="sand"), 'base.kind = "sand": must be one of "contiguous", "flat", "disordered"'),
])
def test_refused(lab, text, said):
    lab.scene(text)
    message = lab.refused("run", "scene.toml", "--out", "out", parts=[said])
    assert len(message.strip().splitlines()) == 1


def test_check_and_scene_round_trip(lab):
    lab.scene(scene(35))
    said = lab("check", "scene.toml").stdout
    assert "1000 deposited on 32 fixed" in said and "critical angle   35 deg" in said
    out = lab.run(scene(35))
    again = lab("run", "out/scene.toml", "--out", "again", "--quiet")
    assert again.returncode == 0, again.stderr
    first, second = (json.loads((lab.path / name / "summary.json").read_text()) for name in (out, "again"))
    assert first["state_hash"] == second["state_hash"]


PICTURES = ("packing", "directions", "correlations", "surface")


def test_pictures(lab):
    more = "[analysis]\ncorrelations = true\nstructure_factor = true\n"
    lab.run(scene(0, width=16, count=300, more=more))
    drawn = lab("plot", "out", "--format", "svg", "--only", ",".join(PICTURES))
    assert drawn.returncode == 0 and "not drawn" not in drawn.stdout, drawn.stdout + drawn.stderr
    svg = (lab.path / "out/pictures/packing.svg").read_text()
    assert "#2d3f8c" in svg and "#4d4d4d" in svg  # six neighbours, and the base
    plain = lab.run(scene(0, width=16, count=300), out="plain")
    said = lab("plot", "plain", "--format", "svg", "--only", "correlations").stdout
    assert "correlations: not drawn: the packing has no radial or structure_factor" in said
    assert not (plain / "pictures/correlations.svg").exists()


# The table of a sweep against the numbers of its members, and the picture of a sweep over a number.
def test_sweep_over_the_angle(lab):
    (lab.path / "scene.toml").write_text(scene(width=10, count=200))
    (lab.path / "sweep.toml").write_text(
        'scene = "scene.toml"\nseeds = 3\n[vary]\nmethod.critical_angle = [0, 30, 60, 90]\n')
    assert lab("sweep", "sweep.toml", "--out", "out", "--quiet").returncode == 0
    with open(lab.path / "out/table.csv") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        members = [summary(path) for path in (lab.path / "out/members" / row["point"]).iterdir()]
        for key in ("solid_fraction", "coordination", "anisotropy", "fabric_direction_deg"):
            values = [member[key] for member in members]
            assert abs(float(row[key]) - np.mean(values)) < 1e-12
            assert abs(float(row[key + ":error"]) - np.std(values, ddof=1) / math.sqrt(3)) < 1e-12
        fractions = [float(row[f"packing.P_{q}"]) for q in range(7)]
        assert abs(sum(fractions) - 1) < 1e-12
    fractions = [float(row["solid_fraction"]) for row in rows]
    assert fractions == sorted(fractions, reverse=True)
    drawn = lab("plot", "out", "--format", "svg", "--only", "packing")
    assert drawn.returncode == 0 and (lab.path / "out/pictures/packing-2.svg").exists(), drawn.stdout + drawn.stderr


# A settled bed of soft grains, measured in the same way. Overlapping grains touch, and a random close packing of discs has
# a solid fraction of 0.82 to 0.85 (Bratberg 2003, section 2.3).
def test_a_bed_of_the_soft_method_is_measured(lab):
    out = lab.run("""
grains = { polydispersity = 0.2 }
box = { x = "periodic", half_width = 8.0 }
base = { kind = "row", half_width = 8.0 }
source = { kind = "lattice", rows = 16, columns = 15, jitter = 1.0, gap = 0.05 }
stop = { at_rest = 1e-5, time = 200 }
[contact]
normal = { law = "hooke", stiffness = 1e4 }
tangential = { law = "linear", stiffness = 5e3, damping = 0.2 }
""")
    found = summary(out)
    assert 0.80 < found["solid_fraction"] < 0.86
    assert abs(found["packing"]["coordination"]["mean"] - found["coordination"]) < 0.5  # one counts forces, inside and out
