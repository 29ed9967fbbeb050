# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""`repose analyse --force-range`: which base forces statics allows, against a programme of its own."""

import csv
import shutil
from pathlib import Path

import h5py
import numpy as np
import pytest
from conftest import Laboratory, number_in, summary

SCENE = Path(__file__).parents[2] / "examples" / "heap-cd.toml"
SMALL = ["--set", "source.count=60", "--set", "base.half_width=30", "--set", "source.height=10"]
FRICTION, CONTACT_GAP, MARGIN = 0.5, 5e-4, 1e-6
NUMBERS = ("central_force", "dip", "largest")


@pytest.fixture(scope="module")
def rigid(tmp_path_factory):
    """A rigid heap of 60 grains at rest, analysed with its force range. Tests only read it."""
    lab = Laboratory(tmp_path_factory.mktemp("rigid"))
    result = lab("run", SCENE, *SMALL, "--out", "out", "--quiet")
    assert result.returncode == 0, result.stderr
    result = lab("analyse", "out", "--force-range")
    assert result.returncode == 0, result.stderr
    return lab.path / "out", result.stdout


class Programme:
    """The equations of a run folder with N and T of each contact as unknowns, which scipy solves."""

    def __init__(self, folder):
        with h5py.File(folder / "run.h5") as file:
            self.position, self.radius = file["grains/position"][()], file["grains/radius"][()]
            fixed, mass = file["grains/fixed"][()], file["grains/mass"][()]
            self.base = np.flatnonzero(file["grains/base"][()])
            row = {k: n for n, k in enumerate(file["grains/id"][()])}
            recorded = {
                (row[a], row[b]): forces
                for (a, b), *forces in zip(
                    file["contacts/grains"][()], file["contacts/normal_force"][()], file["contacts/tangential_force"][()]
                )
            }
            weight = file.attrs["grain_weight"]
        apart = self.position[:, None] - self.position[None]
        distance = np.hypot(apart[..., 0], apart[..., 1])
        reach = self.radius[:, None] + self.radius[None]
        near = np.triu(distance - reach <= CONTACT_GAP * reach, 1) & ~((fixed[:, None] & fixed[None]) == 1)
        self.pairs = sorted({(int(a), int(b)) for a, b in zip(*np.nonzero(near))} | recorded.keys())
        touching = np.unique([k for pair in self.pairs for k in pair if not fixed[k]])
        place = {k: 3 * n for n, k in enumerate(touching)}
        count = len(self.pairs)
        self.balance = np.zeros((3 * len(touching), 2 * count))
        self.on_base = np.zeros((len(self.base), 2 * count))  # downward
        self.forces = np.zeros(2 * count)
        for k, (a, b) in enumerate(self.pairs):
            normal = apart[a, b] / distance[a, b]
            tangent = np.array([-normal[1], normal[0]])
            for body, side in ((a, 1.0), (b, -1.0)):
                if body in place:
                    rows = slice(place[body], place[body] + 2)
                    self.balance[rows, 2 * k], self.balance[rows, 2 * k + 1] = side * normal, side * tangent
                    self.balance[place[body] + 2, 2 * k + 1] = -distance[a, b] / reach[a, b]
                for base in np.flatnonzero(self.base == body):
                    self.on_base[base, 2 * k : 2 * k + 2] = -side * normal[1], -side * tangent[1]
            n, t = np.array(recorded.get((a, b), (0.0, 0.0))) / weight
            self.forces[2 * k : 2 * k + 2] = n, np.clip(t, -FRICTION * n, FRICTION * n)
        self.load = np.zeros(len(self.balance))
        self.load[1::3] = -mass[touching] / mass[touching].max() if np.ptp(mass[touching]) else -1.0
        missed = self.balance @ self.forces + self.load
        self.unbalanced = np.abs(missed).max()
        slack = np.abs(missed) + MARGIN
        # A x <= b: both sides of every balance, and |T| <= mu N.
        cones = np.zeros((2 * count, 2 * count))
        for k in range(count):
            cones[2 * k, 2 * k : 2 * k + 2] = -FRICTION, 1.0
            cones[2 * k + 1, 2 * k : 2 * k + 2] = -FRICTION, -1.0
        self.rows = np.concatenate([self.balance, -self.balance, cones])
        self.limits = np.concatenate([-self.load + slack, self.load + slack, np.zeros(2 * count)])
        self.bounds = [(0, None), (None, None)] * count

    def extreme(self, cost, side):
        from scipy.optimize import linprog

        found = linprog(-side * cost, self.rows, self.limits, bounds=self.bounds, method="highs")
        assert found.status == 0, found.message
        return cost @ found.x

    def extreme_ratio(self, above, below, side):
        """Charnes and Cooper (1962): with y = s x and s so that below y = 1, the ratio is linear in y."""
        from scipy.optimize import linprog

        rows = np.column_stack([self.rows, -self.limits])
        cost = np.append(-side * above, 0.0)
        found = linprog(
            cost, rows, np.zeros(len(rows)), np.append(below, 0.0)[None], [1.0], [*self.bounds, (0, None)], method="highs"
        )
        assert found.status == 0, found.message
        return -side * found.fun

    def least_of_largest(self):
        from scipy.optimize import linprog

        sums = np.column_stack([self.on_base, -np.ones(len(self.on_base))])
        rows = np.concatenate([np.column_stack([self.rows, np.zeros(len(self.rows))]), sums])
        cost = np.append(np.zeros(self.rows.shape[1]), 1.0)
        limits = np.concatenate([self.limits, np.zeros(len(sums))])
        found = linprog(cost, rows, limits, bounds=[*self.bounds, (None, None)], method="highs")
        assert found.status == 0, found.message
        return found.fun

    def zones(self, dip):
        place = np.abs(self.position[self.base, 0] - dip["centre"]) / dip["half_width"]
        inner, outer = place <= 0.15, (place > 0.15) & (place <= 0.45)
        return self.on_base[inner].mean(axis=0), self.on_base[outer].mean(axis=0)


