# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Calibrations through the program: results, stops of every kind, bad input. python/tests tests the statistics."""

import json
import random
import signal
import subprocess
import time
from pathlib import Path

import pytest
from conftest import HEAP, LIMIT, PROGRAM, Laboratory, assert_plain, everything_in

pytest.importorskip("scipy")
pytest.importorskip("sklearn")

CALIBRATION = """title = "small heaps"
scene = "heap.toml"
seeds = 2
[set]
output.frames = 0
[[parameter]]
key = "contact.friction"
range = [0.05, 0.8]
[[target]]
measure = "coordination"
value = 3.9
error = 0.05
[design]
start = 4
batch = 2
most = 6
stop = 0.05
"""
RESULTS = ("calibration.json", "posterior.csv", "points.csv")


def prepared(lab, text=CALIBRATION):
    lab.scene(HEAP.replace("count = 40", "count = 20"), "heap.toml")
    lab.scene(text, "c.toml")
    return lab


@pytest.fixture
def small(lab):
    return prepared(lab)


def calibrate(lab, *options, expect=0):
    result = lab("calibrate", "c.toml", "--out", "out", *options)
    assert result.returncode == expect, result.stderr + result.stdout
    return result


def results(lab):
    return {name: (lab.path / "out" / name).read_bytes() for name in RESULTS}


@pytest.fixture(scope="session")
def whole(tmp_path_factory):
    """A calibration without stops, its output and the seconds that it took."""
    lab = prepared(Laboratory(tmp_path_factory.mktemp("whole")))
    begin = time.monotonic()
    lab.said = calibrate(lab).stdout
    lab.seconds = time.monotonic() - begin
    return lab


def test_a_calibration_writes_its_results(whole):
    content = json.loads(results(whole)["calibration.json"])
    assert [entry["points"] for entry in content["rounds"]] == [4, 2] and content["stopped"] == "most"
    (parameter,) = content["posterior"]["parameters"]
    assert 0.05 <= parameter["low"] < parameter["median"] < parameter["high"] <= 0.8
    assert content["targets"][0]["predicted"] == pytest.approx(3.9, abs=0.1)
    assert all(point["targets"]["coordination"]["members"] == 2 for point in content["points"])
    assert len(results(whole)["posterior.csv"].splitlines()) == 4001
    assert len(results(whole)["points.csv"].splitlines()) == 7
    for kind in ("png", "svg"):
        assert (whole.path / f"out/pictures/calibration.{kind}").stat().st_size > 10_000
    assert "contact.friction" in whole.said and "90 % interval" in whole.said and "round 2: 6 points" in whole.said


# Each round has seeds of its own: no two members are the same run.
def test_members_are_independent(whole):
    folders = sorted(path.name for path in whole.path.glob("out/rounds/0?/members/p*/seed-*"))
    assert sorted(set(folders)) == [f"seed-{k}" for k in range(1, 5)] and len(folders) == 12
    assert sorted({path.name for path in whole.path.glob("out/rounds/0?/members/p*")})[-1] == "p006"


def test_a_finished_calibration_runs_no_member_again(whole):
    members = sorted(whole.path.glob("out/rounds/*/members/*/*/run.h5"))
    before, files = [path.stat().st_mtime_ns for path in members], results(whole)
    calibrate(whole, "--quiet")
    assert [path.stat().st_mtime_ns for path in members] == before and results(whole) == files


@pytest.mark.parametrize("stop", [signal.SIGKILL, signal.SIGTERM])
def test_stops_do_not_change_a_bit(small, whole, stop):
    words = [PROGRAM, "calibrate", "c.toml", "--out", "out", "--quiet", "--threads", "1"]
    after = random.uniform(0.2, 1.0) * whole.seconds
    process = subprocess.Popen(words, cwd=small.path, stderr=subprocess.PIPE, text=True)
    try:
        process.wait(after)
    except subprocess.TimeoutExpired:
        process.send_signal(stop)
    said = process.communicate(timeout=LIMIT)[1]
    assert process.returncode in (0, -9, -15, 130) and said == "", (process.returncode, said)
    calibrate(small, "--quiet")
    assert results(small) == results(whole), f"{stop!r} after {after} s"


