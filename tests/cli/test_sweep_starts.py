# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Points of a sweep that start from the ends of another point's members, and scenes that start from a file."""

import shutil

import h5py
import numpy as np
import pytest
from conftest import HEAP, summary
from test_sweep import contents, rows_of, run_sweep

AFTER = """[contact.normal]
law = "hooke"
[stop]
at_rest = 1e-6
time = 200
"""
SWEEP = """scene = "heap.toml"
seeds = 2
[set]
source.count = 30
base.half_width = 7
output.window = 5.0
[vary]
contact.friction = [0.4, 0.5]
[[point]]
name = "poured"
[[point]]
name = "springs"
scene = "after.toml"
starts_from = "poured"
set = { start.at_rest = true }
[[point]]
name = "cold"
scene = "after.toml"
starts_from = "springs"
[[claim]]
text = "no grain appears or is lost"
measure = "grains"
difference = ["springs_friction=0.5", "poured_friction=0.5"]
above = -0.1
below = 0.1
"""


@pytest.fixture
def sweep(lab):
    lab.scene(HEAP, "heap.toml")
    lab.scene(AFTER, "after.toml")
    lab.scene(SWEEP, "sweep.toml")
    return lab


def places(folder):
    with h5py.File(folder / "run.h5", "r") as file:
        return file["grains/id"][()], file["grains/position"][()]


def test_members_start_where_those_of_the_other_point_ended(sweep):
    run_sweep(sweep)
    members = sweep.path / "out/members"
    for friction in (0.4, 0.5):
        for seed in (1, 2):
            first = members / f"poured_friction={friction}/seed-{seed}"
            member = members / f"springs_friction={friction}/seed-{seed}"
            alone = f"alone-{friction}-{seed}"
            result = sweep("run", "after.toml", "--out", alone, "--quiet", "--seed", str(seed), "--set",
                           f"start.from={first}", "--set", "start.at_rest=true", "--set", "output.window=5.0",
                           "--set", f"contact.friction={friction}")
            assert result.returncode == 0, result.stderr
            for a, b in zip(places(member), places(sweep.path / alone)):
                assert a.tobytes() == b.tobytes()
            ids, moved = places(member)
            start_ids, start = places(first)
            assert np.array_equal(ids, start_ids) and 0 < np.abs(moved - start).max() < 1
            assert summary(first)["grains_released"] == 30 and (member / "start.h5").exists()
    assert [row["finished"] for row in rows_of(sweep.path / "out/table.csv")] == ["2"] * 6
    assert rows_of(sweep.path / "out/claims.csv")[0]["verdict"] == "agrees"


def test_stopped_anywhere_it_resumes_to_the_same_tables(sweep):
    run_sweep(sweep, "--threads", "3")
    before = contents(sweep.path / "out")
    shutil.rmtree(sweep.path / "out/members/springs_friction=0.4/seed-2")
    (sweep.path / "out/members/poured_friction=0.5/seed-1/summary.json").unlink()
    sweep.path.joinpath("heap.toml").unlink()
    result = sweep("sweep", "out/sweep.toml", "--threads", "1")
    assert result.returncode == 0, result.stderr
    assert "10 members have already ended" in result.stdout
    assert contents(sweep.path / "out") == before


def test_a_member_whose_start_failed_fails_too(sweep):
    # A source so low and narrow that its own heap reaches it.
    sweep.scene(HEAP.replace("height = 10", "height = 3").replace("half_width = 2", "half_width = 0"), "heap.toml")
    sweep.scene(SWEEP.replace("source.count = 30", "source.count = 100"), "sweep.toml")
    result = run_sweep(sweep, expect=1)
    assert "poured_friction=0.4 seed 1: failed: the source is buried" in result.stderr
    for point in ("springs", "cold"):
        assert f"{point}_friction=0.4 seed 1: failed: the member that it starts from failed" in result.stderr
    rows = rows_of(sweep.path / "out/table.csv")
    assert [(row["finished"], row["failed"]) for row in rows] == [("0", "2")] * 2 + [("0", "0")] * 4


def test_a_start_that_does_not_suit_fails_the_member_alone(sweep):
    sweep.scene(AFTER + "[box]\nhalf_width = 2\n", "after.toml")
    result = run_sweep(sweep, expect=1)
    assert "springs_friction=0.4 seed 1: failed:" in result.stderr and "of its grains lie outside the box" in result.stderr
    assert [row["finished"] for row in rows_of(sweep.path / "out/table.csv")] == ["2"] * 2 + ["0"] * 4


@pytest.mark.parametrize(
    "change, parts",
    [
        (('starts_from = "poured"', 'starts_from = "sieved"'),
         ['sweep.toml:14: point[1].starts_from = "sieved": no such point before this one']),
        (('starts_from = "poured"', 'starts_from = "cold"'), ['"cold": no such point before this one']),
        (('starts_from = "poured"', "starts_from = 1"), ["point[1].starts_from = 1: must be text"]),
        (("start.at_rest = true", "start.from = 'x'"), ["point[1].set.start.from: goes into a scene"]),
        (("contact.friction = [0.4, 0.5]", "start.from = ['a', 'b']"), ["vary.start.from: goes into a scene"]),
        (("start.at_rest = true", "base = { kind = 'row', half_width = 7 }"),
         ['base.kind = "row": the grains of start.from bring their base']),
    ],
)
def test_bad_starts_are_refused_before_anything_runs(sweep, change, parts):
    assert change[0] in SWEEP
    sweep.scene(SWEEP.replace(*change, 1), "sweep.toml")
    sweep.refused("sweep", "sweep.toml", "--out", "out", parts=parts)


def test_the_folder_has_the_file_that_its_scene_starts_from(sweep):
    result = sweep("run", "heap.toml", "--out", "heap", "--quiet")
    assert result.returncode == 0, result.stderr
    sweep.scene("[start]\nfrom = 'heap'  # a run\n" + AFTER, "after.toml")
    sweep.scene("scene = 'after.toml'\nseeds = 2\n[vary]\ncontact.friction = [0.3, 0.5]\n", "sweep.toml")
    run_sweep(sweep)
    kept = (sweep.path / "out/scenes/after.toml").read_text()
    assert kept.startswith('[start]\nfrom = "after-start.h5"  # a run\n')
    table = (sweep.path / "out/table.csv").read_bytes()
    shutil.rmtree(sweep.path / "heap")
    (sweep.path / "after.toml").unlink()
    (sweep.path / "out").rename(sweep.path / "moved")
    shutil.rmtree(sweep.path / "moved/members/friction=0.3/seed-2")
    result = sweep("sweep", "moved/sweep.toml")
    assert result.returncode == 0 and "3 members have already ended" in result.stdout, result.stderr
    assert (sweep.path / "moved/table.csv").read_bytes() == table