# Tolerance: both methods stop when bounds are missed by 1e-7 to 1e-9 grain weights; chains of contacts over the height
# of the heap magnify that to some 1e-5.
CLOSE = {"rel": 1e-4, "abs": 1e-4}


def test_ranges_are_those_of_another_solver(rigid):
    pytest.importorskip("scipy")
    folder, _ = rigid
    found, dip = summary(folder)["force_range"], summary(folder)["base_dip"]
    other = Programme(folder)
    assert found["problem"] == ""
    assert found["contacts"] == len(other.pairs)
    assert found["unknowns"] == 2 * len(other.pairs)
    assert found["equations"] == len(other.balance)
    assert found["degree"] == found["unknowns"] - found["equations"]
    assert found["unbalanced"] == pytest.approx(other.unbalanced, rel=1e-3, abs=1e-9)
    inner, outer = other.zones(dip)
    for name, side in (("min", -1.0), ("max", 1.0)):
        assert found["central_force"][name] == pytest.approx(other.extreme(inner, side), **CLOSE), name
        assert found["dip"][name] == pytest.approx(other.extreme_ratio(outer, inner, side), **CLOSE), name
    assert found["largest"]["min"] == pytest.approx(other.least_of_largest(), **CLOSE)
    loaded = [row for row in other.on_base if row.any()]
    assert found["largest"]["max"] == pytest.approx(max(other.extreme(row, 1.0) for row in loaded), **CLOSE)
    forces = other.on_base @ other.forces
    assert found["largest"]["warm"] == pytest.approx(forces.max(), rel=1e-9)
    assert found["central_force"]["warm"] == pytest.approx(inner @ other.forces, rel=1e-9)
    with h5py.File(folder / "analysis.h5") as file:
        bins, width = {name: file["force_range"][name][()] for name in ("x", "min", "max")}, file["force_range"].attrs["bin_width"]
    for x, least, most in zip(*bins.values()):
        mean = other.on_base[np.floor(other.position[other.base, 0] / width + 0.5) == round(x / width)].mean(axis=0)
        assert least == pytest.approx(other.extreme(mean, -1.0), **CLOSE)
        assert most == pytest.approx(other.extreme(mean, 1.0), **CLOSE)


