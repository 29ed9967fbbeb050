# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that fail or are stopped: their messages and the files that they leave."""

import json
import os
import re
import signal
import subprocess
import time

import pytest
from conftest import HEAP, LIMIT, PROGRAM, datasets, everything_in, summary, text_attribute

LONG = HEAP.replace("at_rest = 1e-6\ntime = 500", "time = 1e7") + "[output]\nframes = 20\n"


def no_leftovers(folder):
    return not [name for name in everything_in(folder) if name.endswith(".tmp")]


# Grains so fast for their step that one runs into another between two steps.
FAST = "gravity = 0\n[method]\ntime_step = 0.01\n[contact]\nnormal = { law = 'hooke', stiffness = 1 }\n"


def fast(*places, stop=5):
    grains = "".join(f"[[grain]]\nposition = [{x}, 0.0]\nvelocity = [{v}, 0.0]\n" for x, v in places)
    return f"{FAST}{grains}[stop]\ntime = {stop}\n[output]\nseries = 0.01\n"


def test_grains_that_run_into_each_other(lab):
    lab.scene(fast((-9, 0), (0, 30), (19, 0), (3, 0)))
    result = lab("run", "scene.toml", "--out", "out", "--quiet")
    assert result.returncode == 1, result.stderr
    said = result.stderr.strip()
    assert len(said.splitlines()) == 1 and re.search(r"\b1\b.*\b3\b", said), said
    assert "2" not in re.findall(r"grains? (\d+)", said), said
    out = lab.path / "out"
    assert text_attribute(out / "run.h5", "status") == "failed"
    assert text_attribute(out / "run.h5", "message") in said
    assert len(datasets(out / "run.h5")["/grains/id"]) == 4
    assert summary(out)["status"] == "failed" and no_leftovers(out)
    json.loads((out / "summary.json").read_text(), parse_constant=lambda word: pytest.fail(word))


@pytest.mark.parametrize("second", ["0.0, 0.0", "1e-300, 0.0", "1e-9, 0.0", "0.7, 0.0"])
def test_grains_that_overlap_from_the_start(lab, second):
    lab.scene(f"[[grain]]\nposition = [0.0, 0.0]\n[[grain]]\nposition = [{second}]\n[stop]\ntime = 5\n")
    lab.refused("run", "scene.toml", "--out", "out", parts=("scene.toml:4: grain[1].position", "it and grain[0]"))


def test_fixed_grains_may_overlap(lab):
    """Fixed grains placed close together make a wall and do not explode."""
    text = "".join(f"[[grain]]\nposition = [{0.2 * k}, 0.0]\nfixed = true\n" for k in range(-10, 11))
    lab.run(text + "[[grain]]\nposition = [0.1, 1.5]\n[stop]\ntime = 5\n")


def test_buried_source(lab):
    lab.scene(HEAP.replace("height = 10", "height = 3").replace("half_width = 2", "half_width = 0"))
    result = lab("run", "scene.toml", "--out", "out", "--quiet", "--set", "source.count=200")
    assert result.returncode == 1 and "the source is buried: grain " in result.stderr
    assert text_attribute(lab.path / "out/run.h5", "status") == "failed"


def test_a_failure_is_not_reported_as_success(lab):
    lab.scene(fast((0, 30), (3, 0)))
    result = lab("run", "scene.toml", "--out", "out")
    assert result.returncode == 1 and "stopped  " not in result.stdout and result.stderr.strip()


@pytest.mark.parametrize("which", [signal.SIGINT, signal.SIGTERM])
def test_interrupt(lab, which):
    lab.scene(LONG)
    process = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", "out", "--quiet"], cwd=lab.path,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        give_up = time.monotonic() + LIMIT
        while not (lab.path / "out/frames/000001.h5").exists() and time.monotonic() < give_up:
            assert process.poll() is None, process.stderr.read()
            time.sleep(0.02)
        process.send_signal(which)
        said = process.communicate(timeout=LIMIT)
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()
    assert process.returncode == 130, said
    out = lab.path / "out"
    assert text_attribute(out / "run.h5", "status") == "interrupted"
    assert summary(out)["status"] == "interrupted" and summary(out)["stop_reason"] == "interrupted"
    found = datasets(out / "run.h5")
    assert any(name.startswith("/frames/000001") for name in found) and no_leftovers(out)


def test_interrupt_does_not_wait_for_the_next_observation(lab):
    lab.scene(LONG)
    process = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", "out", "--quiet", "--set", "output.series=1e7"],
                               cwd=lab.path, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        give_up = time.monotonic() + LIMIT
        while not (lab.path / "out/summary.json").exists() and time.monotonic() < give_up:
            time.sleep(0.02)
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=LIMIT) == 130
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()
    assert summary(lab.path / "out")["status"] == "interrupted"


def test_killed_at_any_time_leaves_a_readable_run(lab):
    """After kill -9 during writing, run.h5 and every frame that it names can be opened."""
    lab.scene(LONG.replace("frames = 20", "frames = 1"))
    for n, wait in enumerate((0.05, 0.11, 0.17, 0.23, 0.31)):
        out = lab.path / f"out{n}"
        process = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", out, "--quiet"], cwd=lab.path)
        try:
            give_up = time.monotonic() + LIMIT
            while not (out / "summary.json").exists() and time.monotonic() < give_up:
                time.sleep(0.005)
            time.sleep(wait)
        finally:
            process.kill()
            process.wait()
        assert text_attribute(out / "run.h5", "status") == "running"
        assert len(datasets(out / "run.h5")["/grains/id"]) >= 17
        assert summary(out)["status"] == "running"


def test_run_again_over_a_killed_run(lab):
    out = lab.run(HEAP, "--set", "source.count=2")
    (out / "run.h5.tmp").write_bytes(b"half a file")
    lab.run(HEAP, "--set", "source.count=3", "--overwrite")
    assert no_leftovers(out)


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no /dev/full here")
def test_full_standard_output(lab):
    """A full disk behind standard output must not cost the run its results."""
    lab.scene(HEAP)
    with open("/dev/full", "w") as full:
        result = subprocess.run([PROGRAM, "run", "scene.toml", "--out", "out"], cwd=lab.path, stdout=full,
                                stderr=subprocess.PIPE, text=True, timeout=LIMIT)
    assert "terminate" not in result.stderr and result.returncode in (0, 1)
    assert text_attribute(lab.path / "out/run.h5", "status") == "finished"
