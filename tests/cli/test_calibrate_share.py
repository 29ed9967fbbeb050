# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Several programs that share a calibration: kills, signals, folders, bad options."""

import random
import signal
import subprocess
import time

import pytest
from conftest import LIMIT, PROGRAM, everything_in
from interruption import paused
from test_calibrate import CALIBRATION, calibrate, results, small, whole  # noqa: F401  # fixtures

pytest.importorskip("scipy")
pytest.importorskip("sklearn")


def worker(lab, part, of=2):
    words = ["calibrate", "c.toml", "--out", "out", "--share", f"{part}/{of}", "--lease", "1.5", "--threads", "1"]
    return subprocess.Popen([PROGRAM, *words], cwd=lab.path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def finish(*workers):
    """What the workers print."""
    said = [process.communicate(timeout=LIMIT)[0] for process in workers]
    assert [process.returncode for process in workers] == [0] * len(workers), "".join(said)
    return said


def wait_for(condition):
    end = time.monotonic() + LIMIT
    while not condition():
        assert time.monotonic() < end, "it never came"
        time.sleep(0.01)


def ended(lab):
    return len(list(lab.path.glob("out/rounds/*/members/*/*/summary.json")))


def clean(lab):
    """No lease and no half-written file of programs that have ended well."""
    return not list(lab.path.glob("out/rounds/*/leases/*")) and not list(lab.path.glob("out/.*"))


def test_two_programs_equal_one(small, whole):  # noqa: F811
    said = finish(worker(small, 1), worker(small, 2))
    assert results(small) == results(whole) and clean(small)
    assert all("round 2: 6 points" in text and "90 % interval" in text for text in said)
    assert ended(small) == ended(whole) == 12
    for name in ("rounds/01/sweep.h5", "rounds/02/sweep.h5", "pictures/calibration.png", "pictures/calibration.svg"):
        assert (small.path / "out" / name).read_bytes() == (whole.path / "out" / name).read_bytes(), name


@pytest.mark.parametrize("stop", [signal.SIGKILL, signal.SIGTERM, signal.SIGUSR1])
def test_a_program_that_is_stopped_and_starts_again_changes_no_bit(small, whole, stop):  # noqa: F811
    workers = [worker(small, 1), worker(small, 2)]
    after = random.uniform(0.0, 1.0) * whole.seconds
    wait_for(lambda: (small.path / "out/calibration.toml").exists())
    victim = random.randrange(2)
    try:
        workers[victim].communicate(timeout=after)
    except subprocess.TimeoutExpired:
        workers[victim].send_signal(stop)
        workers[victim].communicate(timeout=LIMIT)
    assert workers[victim].returncode in (0, 130, -stop)
    workers[victim] = worker(small, victim + 1)
    finish(*workers)
    assert results(small) == results(whole), f"{stop!r} of part {victim + 1} after {after} s"
    assert not list(small.path.glob("out/rounds/*/leases/*"))


def test_the_rest_finish_without_one_that_was_killed(small, whole):  # noqa: F811
    workers = [worker(small, 1), worker(small, 2)]
    wait_for(lambda: ended(small) >= 2)
    workers[0].kill()
    workers[0].communicate()
    finish(workers[1])
    assert results(small) == results(whole)


def test_a_part_continues_what_one_program_began_and_the_other_way_round(small, whole):  # noqa: F811
    words = [PROGRAM, "calibrate", "c.toml", "--out", "out", "--quiet", "--threads", "1"]
    alone = subprocess.Popen(words, cwd=small.path)
    wait_for(lambda: ended(small) >= 1)
    with paused(alone):
        refused = small("calibrate", "c.toml", "--out", "out", "--share", "1/2")
    assert refused.returncode == 2 and refused.stderr == "out: another program calibrates here\n"
    alone.terminate()
    alone.wait(LIMIT)
    part = worker(small, 1)
    wait_for(lambda: ended(small) >= 9)  # in the second round
    with paused(part):
        refused = small("calibrate", "c.toml", "--out", "out")
    assert refused.returncode == 2 and refused.stderr == "out: another program calibrates here\n"
    part.terminate()
    part.communicate(timeout=LIMIT)
    calibrate(small, "--quiet")
    assert results(small) == results(whole)


def test_parts_have_one_file(small):  # noqa: F811
    process = worker(small, 1)
    wait_for(lambda: (small.path / "out/calibration.toml").exists())
    small.scene(CALIBRATION.replace("most = 6", "most = 8"), "other.toml")
    refused = small("calibrate", "other.toml", "--out", "out", "--share", "2/2")
    assert refused.returncode == 2 and "out: was made from another calibration file" in refused.stderr
    process.terminate()
    process.communicate(timeout=LIMIT)


def test_check_of_a_part_writes_nothing(small):  # noqa: F811
    before = everything_in(small.path)
    assert "4 points with 2 seeds each" in calibrate(small, "--share", "1/2", "--check").stdout
    assert everything_in(small.path) == before


@pytest.mark.parametrize("options, message", [
    (["--share", "3/2"], "--share 3/2: must be I/N"),
    (["--share", "half"], "--share half: must be I/N"),
    (["--share", "1/2", "--overwrite"], "--overwrite: one of several that share a calibration cannot remove it"),
    (["--share", "1/2", "--lease", "0"], "--lease"),
])  # fmt: skip
def test_bad_shares_are_refused(small, options, message):  # noqa: F811
    small.refused("calibrate", "c.toml", "--out", "out", *options, parts=[message])
