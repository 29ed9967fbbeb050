# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Lattice piles: their scenes, base forces, lines of force and stability, against closed forms and numpy."""

from pathlib import Path

import h5py
import numpy as np
import pytest
from conftest import Laboratory, summary

EXAMPLES = Path(__file__).parents[2] / "examples"
ROWS = 9


def small_pile(tmp_path_factory, name, scene, *settings):
    """A small pile of an example, at rest and analysed with its stability."""
    lab = Laboratory(tmp_path_factory.mktemp(name))
    options = [word for setting in settings for word in ("--set", setting)]
    result = lab("run", EXAMPLES / scene, "--out", "out", "--quiet", *options)
    assert result.returncode == 0, result.stderr
    result = lab("analyse", "out", "--stability")
    assert result.returncode == 0, result.stderr
    return lab.path / "out", result.stdout


@pytest.fixture(scope="module")
def equilateral(tmp_path_factory):
    return small_pile(tmp_path_factory, "equilateral", "pile-equilateral.toml", f"source.rows={ROWS}")


@pytest.fixture(scope="module")
def slope(tmp_path_factory):
    return small_pile(tmp_path_factory, "slope", "pile-slope.toml", "source.base_count=25")


@pytest.fixture(scope="module")
def hybrid(tmp_path_factory):
    return small_pile(tmp_path_factory, "hybrid", "pile-slope.toml", "source.base_count=25", "method.kind=hybrid")


class State:
    """Grains and contacts of run.h5; forces in grain weights, which are 1."""

    def __init__(self, folder):
        with h5py.File(folder / "run.h5") as file:
            self.id, self.position = file["grains/id"][()], file["grains/position"][()]
            self.fixed = file["grains/fixed"][()] == 1
            self.pairs, self.normal = file["contacts/grains"][()], file["contacts/normal"][()]
            self.force, self.overlap = file["contacts/normal_force"][()], file["contacts/overlap"][()]
        row = {k: n for n, k in enumerate(self.id)}
        self.ends = np.array([[row[k] for k in pair] for pair in self.pairs])


# (42) and (44): a disc of the lowest row bears (k + 1)/2 with its own weight, so a fixed one feels (k - 1)/2 of the others,
# and pushes outward with (2 i - k - 1)/(2 sqrt 3). Tolerance: overlaps are 1e-5 (k + 1)/2 diameters, and they turn the
# contacts by as much; the stop leaves net forces of 1e-7.
def test_an_equilateral_pile_has_the_base_forces_of_the_lattice(equilateral):
    folder, _ = equilateral
    with h5py.File(folder / "run.h5") as file:
        base = {name: file[f"base/{name}"][()] for name in ("x", "normal", "shear")}
    under = np.abs(base["x"]) <= 0.5 * (ROWS - 1)
    assert under.sum() == ROWS
    i = np.arange(1, ROWS + 1)
    np.testing.assert_allclose(base["normal"][under], 0.5 * (ROWS - 1), rtol=1e-3)
    np.testing.assert_allclose(base["shear"][under], (2 * i - ROWS - 1) / (2.0 * np.sqrt(3.0)), atol=1e-3)
    assert not base["normal"][~under].any()
    assert summary(folder)["weight_error"] == pytest.approx(0.0, abs=1e-6)


# The strongest contact of a disc left of the axis leads down to the left, of one right of it down to the right (see
# tests/unit/force_lines_test.cpp); rows carry nothing.
def test_lines_of_force_of_an_equilateral_pile(equilateral):
    folder, _ = equilateral
    state = State(folder)
    with h5py.File(folder / "analysis.h5") as file:
        lines = {name: file[f"force_lines/{name}"][()] for name in file["force_lines"]}
        assert file["force_lines/strongest_force"].attrs["unit"] == "M L/T^2"
        assert file["force_lines"].attrs["horizontal_within"] == 15.0
    numbers = summary(folder)["force_lines"]
    assert numbers["grains"] == ROWS * (ROWS - 1) // 2 == len(lines["id"])
    assert numbers["horizontal"] == 0 and numbers["horizontal_fraction"] == 0.0 and numbers["largest_horizontal"] == 0.0
    assert numbers["strongest_horizontal"] == 0.0 and numbers["weakest_horizontal"] == 0.0
    np.testing.assert_array_equal(state.force[lines["strongest"]], lines["strongest_force"])
    np.testing.assert_array_equal(state.force[lines["weakest"]], lines["weakest_force"])
    for k, row in zip(lines["id"], lines["strongest"]):
        own = state.force[(state.pairs == k).any(axis=1)]
        assert state.force[row] == pytest.approx(own.max(), rel=1e-12)  # two sides of a symmetric pile
        x = state.position[state.id == k][0, 0]
        towards = state.position[state.ends[row]].sum(axis=0) - 2.0 * state.position[state.id == k][0]
        if abs(x) > 0.1:
            assert towards[1] < 0.0 and np.sign(towards[0]) == np.sign(x)