def test_recorded_and_cold_forces_lie_in_the_range(rigid):
    folder, _ = rigid
    found = summary(folder)["force_range"]
    # The cold solution moves grains by its residual, so that it may miss the balance by more than the margin.
    slack = {"warm": 1e-6, "cold": 0.01 + 10.0 * found["cold_residual"]}
    for name in NUMBERS:
        for state, least in slack.items():
            value = found[name][state]
            assert found[name]["min"] - least * max(1.0, value) <= value <= found[name]["max"] + least * max(1.0, value)
        assert found[name]["max"] > 1.2 * found[name]["min"], "statics alone should leave this number open"
    assert found["cold_residual"] < 1e-2
    # Forces of the last step and their mean over the window differ by the creep of the heap.
    assert found["dip"]["warm"] == pytest.approx(summary(folder)["base_dip"]["index"], rel=0.02)


def test_the_text_names_range_and_states(rigid):
    folder, text = rigid
    found = summary(folder)["force_range"]
    assert f"{found['unknowns']} unknowns, {found['equations']} equations" in text
    assert number_in(text, r"dip index\s+\S+ to \S+; cold \S+, warm") == pytest.approx(found["dip"]["warm"], abs=1e-3)
    assert number_in(text, "central force") == pytest.approx(found["central_force"]["min"], abs=1e-3)


def test_an_analysis_without_the_option_has_no_range(lab, rigid):
    shutil.copytree(rigid[0], lab.path / "out")
    assert lab("analyse", "out", "--quiet").returncode == 0
    assert "force_range" not in summary(lab.path / "out")
    assert (lab.path / "out/run.h5").read_bytes() == (rigid[0] / "run.h5").read_bytes()


@pytest.mark.parametrize("warm_start", ("always", "settled", "never"))
def test_a_load_is_part_of_the_balance(lab, warm_start):
    """A disc on two base discs under a load of three of its weights: both bear two weights, whatever friction does."""
    folder = lab.run(
        f"[method]\nkind = 'contact-dynamics'\nwarm_start = '{warm_start}'\n[base]\nkind = 'row'\nhalf_width = 3\n"
        "[[grain]]\nposition = [0.5, 0.8660254037844386]\n"
        "[[load]]\nposition = [0.5, 1]\nforce = [0, -3]\nstart = 1\n[stop]\ntime = 3\n"
    )
    assert lab("analyse", "out", "--force-range", "--quiet").returncode == 0
    found = summary(folder)["force_range"]
    assert (found["contacts"], found["unknowns"], found["equations"], found["degree"]) == (2, 4, 3, 1)
    # Both base discs bear N cos 30 + T sin 30 = 2 in every state: see the wedge of tests/unit/force_range_test.cpp.
    for state in ("min", "max", "warm", "cold"):
        assert found["largest"][state] == pytest.approx(2.0, abs=1e-4), state


def test_rolling_friction_adds_unknowns(lab):
    """Torques are not recorded: the balance of a heap that leans on them is found again to the tolerance of the run."""
    rolling = ["--set", "source.count=30", "--set", "contact.rolling_friction=0.3"]
    result = lab("run", SCENE, *SMALL, *rolling, "--out", "out", "--quiet")
    assert result.returncode == 0, result.stderr
    assert lab("analyse", "out", "--force-range", "--quiet").returncode == 0
    found = summary(lab.path / "out")["force_range"]
    assert found["problem"] == "" and found["unknowns"] == 3 * found["contacts"]
    assert found["unbalanced"] < 5e-3, "the run stops at a net force of 1e-3"
    for name in ("central_force", "largest"):
        assert found[name]["min"] - 1e-6 <= found[name]["warm"] <= found[name]["max"] + 1e-6


