# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Contact problems outside a run: exported, solved, judged by the independent residual, refused if invalid."""

import sys
from pathlib import Path

import h5py
import numpy as np
import pytest
from conftest import Grains, Laboratory, changed, everything_in

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks" / "peers"))
from contact_problem import NORMAL, TANGENTIAL, read_problem, residual, velocities  # noqa: E402

BOX = """
[method]
kind = "contact-dynamics"
time_step = 0.05
tolerance = %s
[contact]
friction = 0.5
[grains]
polydispersity = 0.3
[base]
kind = "plane"
[[plane]]
point = [-4.6, 0]
normal = [1, 0]
[[plane]]
point = [4.6, 0]
normal = [-1, 0]
[source]
kind = "lattice"
rows = 6
columns = 8
gap = 0.01
jitter = 1.0
[stop]
time = %s
"""
PROBLEM = "out/export/contact-problem/problem.h5"
# Infinite friction, rolling friction and fixed grains.
LAID_DOWN = """
[method]
kind = "contact-dynamics"
critical_angle = 50
[base]
kind = "contiguous"
count = 12
[source]
kind = "sequential"
count = 25
[stop]
at_rest = 0.01
time = 2000
"""
SCENES = {"friction": BOX % ("1e-7", 8), "rolling": LAID_DOWN}


@pytest.fixture(scope="module", params=SCENES)
def bed(request, tmp_path_factory):
    lab = Laboratory(tmp_path_factory.mktemp(request.param))
    lab.run(SCENES[request.param], "--threads", "1")
    result = lab("export", "out", "--to", "contact-problem")
    assert result.returncode == 0, result.stderr
    assert result.stdout.strip() == PROBLEM
    lab.problem = read_problem(lab.path / PROBLEM)
    return lab


def solved(lab, *options, problem=PROBLEM):
    """The (impulses, attributes, velocities) that `repose solve` writes."""
    result = lab("solve", problem, "--out", "answer.h5", "--overwrite", *options)
    assert result.returncode == 0, result.stderr
    with h5py.File(lab.path / "answer.h5") as file:
        return file["impulse"][()], dict(file.attrs), file["velocity"][()]


# From zero impulses, contacts open, close and slide alternately, which takes more sweeps than the limit of a run allows.
@pytest.mark.parametrize("tolerance, how", ((1e-6, ["--most-sweeps", "200000"]), (1e-6, ["--warm"]),
                                            (1e-4, ["--solver", "sweeps", "--most-sweeps", "200000"]),
                                            (1e-6, ["--most-sweeps", "3"])))
def test_the_independent_residual_agrees_with_that_of_the_program(bed, tolerance, how):
    impulses, said, moved = solved(bed, "--tolerance", tolerance, *how)
    outside = residual(bed.problem, impulses)
    for name in ("normal", "tangential", "rolling"):
        assert outside[name] == pytest.approx(said[f"residual_{name}"], rel=1e-6, abs=1e-11), name
    assert outside["worst"] == pytest.approx(said["residual"], rel=1e-6, abs=1e-11)
    assert outside["complementarity"] == pytest.approx(said["complementarity"], rel=1e-6, abs=1e-11)
    assert np.allclose(velocities(bed.problem, impulses), moved, rtol=0, atol=1e-12)
    if "3" in how:
        assert said["converged"] == 0 and outside["worst"] > 1e-3
    else:
        assert said["converged"] == 1 and outside["worst"] <= tolerance * (1 + 1e-6)
    assert said["contact_iterations"] == 2 * said["sweeps"] * len(impulses) and said["cpu_seconds"] > 0


