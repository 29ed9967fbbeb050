# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps under Slurm: tasks whose time ends, that are preempted and cancelled, make the tables of one program. Takes
minutes; run by ./dev validate."""

import os
import re
import subprocess
import time
from pathlib import Path

import pytest
from conftest import PROGRAM
from one_node_slurm import CannotStart, one_node_slurm
from test_sweep import SWEEP, contents
from test_sweep_share import heap

pytestmark = pytest.mark.skipif("REPOSE_SLOW" not in os.environ, reason="takes minutes: ./dev validate")

SPACING = Path(__file__).resolve().parents[2] / "examples/sweeps/spacing.toml"


@pytest.fixture(scope="module")
def slurm(tmp_path_factory):
    try:
        with one_node_slurm(tmp_path_factory.mktemp("slurm") / "one") as running:
            yield running
    except CannotStart as reason:
        pytest.skip(f"Slurm does not start: {reason}")


def sweep(lab, file, out, *options, **environment):
    result = subprocess.run([PROGRAM, "sweep", str(file), "--out", out, *options], cwd=lab.path, capture_output=True,
                            text=True, env={**os.environ, **environment})
    assert result.returncode == 0, result.stderr
    return result.stdout


def submit(lab, slurm, file, *options, **environment):
    """Submits two tasks of one core each; returns the number of their array."""
    said = sweep(lab, file, "shared", "--slurm", "--array", "2", "--threads", "1", "--submit", *options,
                 **slurm.environment, **environment)
    return re.search(r"Submitted batch job (\d+)", said)[1]


def all_are(array, state):
    return lambda states: [states.get(f"{array}_{task}") for task in (1, 2)] == [state] * 2


def restarts(slurm, array):
    """How often Slurm has started the tasks again."""
    return sum(int(count) for count in re.findall(r"Restarts=(\d+)", slurm.ask("scontrol", "show", "job", array)))


def until_members_run(lab, slurm):
    slurm.wait_for(lambda _: len(list(lab.path.glob("shared/members/*/*/run.h5"))) >= 2, 60)
    time.sleep(2)


def logs(lab):
    return "".join(path.read_text() for path in sorted(lab.path.glob("shared/slurm/*.log")))


def members_with_checkpoints(lab):
    return {path.parent for path in lab.path.glob("shared/members/*/*/checkpoints/*.h5")}


def test_tasks_that_are_queued_again_make_the_tables_of_one_sweep(lab, slurm):
    """The signal comes by hand once, and half a minute before the minute of each task ends."""
    text = SPACING.read_text().replace('"../', f'"{SPACING.parents[1]}/').replace("seeds = 6", "seeds = 2")
    lab.scene(text, "spacing.toml")
    start = time.monotonic()
    array = submit(lab, slurm, "spacing.toml", "--quick", SBATCH_TIMELIMIT="1", SBATCH_SIGNAL="B:USR1@30")
    until_members_run(lab, slurm)
    slurm.ask("scancel", "--batch", "--signal=USR1", f"{array}_1")
    slurm.wait_for(all_are(array, "COMPLETED"), 1500)
    print(f"\n{restarts(slurm, array)} restarts in {time.monotonic() - start:.0f} s")
    assert restarts(slurm, array) >= 1 and "DUE TO JOB REQUEUE" in logs(lab), logs(lab)
    assert "TIME LIMIT" not in logs(lab)
    sweep(lab, "spacing.toml", "single", "--quick")
    assert contents(lab.path / "shared") == contents(lab.path / "single")


def test_preempted_tasks_resume_and_cancelled_ones_stay_so(lab, slurm):
    lab.scene(heap(1500) + "[output]\ncheckpoint = 0\n", "heap.toml")
    lab.scene(SWEEP.replace("seeds = 3", "seeds = 1"), "sweep.toml")
    array = submit(lab, slurm, "sweep.toml")
    until_members_run(lab, slurm)
    slurm.ask("sbatch", "--partition=urgent", "--cpus-per-task=4", "--output=/dev/null", "--wrap=sleep 1")
    slurm.wait_for(all_are(array, "PENDING"), 60)
    assert len(members_with_checkpoints(lab)) == 2 and "DUE TO PREEMPTION" in logs(lab)
    slurm.wait_for(all_are(array, "RUNNING"), 60)
    assert restarts(slurm, array) == 2
    time.sleep(2)
    slurm.ask("scancel", array)
    slurm.wait_for(all_are(array, "CANCELLED"), 60)
    assert len(members_with_checkpoints(lab)) == 2
    time.sleep(10)  # a task that is queued again starts after less than that
    assert all_are(array, "CANCELLED")(slurm.states())
    array = submit(lab, slurm, "sweep.toml")
    slurm.wait_for(all_are(array, "COMPLETED"), 600)
    sweep(lab, "sweep.toml", "single")
    assert contents(lab.path / "shared") == contents(lab.path / "single")