def test_moving_grains_have_no_range_and_the_reason_is_given(lab):
    folder = lab.run(
        "[method]\nkind = 'contact-dynamics'\n[base]\nkind = 'row'\nhalf_width = 3\n"
        "[[grain]]\nposition = [1.0, 1.0]\nvelocity = [0.3, 0]\n[stop]\ntime = 0.5\n"
    )
    result = lab("analyse", "out", "--force-range")
    assert result.returncode == 0 and "the state is not in equilibrium" in result.stdout
    found = summary(folder)["force_range"]
    assert "not in equilibrium" in found["problem"] and found["unbalanced"] > 0.05
    assert found["dip"] == found["largest"] == {"min": None, "max": None, "cold": None, "warm": None}


def test_other_methods_are_refused(lab, heap):
    shutil.copytree(heap, lab.path / "soft")
    before = summary(lab.path / "soft")
    said = lab.refused("analyse", "soft", "--force-range", parts=["no force range: the method of the run is soft"])
    assert len(said.splitlines()) == 1 and summary(lab.path / "soft") == before
    lab.run("[method]\nkind = 'deposition'\ncritical_angle = 50\n[base]\nkind = 'contiguous'\ncount = 8\n[source]\ncount = 20\n")
    assert len(lab.refused("analyse", "out", "--force-range", parts=["the method of the run is deposition"]).splitlines()) == 1


def test_a_sweep_has_the_mean_over_its_members(lab, rigid):
    scene = (rigid[0] / "scene.toml").read_text()
    assert "count = 60" in scene
    lab.scene(scene.replace("count = 60", "count = 30"), "heap.toml")
    lab.scene("scene = 'heap.toml'\nseeds = 2\n[vary]\ncontact.friction = [0.5]\n", "sweep.toml")
    assert lab("sweep", "sweep.toml", "--out", "all", "--quiet").returncode == 0
    result = lab("analyse", "all", "--force-range", "--quiet")
    assert result.returncode == 0, result.stderr
    members = [summary(path.parent)["force_range"] for path in (lab.path / "all").rglob("seed-*/summary.json")]
    assert len(members) == 2
    with open(lab.path / "all/table.csv") as file:
        (row,) = csv.DictReader(file)
    for name in NUMBERS:
        for state in ("min", "max", "cold", "warm"):
            values = [member[name][state] for member in members]
            if None in values:
                assert (name, state) == ("dip", "max"), "only the dip index of a small heap may have no bound"
                continue
            assert float(row[f"force_range.{name}.{state}"]) == pytest.approx(np.mean(values), rel=1e-6), (name, state)


def test_a_sweep_of_several_methods_has_ranges_where_grains_are_rigid(lab, rigid):
    scene = (rigid[0] / "scene.toml").read_text().replace("count = 60", "count = 20")
    lab.scene(scene, "heap.toml")
    soft = "[base]\nkind = 'row'\nhalf_width = 4\n[source]\nkind = 'pour'\ncount = 5\nrate = 1.0\n[stop]\ntime = 20\n"
    lab.scene(soft, "soft.toml")
    points = "seeds = 1\n[[point]]\nname = 'soft'\nscene = 'soft.toml'\n"
    lab.scene(points, "soft-sweep.toml")
    lab.scene(points + "[[point]]\nname = 'rigid'\nscene = 'heap.toml'\n", "sweep.toml")
    for name in ("soft-sweep", "sweep"):
        assert lab("sweep", f"{name}.toml", "--out", name, "--quiet").returncode == 0
    assert lab("analyse", "sweep", "--force-range", "--quiet").returncode == 0
    assert "force_range" not in summary(lab.path / "sweep/members/soft/seed-1")
    assert summary(lab.path / "sweep/members/rigid/seed-1")["force_range"]["unknowns"] > 20
    lab.refused("analyse", "soft-sweep", "--force-range", parts=["no force range: only rigid grains have one"])