def test_the_independent_residual_finds_planted_errors(bed):
    impulses, _, _ = solved(bed, "--tolerance", "1e-6", "--most-sweeps", "200000")
    problem = bed.problem
    assert residual(problem, impulses)["worst"] <= 1e-6 * (1 + 1e-6)
    # Without contact impulses the grains fall: contacts close at g dt or faster.
    assert residual(problem, np.zeros_like(impulses))["normal"] > 0.9
    pressed = np.flatnonzero(impulses[:, NORMAL] > 0.1 * impulses[:, NORMAL].max())
    assert len(pressed) > 10
    for k in pressed[::7]:
        for change in (1.01, 0.99, 0.0, -1.0):
            wrong = impulses.copy()
            wrong[k, NORMAL] *= change
            assert residual(problem, wrong)["normal"] > 1e-4
        wrong = impulses.copy()
        wrong[k, TANGENTIAL] += 0.01 * impulses[k, NORMAL]
        assert residual(problem, wrong)["tangential"] > 1e-4
    # A bed in which friction exceeds its limit, although nothing moves.
    weak = read_problem(bed.path / PROBLEM)
    used = np.abs(impulses[pressed, TANGENTIAL]) / impulses[pressed, NORMAL]
    weak.friction = np.where(np.isin(np.arange(len(impulses)), pressed[used.argmax()]), 0.5 * used.max(), problem.friction)
    assert residual(weak, impulses)["tangential"] > 1e-3
    if problem.rolling_friction.any():
        most = pressed[np.abs(impulses[pressed, 2]).argmax()]
        weak = read_problem(bed.path / PROBLEM)
        weak.rolling_friction[most] = 0.5 * abs(impulses[most, 2]) / impulses[most, NORMAL]
        assert residual(weak, impulses)["rolling"] > 1e-3
    lost = impulses.copy()
    lost[3, 0] = np.nan
    assert residual(problem, lost)["worst"] == np.inf


# The solver starts from the impulses of the run, to rounding. Velocities are unique where friction does not slide.
def test_the_problem_is_the_next_step_of_the_run(lab):
    lab.run(BOX % ("1e-11", 2.0))
    assert lab("export", "out", "--to", "contact-problem").returncode == 0
    with h5py.File(lab.path / PROBLEM) as file:
        ids, time_step = file["bodies/id"][()], file.attrs["time_step"]
        assert file.attrs["velocity_scale"] == pytest.approx(time_step)
        assert np.isinf(file["bodies/mass"][ids < 0]).all() and (ids < 0).sum() == 3
    _, said, moved = solved(lab, "--tolerance", "1e-11", "--warm")
    assert said["converged"] == 1
    lab.run(BOX % ("1e-11", 2.0 + time_step), out="longer")
    after = Grains(lab.path / "longer/run.h5")
    row = {k: n for n, k in enumerate(ids)}
    found = moved[[row[k] for k in after.id]]
    assert after.time == pytest.approx(2.0 + time_step)
    assert np.abs(after.velocity).max() > 1e-3
    assert np.allclose(found[:, :2], after.velocity, rtol=0, atol=1e-9)
    assert np.allclose(found[:, 2], after.spin, rtol=0, atol=1e-9)


def test_warm_start_is_nearer(bed):
    _, cold, _ = solved(bed, "--tolerance", "1e-5")
    _, warm, _ = solved(bed, "--tolerance", "1e-5", "--warm")
    assert warm["sweeps"] < cold["sweeps"]


def test_a_file_of_another_program_is_read(bed):
    with h5py.File(bed.path / PROBLEM) as ours, h5py.File(bed.path / "theirs.h5", "w") as theirs:
        for name in ("bodies", "contacts"):
            ours.copy(name, theirs)
        theirs.attrs["format"] = "repose-contact-problem"
        for name in ("format_version", "velocity_scale", "time", "time_step"):
            theirs.attrs[name] = ours.attrs[name]
    first, second = solved(bed)[0], solved(bed, problem="theirs.h5")[0]
    assert (first == second).all()


def planted(lab, change):
    """Writes a new file of the problem with a change in it."""
    path = lab.path / "bad.h5"
    path.write_bytes((lab.path / PROBLEM).read_bytes())
    with changed(path) as file:
        change(file)
    return "bad.h5"


def put(name, row, value):
    def change(file):
        file[name][row] = value

    return change


def remove(name):
    def change(file):
        del file[name]

    return change


def shorten(file):
    values = file["contacts/friction"][:-1]
    del file["contacts/friction"]
    file["contacts/friction"] = values


