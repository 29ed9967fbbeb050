# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The batch script of `repose sweep --slurm`: its text, odd paths, bad input, and what it does when signals come. Stubs
stand for the commands of Slurm; test_cluster.py has Slurm itself."""

import os
import shlex
import signal
import subprocess
import time

import pytest
from conftest import HEAP, PROGRAM, Laboratory
from test_sweep import SWEEP, contents, run_sweep
from test_sweep_share import heap, wait_for

ODD = """it's a "heap" $HOME `x` #1 %a"""


@pytest.fixture
def sweep(lab):
    """A folder with a sweep of two heaps of about a second each."""
    lab.scene(heap(200) + "[output]\ncheckpoint = 0\n", "heap.toml")
    lab.scene(SWEEP.replace("seeds = 3", "seeds = 1"), "sweep.toml")
    return lab


@pytest.fixture
def stubs(lab):
    """A folder for PATH with commands that write their words, one a line, into files of their names."""
    folder = lab.path / "stubs"
    folder.mkdir()

    def add(name, then=""):
        (folder / name).write_text(f'#!/bin/bash\nprintf "%s\\n" "$@" >> {shlex.quote(str(lab.path))}/{name}.words\n{then}\n')
        (folder / name).chmod(0o755)

    add("scontrol")
    add("sbatch", "echo Submitted batch job 7")
    lab.add_stub = add
    lab.with_stubs = {"PATH": f"{folder}:{os.environ['PATH']}"}
    return folder


def write_script(lab, *options, file="sweep.toml", out="out"):
    result = lab("sweep", file, "--out", out, "--slurm", *options)
    assert result.returncode == 0, result.stderr
    assert len(result.stdout.splitlines()) == 1
    script = lab.path / out / "slurm/batch.sh"
    assert shlex.split(result.stdout.split(": ", 1)[1]) == ["sbatch", str(script)]
    assert subprocess.run(["bash", "-n", script], capture_output=True, text=True).stderr == ""
    return script.read_text()


def options_in(text):
    """The options of sbatch in a script. Slurm reads their quotes as a shell does."""
    lines = [line.removeprefix("#SBATCH ") for line in text.splitlines() if line.startswith("#SBATCH ")]
    return dict(word.removeprefix("--").partition("=")[::2] for line in lines for word in shlex.split(line))


def task(lab, number=1, out="out", **environment):
    """Starts a task of a script, as Slurm does."""
    return subprocess.Popen(["bash", lab.path / out / "slurm/batch.sh"], cwd="/", stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True,
                            env={**os.environ, **lab.with_stubs, "SLURM_ARRAY_TASK_ID": str(number), "SLURM_ARRAY_JOB_ID": "7",
                                 "SLURM_JOB_ID": "9", **environment})


def until_members_run(lab, out="out"):
    wait_for(lambda: list(lab.path.glob(f"{out}/members/*/*/run.h5")))
    time.sleep(0.3)


def words_of(lab, name):
    path = lab.path / f"{name}.words"
    return path.read_text().splitlines() if path.exists() else []


def test_the_script_says_what_was_asked_for(sweep):
    options = options_in(write_script(sweep, "--array", "2", "--threads", "3", "--time", "1-12", "--partition", "long,gpu"))
    assert options == {"job-name": "out", "array": "1-2", "ntasks": "1", "cpus-per-task": "3", "time": "1-12",
                       "partition": "long,gpu", "signal": "B:USR1@120", "requeue": "", "open-mode": "append",
                       "output": f"{sweep.path}/out/slurm/task-%a.log"}
    text = write_script(sweep, out="other")
    del options["partition"]
    assert options_in(text) == {**options, "job-name": "other", "time": "24:00:00", "array": "1-1", "cpus-per-task": "4",
                                "output": f"{sweep.path}/other/slurm/task-%a.log"}
    command = shlex.split(text[text.index(PROGRAM) :].split(" &\n")[0].replace("\\\n", ""))
    assert command == [PROGRAM, "sweep", f"{sweep.path}/sweep.toml", "--out", f"{sweep.path}/other", "--share",
                       "$SLURM_ARRAY_TASK_ID/1", "--threads", "4", "--lease", "60"]


def test_all_options_of_the_sweep_reach_its_tasks(sweep):
    sweep.scene(SWEEP + "[quick]\nseeds = 1\n", "quick.toml")
    text = write_script(sweep, "--quick", "--lease", "7.5", file="quick.toml")
    assert "--lease 7.5 --quick" in text
    assert sweep("sweep", "sweep.toml", "--out", "other", "--slurm", "--quiet").stdout == ""


def test_paths_with_odd_letters(tmp_path, stubs):
    lab = Laboratory(tmp_path / ODD)
    lab.path.mkdir()
    lab.scene(HEAP, "heap.toml")
    lab.scene(SWEEP.replace("seeds = 3", "seeds = 1"), f"{ODD}.toml")
    text = write_script(lab, file=f"{ODD}.toml", out=ODD)
    lab.with_stubs = {"PATH": f"{stubs}:{os.environ['PATH']}"}
    place = str(lab.path / ODD / "slurm").replace("%", "%%")
    assert options_in(text)["output"] == f"{place}/task-%a.log"
    said, _ = task(lab, out=ODD).communicate(timeout=300)
    assert (lab.path / ODD / "table.csv").is_file(), said


