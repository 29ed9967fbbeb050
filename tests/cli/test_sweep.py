# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps through the program: tables against the members' own summaries, kills, failed members, bad input."""

import csv
import io
import os
import random
import signal
import subprocess
import time
from pathlib import Path

import h5py
import numpy as np
import pytest
from conftest import HEAP, PROGRAM, summary

SWEEP = """title = "friction"
scene = "heap.toml"
seeds = 3
[vary]
contact.friction = [0.2, 0.5]
[[claim]]
text = "steeper with friction"
measure = "angle_of_repose_deg.mean"
difference = ["friction=0.5", "friction=0.2"]
above = 0
"""
TABLES = ("table.csv", "members.csv", "claims.csv", "claims.json", "sweep.h5")
ANGLE = "angle_of_repose_deg.mean"


@pytest.fixture
def sweep(lab):
    """A folder with a sweep of six small heaps."""
    lab.scene(HEAP, "heap.toml")
    lab.scene(SWEEP, "sweep.toml")
    return lab


def rows_of(path):
    return list(csv.DictReader(io.StringIO(path.read_text())))


def contents(folder):
    return {name: (folder / name).read_bytes() for name in TABLES}


def run_sweep(lab, *options, out="out", expect=0):
    result = lab("sweep", "sweep.toml", "--out", out, *options)
    assert result.returncode == expect, result.stderr + result.stdout
    return result


def test_table_is_mean_and_error_of_the_members(sweep):
    run_sweep(sweep)
    table = {row["point"]: row for row in rows_of(sweep.path / "out/table.csv")}
    assert list(table) == ["friction=0.2", "friction=0.5"]
    for point, row in table.items():
        members = [summary(sweep.path / f"out/members/{point}/seed-{seed}") for seed in (1, 2, 3)]
        assert [member["seed"] for member in members] == [1, 2, 3]
        angles = [member["angle_of_repose_deg"]["mean"] for member in members]
        assert row["contact.friction"] == point.split("=")[1] and row["finished"] == "3" and row["failed"] == "0"
        assert float(row[ANGLE]) == pytest.approx(np.mean(angles), rel=1e-14)
        assert float(row[f"{ANGLE}:deviation"]) == pytest.approx(np.std(angles, ddof=1), rel=1e-13)
        assert float(row[f"{ANGLE}:error"]) == pytest.approx(np.std(angles, ddof=1) / np.sqrt(3), rel=1e-13)
        assert row[f"{ANGLE}:count"] == "3"


def test_ensemble_profile_is_the_mean_of_the_members_profiles(sweep):
    run_sweep(sweep)
    members = [summary(sweep.path / f"out/members/friction=0.5/seed-{seed}")["base_profile"] for seed in (1, 2, 3)]
    normal = np.array([member["normal"] for member in members])
    with h5py.File(sweep.path / "out/sweep.h5", "r") as file:
        assert list(file["points/name"].asstr()) == ["friction=0.2", "friction=0.5"]
        profile = file["profiles/0001"]
        np.testing.assert_allclose(profile["normal"][()], normal.mean(axis=0), rtol=1e-13, atol=1e-15)
        error = normal.std(axis=0, ddof=1) / np.sqrt(3)
        np.testing.assert_allclose(profile["normal_error"][()], error, rtol=1e-12, atol=1e-15)
        assert profile.attrs["members"] == 3
        assert file["values"][ANGLE].shape == (6,)


def test_a_member_equals_a_run_of_its_scene(sweep):
    run_sweep(sweep)
    member = sweep.path / "out/members/friction=0.5/seed-2"
    again = sweep("run", str(member / "scene.toml"), "--out", "again", "--quiet")
    assert again.returncode == 0, again.stderr
    with h5py.File(member / "run.h5", "r") as a, h5py.File(sweep.path / "again/run.h5", "r") as b:
        for name in ("position", "velocity", "spin"):
            assert a[f"grains/{name}"][()].tobytes() == b[f"grains/{name}"][()].tobytes()