BAD = [
    (put("contacts/friction", 3, -0.5), "contacts/friction: row 3: must be >= 0"),
    (put("contacts/friction", 3, np.nan), "contacts/friction: row 3: must be >= 0"),
    (put("contacts/rolling_friction", 2, -1), "contacts/rolling_friction: row 2"),
    (put("contacts/bodies", (4, 1), 1000), "contacts/bodies: row 4: must be rows of bodies"),
    (put("contacts/bodies", (4, 0), -1), "contacts/bodies: row 4: must be rows of bodies"),
    (put("contacts/bodies", 5, [7, 7]), "contacts/bodies: row 5: must be two bodies"),
    (put("contacts/normal", 6, [0.6, 0.7]), "contacts/normal: row 6: must have length 1"),
    (put("contacts/arms", (1, 1), 0.9), "contacts/arms: row 1: must be the same fraction of both radii"),
    (put("contacts/roll_radius", 1, 0.9), "contacts/roll_radius: row 1"),
    (put("contacts/normal_bias", 1, np.inf), "contacts/normal_bias: row 1: must be finite"),
    (put("contacts/impulse", (1, 2), np.nan), "contacts/impulse: row 1: must be finite"),
    (put("bodies/mass", 0, 0.0), "bodies/mass: row 0: must be > 0"),
    (put("bodies/inertia", 2, 1.0), "bodies/inertia: row 2: must be mass radius^2 / 2"),
    (put("bodies/radius", 2, -1.0), "bodies/radius: row 2"),
    (put("bodies/free_velocity", (2, 1), np.nan), "bodies/free_velocity: row 2: must be finite"),
    (remove("contacts/normal"), "contacts/normal: no such dataset"),
    (shorten, "contacts/friction"),
    (lambda file: file.attrs.modify("velocity_scale", 0.0), "velocity_scale: must be > 0"),
    (lambda file: file.attrs.modify("format", np.bytes_("other")), "is no contact problem"),
    (lambda file: file.attrs.modify("format_version", 7), "is no contact problem of this version"),
]


def test_bad_problems_are_refused(bed):
    for change, message in BAD:
        bad = planted(bed, change)
        bed.refused("solve", bad, "--out", "nothing.h5", parts=[message])


def test_all_mistakes_are_reported_at_once(bed):
    def change(file):
        file["contacts/friction"][2:5] = -1
        file["contacts/normal"][7] = [2, 0]
        file["bodies/mass"][1] = -3

    said = bed.refused("solve", planted(bed, change), parts=["contacts/friction: row 2 (and 2 more rows)"])
    assert "contacts/normal: row 7" in said and "bodies/mass: row 1" in said


def test_damage_and_other_files_are_refused(bed):
    content = bytearray((bed.path / PROBLEM).read_bytes())
    content[-100] ^= 1
    (bed.path / "damaged.h5").write_bytes(content)
    (bed.path / "text.h5").write_text("no problem\n" * 100)
    bed.refused("solve", "damaged.h5", parts=["damaged"])
    bed.refused("solve", "text.h5", parts=["text.h5", "not an HDF5 file"])
    bed.refused("solve", "nowhere.h5", parts=["no such file"])
    bed.refused("solve", "out/run.h5", parts=["is no contact problem"])


def test_no_file_is_replaced_without_overwrite(bed):
    (bed.path / "kept.txt").write_text("kept")
    bed.refused("solve", PROBLEM, "--out", "kept.txt", parts=["already exists"])
    bed.refused("solve", PROBLEM, "--out", PROBLEM, "--overwrite", parts=["is the problem itself"])
    bed.refused("solve", PROBLEM, "--out", "nowhere/answer.h5", parts=["no such folder"])
    bed.refused("solve", PROBLEM, "--tolerance", "-1", parts=["--tolerance"])
    assert (bed.path / "kept.txt").read_text() == "kept"


def test_a_missed_tolerance_is_reported(bed):
    result = bed("solve", PROBLEM, "--tolerance", "1e-6", "--most-sweeps", "2")
    assert result.returncode == 0 and "was not reached in 2 sweeps" in result.stderr
    assert "residual" in result.stdout and "sweeps              2" in result.stdout


def test_runs_without_a_problem_are_refused(lab, heap):
    result = lab("export", heap, "--to", "contact-problem", "--out", "out")
    assert result.returncode == 2 and "only contact-dynamics has one" in result.stderr
    assert not everything_in(lab.path)
    scene = (BOX % ("1e-7", 0.5)).replace("point = [4.6, 0]", "motion = 'velocity'\nvelocity = [0.01, 0]\npoint = [4.6, 0]", 1)
    lab.run(scene + "[[load]]\ngrain = 3\nforce = [0, -1]\n", out="moving")
    lab.refused("export", "moving", "--to", "contact-problem", parts=["a wall moves", "has loads"])


def test_siconos_solves_the_same_problem(bed):
    pytest.importorskip("siconos")
    pytest.importorskip("scipy")
    from siconos_solve import Nsgs

    if bed.problem.rolling_friction.any():
        with pytest.raises(ValueError):
            Nsgs(bed.problem)
        return
    nsgs = Nsgs(bed.problem)
    nsgs.solve(1e-4, seconds=600)
    assert nsgs.residual() <= 1e-4 and nsgs.iterations > 10