@pytest.mark.parametrize("asked, everyone", [(signal.SIGUSR1, False), (signal.SIGTERM, True)])
def test_a_signal_leaves_checkpoints_and_the_next_start_resumes(sweep, stubs, asked, everyone):
    """Slurm sends SIGTERM to all processes of a task. One that it preempts it queues again itself; one that is cancelled
    must stay so."""
    run_sweep(sweep, out="single")
    write_script(sweep, "--threads", "2")
    process = task(sweep)
    until_members_run(sweep)
    if everyone:
        for child in subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True).stdout.split():
            os.kill(int(child), asked)
    process.send_signal(asked)
    said, _ = process.communicate(timeout=60)
    assert process.returncode == 130, said
    assert list(sweep.path.glob("out/members/*/*/checkpoints/*.h5"))
    assert words_of(sweep, "scontrol") == (["requeue", "7_1"] if asked == signal.SIGUSR1 else [])
    process = task(sweep)
    said, _ = process.communicate(timeout=300)
    assert process.returncode == 0, said
    assert contents(sweep.path / "out") == contents(sweep.path / "single")
    assert len(words_of(sweep, "scontrol")) == (2 if asked == signal.SIGUSR1 else 0)


def test_a_task_ends_with_the_status_of_its_sweep(sweep, stubs):
    write_script(sweep)
    (sweep.path / "sweep.toml").unlink()
    process = task(sweep)
    said, _ = process.communicate(timeout=60)
    assert process.returncode == 2 and "sweep.toml" in said and words_of(sweep, "scontrol") == []


def test_a_script_is_submitted(sweep, stubs):
    result = sweep("sweep", "sweep.toml", "--slurm", "--submit", "--out", "a b", before=f"export PATH={stubs}:$PATH")
    assert result.returncode == 0 and "Submitted batch job 7" in result.stdout, result.stderr
    assert words_of(sweep, "sbatch") == ["--version", str(sweep.path / "a b/slurm/batch.sh")]
    sweep.add_stub("sbatch", '[ "$1" = --version ] || { echo "sbatch: error: no partition" >&2; echo Batch failed; exit 1; }')
    result = sweep("sweep", "sweep.toml", "--slurm", "--submit", "--out", "b", before=f"export PATH={stubs}:$PATH")
    assert result.returncode == 1 and len(result.stderr.splitlines()) == 1
    assert "not submitted: sbatch: error: no partition; Batch failed" in result.stderr


def test_without_slurm_nothing_is_submitted(sweep):
    sweep.refused("sweep", "sweep.toml", "--slurm", "--submit", before="export PATH=/nowhere",
                  parts=["sbatch: cannot be started: No such file or directory"])


def test_a_script_may_be_written_again_and_lies_beside_a_sweep(sweep):
    sweep.scene(HEAP, "heap.toml")
    write_script(sweep)
    run_sweep(sweep)
    assert "--array=1-2" in write_script(sweep, "--array", "2")
    before = contents(sweep.path / "out")
    run_sweep(sweep)
    assert contents(sweep.path / "out") == before
    run_sweep(sweep, "--overwrite")
    assert not (sweep.path / "out/slurm").exists()


@pytest.mark.parametrize("options, part", [
    (["--array", "2"], "only with --slurm"),
    (["--time", "60"], "only with --slurm"),
    (["--partition", "long"], "only with --slurm"),
    (["--submit"], "only with --slurm"),
    (["--slurm", "--share", "1/2"], "--slurm: writes a batch script alone"),
    (["--slurm", "--collect"], "--slurm: writes a batch script alone"),
    (["--slurm", "--overwrite"], "--slurm: writes a batch script alone"),
    (["--slurm", "--check"], "--slurm: writes a batch script alone"),
    (["--slurm", "--array", "0"], "--array"),
    (["--slurm", "--array", "3"], "--array 3: the sweep has 2 members"),
    *((["--slurm", "--time", time], f"--time {time}: must be a time of Slurm") for time in
      ("4", "0", "soon", "1:2:3:4", "1-", "-1", "5m", "1-2-3", "0:4:59", "12:", "9999999", "UNLIMITED")),
    (["--slurm", "--time", "60\n#SBATCH x"], "--time 60"),
    (["--slurm", "--partition", "a b"], "--partition a b: must be the name"),
    (["--slurm", "--partition", "a\nb"], "--partition a"),
    (["--slurm", "--out", "a\nb"], "must have no backslash"),
    (["--slurm", "--out", "a\\b"], "must have no backslash"),
])
def test_bad_input_is_refused(sweep, options, part):
    sweep.refused("sweep", "sweep.toml", *(options if "--out" in options else ["--out", "out", *options]), parts=[part])


@pytest.mark.parametrize("time", ["5", "300:00", "0:5:00", "0-1", "2-12:30", "2-12:30:15", "0-0:5"])
def test_times_of_slurm(sweep, time):
    assert f"#SBATCH --time={time}\n" in write_script(sweep, "--time", time)


def test_the_sweep_is_checked_first(sweep):
    sweep.scene("scene = 3\n", "bad.toml")
    sweep.refused("sweep", "bad.toml", "--out", "out", "--slurm", parts=["bad.toml"])
    (sweep.path / "full").mkdir()
    (sweep.path / "full/notes").touch()
    sweep.refused("sweep", "sweep.toml", "--out", "full", "--slurm", parts=["holds no sweep"])