# Rows of a flatter pile carry force: [L] sees horizontal lines among the weakest contacts, and none among the strongest.
def test_rows_of_a_flatter_pile_carry_force(slope):
    folder, _ = slope
    state = State(folder)
    numbers = summary(folder)["force_lines"]
    counts = state.force > 1e-3  # analysis.force_threshold of the scene
    horizontal = counts & (np.abs(state.normal[:, 1]) < np.sin(np.radians(15.0)))
    assert numbers["horizontal"] == horizontal.sum() > 10
    assert numbers["horizontal_fraction"] == pytest.approx(horizontal.sum() / counts.sum())
    assert numbers["largest_horizontal"] == state.force[horizontal].max()
    assert numbers["strongest_horizontal"] == 0.0
    assert 0.0 < numbers["weakest_horizontal"] < 1.0


def stiffness_of(state, stiffness):
    """The full matrix of the moving grains, written from the energy of the springs: its second derivatives by hand."""
    moving = np.flatnonzero(~state.fixed)
    place = {k: n for n, k in enumerate(moving)}
    matrix = np.zeros((2 * len(moving), 2 * len(moving)))
    for (a, b), n, force, overlap in zip(state.ends, state.normal, state.force, state.overlap):
        along = np.outer(n, n)
        block = stiffness * along - force / (1.0 - overlap) * (np.eye(2) - along)
        for i, sign_i in ((a, 1.0), (b, -1.0)):
            for j, sign_j in ((a, 1.0), (b, -1.0)):
                if i in place and j in place:
                    rows, columns = slice(2 * place[i], 2 * place[i] + 2), slice(2 * place[j], 2 * place[j] + 2)
                    matrix[rows, columns] += sign_i * sign_j * block
    return matrix


# Against all eigenvalues of the full matrix, by numpy. Tolerance: rounding of entries of 1e5.
@pytest.mark.parametrize("name", ["equilateral", "slope", "hybrid"])
def test_stability_is_that_of_the_full_matrix(name, request):
    folder, said = request.getfixturevalue(name)
    state = State(folder)
    values, vectors = np.linalg.eigh(stiffness_of(state, 1e5))
    found = summary(folder)["stability"]
    assert found["problem"] == ""
    assert found["grains"] == (~state.fixed).sum() and found["directions"] == len(values)
    assert found["contacts"] == (state.force > 0.0).sum()
    assert found["smallest"] == pytest.approx(values[0], abs=1e-5)
    assert found["relative"] == pytest.approx(values[0] / 1e5, abs=1e-10)
    assert found["stiffness"] == pytest.approx(1e5)
    assert (found["negative"], found["neutral"]) == (0, 0) and values[0] > 0.0
    assert found["unbalanced"] < 1e-6 and found["residual"] < 1e-10
    with h5py.File(folder / "analysis.h5") as file:
        mode = file["stability/displacement"][()]
        np.testing.assert_array_equal(file["stability/id"][()], state.id[~state.fixed])
    assert np.hypot(*mode.T).max() == pytest.approx(1.0)
    # The mode lies in the space of the eigenvalues that are equal to the smallest, two of which symmetry may bring.
    space = vectors[:, values < values[0] * (1.0 + 1e-6)]
    direction = mode.ravel() / np.linalg.norm(mode)
    assert np.linalg.norm(space.T @ direction) == pytest.approx(1.0, abs=1e-6)
    square = (mode**2).sum(axis=1)
    assert found["participation"] == pytest.approx(square.sum() ** 2 / (square**2).sum())
    assert "stability        smallest eigenvalue" in said


def base_of(folder):
    with h5py.File(folder / "run.h5") as file:
        return {name: file[f"base/{name}"][()] for name in ("id", "x", "normal", "shear")}