def test_the_tables_do_not_depend_on_the_number_of_parallel_members(sweep):
    run_sweep(sweep, "--threads", "1", out="one")
    run_sweep(sweep, "--threads", "3", out="three")
    assert contents(sweep.path / "one") == contents(sweep.path / "three")


def test_killed_at_ten_random_moments_the_table_is_the_same(sweep):
    started = time.monotonic()
    run_sweep(sweep, out="whole")
    duration = time.monotonic() - started
    whole = contents(sweep.path / "whole")
    rng = random.Random(1)
    kills = 0
    for attempt in range(10):
        process = subprocess.Popen(
            [PROGRAM, "sweep", "sweep.toml", "--out", "killed", "--quiet"], cwd=sweep.path, start_new_session=True
        )
        try:
            process.wait(rng.uniform(0.02, 0.12 * duration))
        except subprocess.TimeoutExpired:
            os.kill(process.pid, signal.SIGKILL)
            process.wait()
            kills += 1
    assert kills >= 4, "the sweep was over before it could be killed"
    run_sweep(sweep, "--quiet", out="killed")
    assert contents(sweep.path / "killed") == whole


@pytest.mark.parametrize("track_is_sound", [True, False])
def test_a_killed_member_resumes_from_its_checkpoint(sweep, track_is_sound):
    """Existing frames are not written again, unless the member must restart because a part of it is damaged."""
    sweep.scene(HEAP.replace("count = 40", "count = 200") + "[output]\ntrack = 1\nframes = 10\ncheckpoint = 1e-3\n",
                "heap.toml")
    sweep.scene(SWEEP.replace("seeds = 3", "seeds = 1"), "sweep.toml")
    run_sweep(sweep, "--quiet", out="whole")
    process = subprocess.Popen([PROGRAM, "sweep", "sweep.toml", "--out", "cut", "--quiet", "--threads", "1"],
                               cwd=sweep.path)
    member = sweep.path / "cut/members/friction=0.2/seed-1"
    while not ((member / "frames/000003.h5").exists() and (member / "checkpoints/1.h5").exists()):
        assert process.poll() is None, "the sweep was over before it could be killed"
        time.sleep(0.005)
    process.kill()
    process.wait()
    first = member / "frames/000000.h5"
    written = first.stat().st_mtime_ns
    if not track_is_sound:
        for segment in member.glob("track/*.h5"):
            segment.write_bytes(segment.read_bytes()[:-1])
    run_sweep(sweep, "--quiet", out="cut")
    assert contents(sweep.path / "cut") == contents(sweep.path / "whole")
    assert (first.stat().st_mtime_ns == written) == track_is_sound


def test_a_finished_member_is_not_run_again(sweep):
    run_sweep(sweep)
    marks = {path: path.stat().st_mtime_ns for path in sweep.path.glob("out/members/*/*/run.h5")}
    assert len(marks) == 6
    removed = sweep.path / "out/members/friction=0.2/seed-3/summary.json"
    removed.unlink()
    before = contents(sweep.path / "out")
    assert "5 members have already ended" in run_sweep(sweep).stdout
    changed = [path for path, mark in marks.items() if path.stat().st_mtime_ns != mark]
    assert changed == [removed.parent / "run.h5"]
    assert contents(sweep.path / "out") == before


def test_the_folder_alone_is_enough_to_resume(sweep):
    run_sweep(sweep)
    before = contents(sweep.path / "out")
    sweep.path.joinpath("heap.toml").unlink()
    result = sweep("sweep", "out/sweep.toml")
    assert result.returncode == 0, result.stderr
    assert "6 members have already ended" in result.stdout
    assert contents(sweep.path / "out") == before


def test_paths_in_other_quotation_marks_and_comments_are_kept(sweep):
    sweep.scene("# mine\n" + SWEEP.replace('"heap.toml"', "'heap.toml'").replace("seeds = 3", "seeds = 1"), "sweep.toml")
    run_sweep(sweep)
    kept = (sweep.path / "out/sweep.toml").read_text()
    assert kept.startswith("# mine\n") and 'scene = "scenes/heap.toml"' in kept
    assert (sweep.path / "out/scenes/heap.toml").read_text() == HEAP


