# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes that are interrupted, and what their tests share."""

import os
import signal
import subprocess
import time
from contextlib import contextmanager

import h5py
import pytest
from conftest import LIMIT, PROGRAM, datasets, summary

KILLS = int(os.environ.get("REPOSE_KILLS", "2"))
PARTS = int(os.environ.get("REPOSE_PARTS", "5"))  # parts of a file; it is cut or changed at the end of each

# A heap with everything that a run can have: poured grains of many sizes, frames, a track, a moving wall, a load, the
# energy budget. About a second of computing, with checkpoints as often as their cost allows.
SCENE = """[grains]
polydispersity = 0.3
[contact]
normal = { law = "hooke", stiffness = 2e4 }
tangential = { law = "linear", stiffness = 1e4, damping = 0.1 }
[base]
kind = "row"
half_width = 20
[[plane]]
name = "pusher"
point = [-18.0, 0.0]
normal = [1.0, 0.0]
motion = "spring"
stiffness = 20.0
velocity = [0.02, 0.0]
mass = 30.0
[[load]]
position = [0.0, 10.0]
force = [0.5, -1.0]
start = 40.0
[source]
kind = "pour"
count = 200
rate = 5.0
height = 15
half_width = 4
[stop]
time = 240
[output]
frames = 30
track = 2
checkpoint = 1e-3
energy = true
"""
PERIODIC = SCENE.replace("[[plane]]", "[[wall]]").replace(
    "point = [-18.0, 0.0]\nnormal = [1.0, 0.0]", "from = [-18.0, 0.6]\nto = [-18.0, 9.0]").replace("half_width = 20\n", "half_width = 20\n[box]\nx = \"periodic\"\n").replace("energy = true\n", "")


# The laws, sources and kinds of grains that the scene above does not have.
OTHER = """[contact]
friction = 0.5
normal = { law = "hertz", stiffness = 1e5, restitution = 0.6 }
tangential = { law = "mindlin" }
rolling = { law = "spring", friction = 0.1 }
cohesion = { law = "constant", force = 0.2 }
[[species]]
name = "coarse"
sizes = { kind = "fixed", diameter = 1.0 }
[[species]]
name = "fine"
sizes = { kind = "uniform", low = 0.5, high = 0.8 }
[base]
kind = "deposited"
half_width = 12
[box]
x = "periodic"
[source]
kind = "rain"
count = 300
rate = 5.0
height = 15
[stop]
time = 250
[output]
frames = 20
checkpoint = 1e-3
"""


def comparable(folder):
    """All numbers of a run folder except those that depend on the machine."""
    everything = {f"run{name}": value.tobytes() for name, value in datasets(folder / "run.h5").items()}
    numbers = summary(folder)
    for name in ("wall_seconds", "grain_steps_per_second", "threads", "checksum"):
        del numbers[name]
    return everything, numbers


def assert_same_run(first, second):
    (a, numbers_a), (b, numbers_b) = comparable(first), comparable(second)
    assert sorted(a) == sorted(b)
    assert [name for name in a if a[name] != b[name]] == []
    assert numbers_a == numbers_b


def started(lab, out, *options):
    lab.scene(lab.text)
    return subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", out, "--quiet", *options], cwd=lab.path,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def resumed(lab, out, *options, expect=0):
    result = lab("resume", out, "--quiet", *options)
    assert result.returncode == expect, result.stderr
    return result


@contextmanager
def paused(process):
    """The process stands still meanwhile, so that it cannot end before what is tried beside it, on a machine of any load."""
    process.send_signal(signal.SIGSTOP)
    try:
        yield
    finally:
        process.send_signal(signal.SIGCONT)


def wait_for_checkpoint(folder):
    end = time.monotonic() + LIMIT
    while time.monotonic() < end:
        if (folder / "checkpoints/1.h5").exists():
            return
        time.sleep(0.002)
    pytest.fail("no checkpoint")


def wait_until(folder, simulated):
    """Waits until a run has come to this simulated time and has a checkpoint, on a machine of any load. Where the disk
    is slow, checkpoints are few, and the last one may be older than the state in run.h5."""
    end = time.monotonic() + LIMIT
    while time.monotonic() < end:
        checkpoints = list(folder.glob("checkpoints/?.h5"))
        for path in [*checkpoints, folder / "run.h5"] if checkpoints else []:
            try:
                with h5py.File(path, "r") as file:
                    if file.attrs["time"] >= simulated:
                        return
            except FileNotFoundError:  # the first frame is not written yet
                continue
        time.sleep(0.005)
    pytest.fail(f"no checkpoint of time {simulated}")
