# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Fields and grain stresses of beds between walls, from runs of the program, against sums over their contacts."""

import numpy as np
import pytest
from conftest import datasets, repose

# Four soft columns in a bin: planes, or pieces of wall. Hooke's law, so that overlaps are small.
BED = """
[method]
kind = "soft"
[grains]
diameter = 1.0
[contact.normal]
law = "hooke"
stiffness = 20000.0
[stop]
time = 30.0
[analysis]
field_width = 1.0
"""
PLANES = """
[[plane]]
name = "floor"
point = [0.0, 0.0]
normal = [0.0, 1.0]
[[plane]]
name = "left"
point = [-3.0, 0.0]
normal = [1.0, 0.0]
[[plane]]
name = "right"
point = [3.0, 0.0]
normal = [-1.0, 0.0]
"""
PIECES = """
[[wall]]
name = "floor"
from = [-3.0, 0.0]
to = [3.0, 0.0]
[[wall]]
name = "left"
from = [-3.0, 20.0]
to = [-3.0, 0.0]
[[wall]]
name = "right"
from = [3.0, 0.0]
to = [3.0, 20.0]
"""


def bed(walls, rows=12):
    """Rows of six discs, every second one shifted by a tenth, dropped from a hundredth of a diameter."""
    grains = "".join(
        f"[[grain]]\nposition = [{-2.5 + k + (0.0 if row % 2 else 1e-3 * (k - 2.5))}, {0.51 + 1.01 * row}]\n"
        for row in range(rows)
        for k in range(6)
    )
    return BED + walls + grains


@pytest.fixture(scope="module", params=["planes", "pieces"])
def run(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(request.param)
    (folder / "bed.toml").write_text(bed(PLANES if request.param == "planes" else PIECES))
    done = repose("run", "bed.toml", "--out", "run", cwd=folder)
    assert done.returncode == 0, done.stderr
    return datasets(folder / "run/run.h5") | datasets(folder / "run/analysis.h5")


def contact_stress(run):
    """Sum of force times branch: of the first from the centre of the second, or from the wall."""
    place = dict(zip(run["/grains/id"], run["/grains/position"]))
    total = np.zeros((2, 2))
    for (a, b), n, push, shear, lever in zip(
        run["/contacts/grains"], run["/contacts/normal"], run["/contacts/normal_force"],
        run["/contacts/tangential_force"], run["/contacts/lever"],
    ):  # fmt: skip
        branch = n * lever if b < 0 else place[a] - place[b]
        total += np.outer(push * n + shear * np.array([-n[1], n[0]]), branch)
    return total


def integral(run, name):
    x = run["/fields/x"]
    return run[f"/fields/{name}"].sum() * (x[1] - x[0]) ** 2


# Rounding; the pieces hide by whole sixteenths of cells, and the integrals are exact all the same.
def test_integrals_are_those_of_the_grains_and_contacts(run):
    assert integral(run, "density") == pytest.approx(run["/grains/mass"].sum(), rel=1e-12)
    total = contact_stress(run)
    for i, j, name in ((0, 0, "xx"), (0, 1, "xy"), (1, 0, "yx"), (1, 1, "yy")):
        assert integral(run, f"stress_{name}") == pytest.approx(total[i, j], rel=1e-12, abs=1e-12 * total[1, 1])
        each = (run["/grain_stress/area"] * run[f"/grain_stress/stress_{name}"]).sum()
        assert each == pytest.approx(total[i, j], rel=1e-12, abs=1e-12 * total[1, 1])


def test_nothing_lies_behind_walls(run):
    x, y = np.meshgrid(run["/fields/x"], run["/fields/y"])
    half = 0.5 * (run["/fields/x"][1] - run["/fields/x"][0])
    behind = ((np.abs(x) > 3.0 + half) | (y < -half)) & (y < 15.0)
    assert behind.sum() > 500
    for name in ("density", "solid_fraction", "stress_xx", "stress_xy", "stress_yy", "support_x", "support_y", "room"):
        assert (run[f"/fields/{name}"][behind] == 0.0).all(), name
    inside = (np.abs(x) < 3.0 - half) & (y > half) & (y < 10.0)
    assert (run["/fields/room"][inside] == 1.0).all()


# A level cut between walls carries the weight above it: exactly between planes (the free surface is 6 widths above, the
# force residual small), and to a few per cent between pieces, whose shadows the eye of each contact sees differently.
def test_level_cuts_carry_the_weight_above(run):
    cell = run["/fields/x"][1] - run["/fields/x"][0]
    load = run["/fields/stress_yy"].sum(axis=1) * cell
    position, radius = run["/grains/position"], run["/grains/radius"]
    top = (position[:, 1] + radius).max()
    planes = not np.isfinite(run["/walls/half_length"]).any()
    compared = 0
    for row, y in enumerate(run["/fields/y"]):
        if 4.5 < y < top - 4.5:
            compared += 1
            assert load[row] == pytest.approx(6.0 * (top - y), rel=0.01 if planes else 0.05)
    assert compared >= 5


def test_a_bed_at_rest_has_no_velocity_and_no_temperature(run):
    dense = run["/fields/density"] > 0.3
    for name in ("velocity_x", "velocity_y", "temperature"):
        assert np.nanmax(np.abs(run[f"/fields/{name}"][dense])) < 1e-3
    assert run["/fields/coordination"][dense].mean() == pytest.approx(3.0, abs=1.2)
    np.testing.assert_allclose((run["/fields/fabric_xx"] + run["/fields/fabric_yy"])[dense], 1.0, atol=1e-12)