# Springs of one stiffness have one equilibrium, whichever method finds it: the forces differ by what the stop of the soft
# run leaves, 1e-7 for each of the 117 discs.
def test_soft_and_hybrid_piles_have_the_same_base_forces(slope, hybrid):
    soft, other = base_of(slope[0]), base_of(hybrid[0])
    np.testing.assert_array_equal(soft["x"], other["x"])
    np.testing.assert_allclose(other["normal"], soft["normal"], atol=2e-5)
    np.testing.assert_allclose(other["shear"], soft["shear"], atol=2e-5)
    assert soft["normal"].max() > 5.0


# One --set away: each method takes its keys from [for.KIND]. Tolerance: the residual of each, in weights.
@pytest.mark.parametrize("scene", ["pile-slope.toml", "pile-on-floor.toml"])
@pytest.mark.parametrize("method", ["hybrid", "contact-dynamics"])
def test_a_pile_by_another_method_carries_its_weight(lab, scene, method):
    settings = ["--set", f"method.kind={method}", "--set", "source.base_count=15"]
    result = lab("run", EXAMPLES / scene, "--out", "out", "--quiet", *settings)
    assert result.returncode == 0, result.stderr
    found = summary(lab.path / "out")
    assert found["method"] == method and found["status"] == "finished"
    base = base_of(lab.path / "out")
    carried = found["grains"]
    assert base["normal"].sum() == pytest.approx(carried, rel=1e-5)
    assert base["shear"].sum() == pytest.approx(0.0, abs=1e-4)
    assert found["base_profile"]["normal"] == pytest.approx(list(base["normal"]))
    if method == "contact-dynamics":
        result = lab("analyse", "out", "--force-range")
        assert result.returncode == 0, result.stderr
        allowed = summary(lab.path / "out")["force_range"]
        assert allowed["unknowns"] > allowed["equations"]
        low, high = allowed["central_force"]["min"], allowed["central_force"]["max"]
        assert low < base["normal"][len(base["x"]) // 2] < high and high - low > 1.0


# The wells of static friction follow the normal force: they are no springs, and the program says so.
def test_stability_of_a_hybrid_pile_needs_a_pinned_base(lab):
    settings = []
    for setting in (f"source.base_count={ROWS}", "stop.time=0.2", "output.series=0.1"):
        settings += ["--set", setting]
    scene = EXAMPLES / "pile-hybrid.toml"
    assert lab("run", scene, "--out", "out", "--quiet", *settings).returncode == 0
    assert "pin the grains (method.pin_base)" in lab("analyse", "out", "--stability").stdout
    settings += ["--set", "method.pin_base=true"]
    assert lab("run", scene, "--out", "pinned", "--quiet", *settings).returncode == 0
    assert lab("analyse", "pinned", "--stability").returncode == 0
    found = summary(lab.path / "pinned")["stability"]
    discs = ROWS * (ROWS + 1) // 2
    assert (found["grains"], found["directions"]) == (discs, 2 * discs - ROWS)
    assert found["smallest"] > 0.0 and found["stiffness"] == pytest.approx(1e5)


# On a floor that holds its discs the base forces are (42) and (44) with the own weight. Tolerance: the floor yields along
# itself with a stiffness of about 1e6, and the stop leaves net forces of 1e-6. The held discs can move up and down alone.
def test_a_pile_on_a_floor_that_holds_its_discs(lab):
    settings = ["--set", f"source.base_count={ROWS}", "--set", "source.slope=60"]
    result = lab("run", EXAMPLES / "pile-on-floor.toml", "--out", "out", "--quiet", *settings)
    assert result.returncode == 0, result.stderr
    assert lab("analyse", "out", "--stability").returncode == 0
    with h5py.File(lab.path / "out" / "run.h5") as file:
        grains, normal = file["contacts/grains"][()], file["contacts/normal_force"][()]
        shear = file["contacts/tangential_force"][()]
        x = dict(zip(file["grains/id"][()], file["grains/position"][:, 0]))
    on_floor = sorted((x[a], n, t) for (a, b), n, t in zip(grains, normal, shear) if b < 0)
    assert len(on_floor) == ROWS
    np.testing.assert_array_equal(base_of(lab.path / "out")["normal"], [n for _, n, _ in on_floor])
    np.testing.assert_allclose(base_of(lab.path / "out")["shear"], [t for *_, t in on_floor], atol=1e-9)
    i = np.arange(1, ROWS + 1)
    np.testing.assert_allclose([n for _, n, _ in on_floor], 0.5 * (ROWS + 1), rtol=1e-3)
    # On the disc along z x n, which points to the left: on the floor to the right.
    np.testing.assert_allclose([t for *_, t in on_floor], (2 * i - ROWS - 1) / (2.0 * np.sqrt(3.0)), atol=2e-3)
    found = summary(lab.path / "out")["stability"]
    discs = ROWS * (ROWS + 1) // 2
    assert (found["grains"], found["directions"]) == (discs, 2 * discs - ROWS)
    assert found["smallest"] > 0.0 and found["negative"] == 0


def test_stability_is_unknown_with_friction(lab):
    heap = "[base]\nkind = 'row'\nhalf_width = 8\n[source]\nkind = 'lattice'\nrows = 4\n[stop]\nat_rest = 1e-5\ntime = 300\n"
    folder = lab.run(heap)
    assert "stability" not in summary(folder)
    done = lab("analyse", "out", "--stability")
    assert done.returncode == 0, done.stderr
    assert "stability        unknown: grains have friction" in done.stdout
    found = summary(folder)["stability"]
    assert found["problem"].startswith("grains have friction") and found["smallest"] is None
    assert not (lab.path / "out" / "pictures").exists()
    done = lab("plot", "out", "--only", "stability")
    assert "stability: not drawn: its stability was not analysed" in done.stdout


BASE = "[base]\nkind = 'row'\nhalf_width = 22\n[stop]\ntime = 1\n[source]\nkind = 'lattice'\n"


@pytest.mark.parametrize(
    "source, part",
    [
        ("slope = 30\n", "source.rows: missing: the rows of a 60-degree pile; or give source.base_count"),
        ("rows = 5\nbase_count = 5\n", "source.base_count = 5: give this or source.rows, not both"),
        ("rows = 5\nslope = 30\n", "source.rows = 5: is for a pile of 60 degrees; give source.base_count"),
        ("base_count = 5\nslope = 61\n", "source.slope = 61: must be > 0 and <= 60"),
        ("base_count = 5\nslope = 30\nupper_slope = 45\n", "source.upper_slope = 45: needs source.break_at"),
        ("base_count = 5\nbreak_at = 0.6\n", "source.break_at = 0.6: must be > 0 and <= 0.5"),
        ("base_count = 4001\n", "source.base_count = 4001: must be at most 4000"),
        ("base_count = 46\nfixed_base = true\n", "source.base_count = 46: the pile must lie within x = +-22"),
        ("base_count = 45\n", "source.base_count = 45: the pile must lie within x = +-22"),
        ("columns = 5\nrows = 3\nslope = 30\n", "source.slope: unknown key; known here: columns, gap, jitter, kind, rows, x"),
    ],
)
def test_refused_piles(lab, source, part):
    lab.refused("run", lab.scene(BASE + source), "--out", "out", parts=(part,))


def test_a_fixed_base_needs_a_row(lab):
    plane = "[base]\nkind = 'plane'\n[stop]\ntime = 1\n[source]\nkind = 'lattice'\nrows = 5\nfixed_base = true\n"
    lab.refused("run", lab.scene(plane), "--out", "out", parts=("source.fixed_base = true: needs a base of fixed grains",))


@pytest.mark.parametrize(
    "settings, grains, words",
    [
        ("source.slope=30", 315, "a lattice pile of 15 rows, 45 grains wide, with flanks of 30 deg; its lowest row is the base"),
        ("source.slope=55", 776, "45 grains wide, with flanks of 55 deg"),
        ("source.base_count=180", 5310, "180 grains wide"),
    ],
)
def test_check_says_what_pile_it_is(lab, settings, grains, words):
    said = lab("check", EXAMPLES / "pile-slope.toml", "--set", settings)
    assert said.returncode == 0, said.stderr
    assert words in said.stdout
    assert str(grains) in said.stdout


def test_a_written_scene_is_the_same_pile(lab):
    folder = lab.run(BASE.replace("time = 1", "time = 0.01") + "base_count = 9\nslope = 30\nfixed_base = true\n")
    written = (folder / "scene.toml").read_text()
    assert "base_count = 9" in written and "fixed_base = true" in written
    assert lab("check", "out/scene.toml").stdout == lab("check", "scene.toml").stdout