def test_a_failed_member_is_reported_and_does_not_stop_the_others(sweep):
    # A source so low and narrow that its own heap reaches it.
    sweep.scene(HEAP.replace("height = 10", "height = 3").replace("half_width = 2", "half_width = 0"), "low.toml")
    points = "".join(f"[[point]]\nname = '{name}'\nscene = '{name}.toml'\n" for name in ("heap", "low"))
    sweep.scene(f"seeds = 3\nset = {{ source.count = 100 }}\n{points}", "sweep.toml")
    result = run_sweep(sweep, expect=1)
    for seed in (1, 2, 3):
        assert f"low seed {seed}: failed: the source is buried" in result.stderr
    rows = {row["point"]: row for row in rows_of(sweep.path / "out/table.csv")}
    assert (rows["heap"]["finished"], rows["heap"]["failed"]) == ("3", "0")
    assert (rows["low"]["finished"], rows["low"]["failed"]) == ("0", "3")
    assert rows["low"][ANGLE] == "" and float(rows["heap"][ANGLE]) > 0
    assert "6 members have already ended" in run_sweep(sweep, expect=1).stdout


def test_ctrl_c_ends_in_good_order_and_the_sweep_resumes(sweep):
    sweep.scene(SWEEP.replace("seeds = 3", "seeds = 40"), "sweep.toml")
    process = subprocess.Popen([PROGRAM, "sweep", "sweep.toml", "--out", "out"], cwd=sweep.path, stdout=subprocess.PIPE)
    for line in process.stdout:
        if b"finished in" in line:
            break
    process.send_signal(signal.SIGINT)
    process.stdout.read()
    assert process.wait(20) == 130
    finished = sum(int(row["finished"]) for row in rows_of(sweep.path / "out/table.csv"))
    assert 1 <= finished < 80
    assert f"{finished} members have already ended" in run_sweep(sweep).stdout


def test_points_with_scenes_of_their_own(sweep):
    sweep.scene(HEAP + "[contact.normal]\nlaw = 'hooke'\n", "springs.toml")
    sweep.scene(
        """seeds = [7]
[vary]
contact.friction = [0.3, 0.5]
[[point]]
name = "soft"
scene = "heap.toml"
[[point]]
name = "springs"
scene = "springs.toml"
set = { source.count = 20 }
""",
        "sweep.toml",
    )
    run_sweep(sweep)
    names = [row["point"] for row in rows_of(sweep.path / "out/table.csv")]
    assert names == [f"{law}_friction={mu}" for law in ("soft", "springs") for mu in (0.3, 0.5)]
    assert summary(sweep.path / "out/members/springs_friction=0.3/seed-7")["grains_released"] == 20


def test_analyse_of_a_sweep_makes_the_same_tables(sweep):
    run_sweep(sweep)
    before = contents(sweep.path / "out")
    for name in TABLES:
        (sweep.path / "out" / name).unlink()
    result = sweep("analyse", "out")
    assert result.returncode == 0, result.stderr
    assert contents(sweep.path / "out") == before