def test_two_programs_do_not_calibrate_in_one_folder(small):
    words = [PROGRAM, "calibrate", "c.toml", "--out", "out", "--quiet"]
    first = subprocess.Popen(words, cwd=small.path)
    end = time.monotonic() + LIMIT
    while not (small.path / "out/rounds/01.toml").exists() and time.monotonic() < end:
        time.sleep(0.01)
    second = small("calibrate", "c.toml", "--out", "out")
    first.terminate()
    first.wait(LIMIT)
    assert second.returncode == 2 and second.stderr == "out: another program calibrates here\n"


def test_check_describes_and_writes_nothing(small):
    before = everything_in(small.path)
    said = calibrate(small, "--check").stdout
    assert "contact.friction: 0.05 to 0.8, uniform" in said and "4 points with 2 seeds each" in said
    assert everything_in(small.path) == before


def test_another_file_needs_another_folder(small):
    (small.path / "out").mkdir()
    (small.path / "out/precious.txt").write_text("mine")
    small.refused("calibrate", "c.toml", "--out", "out", parts=["out: folder is not empty and holds no calibration"])
    (small.path / "out/precious.txt").rename(small.path / "out/calibration.toml")
    small.refused("calibrate", "c.toml", "--out", "out", parts=["out: was made from another calibration file"])
    small.scene("nothing", "out/points.csv")
    small.scene(CALIBRATION.replace("most = 6", "most = 4").replace("value = 3.9", "value = 4.0"), "c.toml")
    calibrate(small, "--overwrite", "--quiet")
    assert (small.path / "out/points.csv").read_text().startswith("point,round,contact.friction")


@pytest.mark.parametrize("old, new, message", [
    ("seeds = 2", "seeds = 1", "c.toml: seeds = 1: must be a whole number from 2 to 1000"),
    ("error = 0.05", "error = 0", "c.toml: target[0].error = 0: must be a number > 0"),
    ("contact.friction", "contact.frictoin", "c.toml: contact.frictoin: unknown key; known here:"),
    ("[0.05, 0.8]", "[-0.1, 0.8]", "c.toml: contact.friction = -0.1: must be >= 0"),
    ("output.frames = 0", "output.frames = -1", "c.toml: output.frames = -1: must be"),
    ("heap.toml", "nothing.toml", "nothing.toml: cannot read: No such file"),
    ("contact.friction", "source.count", "source.count = 0.05: must be"),
    ("title", "title = 1 2", "c.toml: "),
])  # fmt: skip
def test_bad_files_are_refused(small, old, new, message):
    assert old in CALIBRATION
    small.scene(CALIBRATION.replace(old, new, 1), "c.toml")
    said = small.refused("calibrate", "c.toml", "--out", "out", *(["--check"] if len(old) % 2 else []), parts=[message])
    assert_plain(said)
    assert len(said.splitlines()) == len(set(said.splitlines())) and "round.toml" not in said


def test_all_problems_of_a_file_are_named(small):
    small.scene(CALIBRATION.replace("seeds = 2", "seeds = 0").replace("error = 0.05", ""), "c.toml")
    said = small.refused("calibrate", "c.toml", parts=["seeds = 0", "target[0].error: missing"])
    assert len(said.splitlines()) == 2
    small.refused("calibrate", "gone.toml", parts=["gone.toml: cannot read: No such file"])


def test_a_measure_that_no_member_has_is_named(small):
    small.scene(CALIBRATION.replace('"coordination"', '"coordinatoin"'), "c.toml")
    said = calibrate(small, "--quiet", expect=2).stderr
    assert said.startswith('c.toml: target[0].measure = "coordinatoin": no member has it; they have ')
    assert len(said.splitlines()) == 1


def test_missing_packages_are_named(small):
    (small.path / "without").mkdir()
    small.scene('raise ImportError("No module named sklearn")\n', "without/sklearn.py")
    result = small.shell('"$REPOSE" calibrate c.toml', PYTHONPATH=str(small.path / "without"))
    assert result.returncode == 1
    words = "repose calibrate: needs the Debian packages python3-scipy and python3-sklearn: No module named sklearn\n"
    assert result.stderr == words


EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


@pytest.mark.parametrize("path", sorted((EXAMPLES / "calibrations").glob("*.toml")), ids=lambda path: path.name)
def test_the_calibrations_among_the_examples_are_sound(lab, path):
    result = lab("calibrate", path, "--check")
    assert result.returncode == 0, result.stderr
