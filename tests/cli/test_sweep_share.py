# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Several programs that share a sweep: kills, leases of the dead and of the living, collecting, signals."""

import os
import random
import signal
import subprocess
import threading
import time

import pytest
from conftest import HEAP, PROGRAM
from interruption import paused
from test_sweep import SWEEP, contents, rows_of, run_sweep

MEMBERS = 10


def heap(count):
    changes = {"count = 40": f"count = {count}", "half_width = 8": "half_width = 20", "\nheight = 10": "\nheight = 30"}
    text = HEAP
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    return text


@pytest.fixture
def sweep(lab):
    """A folder with a sweep of ten heaps, some tenths of a second each."""
    lab.scene(heap(100), "heap.toml")
    lab.scene(SWEEP.replace("seeds = 3", f"seeds = {MEMBERS // 2}"), "sweep.toml")
    return lab


def worker(lab, part, of=4, *, out="shared", lease="1.5", threads="1"):
    return subprocess.Popen(
        [PROGRAM, "sweep", "sweep.toml", "--out", out, "--share", f"{part}/{of}", "--lease", lease, "--threads", threads],
        cwd=lab.path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def finish(*workers):
    for process in workers:
        text, _ = process.communicate(timeout=300)
        assert process.returncode == 0, text


def members_that_ended(lab, out="shared"):
    return sum('"status": "finished"' in path.read_text() for path in lab.path.glob(f"{out}/members/*/*/summary.json"))


def wait_for(condition, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "it never came"
        time.sleep(0.01)


def test_four_workers_with_kills_equal_one_sweep(sweep):
    run_sweep(sweep, out="single")
    draw = random.Random(5)
    workers = [worker(sweep, part) for part in (1, 2, 3, 4)]
    for victim in (1, 3):
        goal = members_that_ended(sweep) + 1
        wait_for(lambda: members_that_ended(sweep) >= goal)
        time.sleep(draw.uniform(0.0, 0.2))
        workers[victim].kill()
        workers[victim].communicate()
    workers[1] = worker(sweep, 2)  # one of them comes back, the other's members are taken over
    finish(workers[0], workers[1], workers[2])
    assert contents(sweep.path / "shared") == contents(sweep.path / "single")
    assert not list(sweep.path.glob("shared/leases/*"))


def test_every_member_is_run_once(sweep):
    workers = [worker(sweep, part, 2) for part in (1, 2)]
    texts = [process.communicate(timeout=300)[0] for process in workers]
    assert [process.returncode for process in workers] == [0, 0]
    ended = [line.split("] ")[1].split(":")[0] for text in texts for line in text.splitlines() if ": finished in" in line]
    assert len(ended) == len(set(ended)) == MEMBERS
    assert all(text.count(": finished in") >= 2 for text in texts)


def test_a_lease_of_another_machine_is_taken_over_once_it_rests(sweep):
    lease = sweep.path / "shared/leases/friction=0.2.seed-1"
    lease.parent.mkdir(parents=True)
    process = worker(sweep, 1, 1)  # the folder holds leases alone: it makes the rest
    process.communicate(timeout=300)
    assert process.returncode == 2
    finish(worker(sweep, 1, 1, out="other"))
    (sweep.path / "other/members/friction=0.2/seed-1/summary.json").unlink()  # so it is to run again
    lease = sweep.path / "other/leases/friction=0.2.seed-1"
    lease.parent.mkdir(exist_ok=True)
    lease.write_text("elsewhere 1\n")
    stop = threading.Event()

    def touch():
        while not stop.wait(0.2):
            os.utime(lease)

    thread = threading.Thread(target=touch)
    thread.start()
    process = worker(sweep, 1, 1, out="other")
    time.sleep(3.0)
    assert process.poll() is None and members_that_ended(sweep, "other") == MEMBERS - 1
    stop.set()
    thread.join()
    finish(process)
    assert members_that_ended(sweep, "other") == MEMBERS and not lease.exists()


def test_collect_writes_tables_of_what_is_there(sweep):
    process = worker(sweep, 1, 1)
    wait_for(lambda: members_that_ended(sweep) >= 3)
    result = sweep("sweep", "sweep.toml", "--out", "shared", "--collect")
    assert result.returncode == 0, result.stderr
    finished = sum(int(row["finished"]) for row in rows_of(sweep.path / "shared/table.csv"))
    assert 3 <= finished < MEMBERS and "members" in result.stdout
    finish(process)
    before = contents(sweep.path / "shared")
    assert sweep("sweep", "shared/sweep.toml", "--collect").returncode == 0
    assert contents(sweep.path / "shared") == before
    sweep.refused("sweep", "sweep.toml", "--out", "nowhere", "--collect", parts=["nowhere: holds no sweep"])


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGUSR1])
def test_a_signal_leaves_checkpoints_and_the_members_resume(sweep, number):
    sweep.scene(heap(200) + "[output]\ncheckpoint = 0\n", "heap.toml")
    sweep.scene(SWEEP.replace("seeds = 3", "seeds = 1"), "sweep.toml")
    run_sweep(sweep, out="single")
    process = worker(sweep, 1, 1, threads="2")
    wait_for(lambda: len(list(sweep.path.glob("shared/members/*/*/run.h5"))) == 2)
    time.sleep(0.3)
    process.send_signal(number)
    text, _ = process.communicate(timeout=60)
    assert process.returncode == 130, text
    assert list(sweep.path.glob("shared/members/*/*/checkpoints/*.h5")) and members_that_ended(sweep) < 2
    assert not list(sweep.path.glob("shared/leases/*"))
    finish(worker(sweep, 1, 1))
    assert contents(sweep.path / "shared") == contents(sweep.path / "single")


def test_a_plain_sweep_and_shares_exclude_each_other(sweep):
    process = worker(sweep, 1, 1)
    wait_for(lambda: members_that_ended(sweep) >= 1)
    with paused(process):
        result = sweep("sweep", "sweep.toml", "--out", "shared")
    assert result.returncode == 2 and "is being written here by another program" in result.stderr
    finish(process)


@pytest.mark.parametrize(
    "options, parts",
    [
        (["--share", "3/2"], ["--share 3/2: must be I/N"]),
        (["--share", "0/2"], ["--share 0/2: must be I/N"]),
        (["--share", "half"], ["--share half: must be I/N"]),
        (["--share", "1/2", "--overwrite"], ["--overwrite"]),
        (["--share", "1/2", "--collect"], ["--collect"]),
        (["--share", "1/2", "--lease", "0"], ["--lease"]),
    ],
)
def test_bad_shares_are_refused(sweep, options, parts):
    sweep.refused("sweep", "sweep.toml", "--out", "out", *options, parts=parts)