@pytest.mark.parametrize(
    "change, parts",
    [
        (("seeds = 3", "seeds = 0"), ["sweep.toml:3: seeds = 0: must be a whole number from 1"]),
        (("seeds = 3", "seeds = [1, 1]"), ["sweep.toml:3: seeds: 1: is listed twice"]),
        (("seeds = 3", ""), ["seeds: missing"]),
        (("seeds = 3", "sedes = 3"), ["sedes: unknown key; known here:"]),
        (('scene = "heap.toml"', 'scene = "nothing.toml"'), ["nothing.toml: cannot read: No such file"]),
        (('scene = "heap.toml"', "scene = 3"), ["sweep.toml:2: scene = 3: must be text"]),
        (("[0.2, 0.5]", "0.2"), ["sweep.toml:5: vary.contact.friction = 0.2: must be a list of values"]),
        (("[0.2, 0.5]", "[0.2, -0.5]"), ["sweep.toml:5: contact.friction = -0.5: must be >= 0"]),
        (("contact.friction", "contact.frictoin"), ["sweep.toml:5: contact.frictoin: unknown key; known here:"]),
        (("[0.2, 0.5]", "[0.2, 0.2]"), ['two points have the name "friction=0.2"']),
        (("contact.friction = [", "seed = ["), ["sweep.toml:5: vary.seed: the sweep sets it; use seeds"]),
        (("above = 0", ""), ["sweep.toml:6: claim[0].above: give above, below or both"]),
        (("above = 0", 'above = "0"'), ['sweep.toml:10: claim[0].above = "0": must be a finite number']),
        (('["friction=0.5", "friction=0.2"]', '["friction=0.5", "friction=0.9"]'),
         ['no point "friction=0.9"; there are friction=0.2, friction=0.5']),
        (("difference", "point = 'friction=0.5'\ndifference"), ["give one of point, difference, equivalent and fit"]),
        (("above = 0", "above = 0\nmargin = 1"), ["claim[0].margin: goes with equivalent only; give above and below"]),
        (("difference", "equivalent"), ["claim[0].margin: an equivalence has a margin", "claim[0].margin: missing"]),
        (("above = 0", "margin = 0"), ["claim[0].margin: goes with equivalent only", "claim[0].above: give above, below"]),
        (("difference", "spread"), ['claim[0].spread: is judged as an equivalence now: write "equivalent" instead']),
        (("title", "title = 1 2"), ["sweep.toml:1:"]),
    ],
)
def test_bad_sweeps_are_refused(sweep, change, parts):
    assert change[0] in SWEEP
    sweep.scene(SWEEP.replace(*change, 1), "sweep.toml")
    sweep.refused("sweep", "sweep.toml", "--out", "out", parts=parts)


def test_all_problems_at_once(sweep):
    sweep.scene(SWEEP.replace("seeds = 3", "seeds = 0").replace("0.2, 0.5", "-0.2, -0.5"), "sweep.toml")
    message = sweep.refused("sweep", "sweep.toml", parts=["seeds = 0", "= -0.2: must be", "= -0.5: must be"])
    assert len(message.splitlines()) == len(set(message.splitlines()))


def test_a_folder_with_other_files_is_not_changed(sweep):
    (sweep.path / "out").mkdir()
    (sweep.path / "out/precious.txt").write_text("mine")
    sweep.refused("sweep", "sweep.toml", "--out", "out", parts=["out: folder is not empty and holds no sweep"])
    sweep.refused("sweep", "sweep.toml", "--out", "out", "--overwrite", parts=["holds no sweep"])


def test_members_of_another_scene_are_not_mixed_in(sweep):
    run_sweep(sweep)
    sweep.scene(HEAP.replace("count = 40", "count = 41"), "heap.toml")
    sweep.refused("sweep", "sweep.toml", "--out", "out", parts=["was made from another scene than this sweep's"])
    run_sweep(sweep, "--overwrite")
    assert summary(sweep.path / "out/members/friction=0.2/seed-1")["grains"] == 41


def test_more_seeds_add_members_to_a_finished_sweep(sweep):
    run_sweep(sweep)
    sweep.scene(SWEEP.replace("seeds = 3", "seeds = 4"), "sweep.toml")
    assert "6 members have already ended" in run_sweep(sweep).stdout
    assert [row["finished"] for row in rows_of(sweep.path / "out/table.csv")] == ["4", "4"]


def test_check_writes_no_file(sweep):
    result = sweep("sweep", "sweep.toml", "--out", "out", "--check")
    assert result.returncode == 0 and "2 points with 3 seeds each" in result.stdout
    assert not (sweep.path / "out").exists()


EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


@pytest.mark.parametrize("path", sorted((EXAMPLES / "sweeps").glob("*.toml")), ids=lambda path: path.name)
def test_the_sweeps_among_the_examples_are_sound(lab, path):
    result = lab("sweep", path, "--check")
    assert result.returncode == 0, result.stderr
