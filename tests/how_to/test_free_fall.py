# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The method of docs/how-to/add-a-method.md in a program of its own: all verbs know it."""

import csv
import re
import signal
import subprocess
import time
from pathlib import Path

import h5py
import numpy as np
import pytest
from conftest import LIMIT, PROGRAM, Laboratory, assert_same_bits, summary

SCENE = """method = { kind = "free-fall" }
base = { kind = "none" }
grains = { polydispersity = 0.5 }
source = { kind = "pour", count = 100, rate = 20.0, height = 6, half_width = 3, velocity = [0.4, 0.0] }
plane = [{ point = [0.0, 0.0], normal = [0.0, 1.0] }, { point = [-5.0, 0.0], normal = [1.0, 0.0] },
         { point = [5.0, 0.0], normal = [-1.0, 0.0] }]
stop = { time = 6000 }
output = { frames = 1500, track = 300, checkpoint = 1e-3 }
"""


@pytest.fixture
def lab(tmp_path):
    return Laboratory(tmp_path)


def test_the_page_keeps_its_word():
    page = (Path(__file__).parents[2] / "docs/how-to/add-a-method.md").read_text()
    lines = re.search(r"```cpp\n(.*?)\n```", page, re.S).group(1).splitlines()
    code = [line for line in lines if line.strip() and not line.strip().startswith("//")]
    assert len(code) < 100


def test_check_knows_its_name_and_its_limits(lab):
    result = lab("check", lab.scene(SCENE))
    assert result.returncode == 0 and "off walls alone, without loss" in result.stdout, result.stderr
    wall = '[[wall]]\nfrom = [0.0, 1.0]\nto = [1.0, 1.0]\n'
    lab.refused("check", lab.scene(SCENE + wall), parts=['method.kind = "free-fall": knows planes alone'])


def test_run_kill_resume_analyse_and_export(lab):
    whole = lab.run(SCENE, out="whole")
    process = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", "cut", "--quiet"], cwd=lab.path)
    end = time.monotonic() + LIMIT
    while not (lab.path / "cut/checkpoints/0.h5").exists() and time.monotonic() < end:
        time.sleep(0.002)
    process.send_signal(signal.SIGKILL)
    assert process.wait() == -signal.SIGKILL, "the run was over before it was killed"
    result = lab("resume", "cut", "--quiet")
    assert result.returncode == 0, result.stderr
    assert_same_bits(whole / "run.h5", lab.path / "cut/run.h5")
    assert summary(lab.path / "cut")["state_hash"] == summary(whole)["state_hash"]

    found = summary(whole)
    assert found["status"] == "finished" and found["grains"] == 100 and found["time"] == 6000.0
    with h5py.File(whole / "run.h5", "r") as file:
        assert len(file["frames"]) >= 3 and len(file["track"]) >= 3
        # Elastic: once all are released the kinetic energy only goes to and fro with the height.
        energy = file["series/kinetic_energy_per_grain"][()]
        assert energy.max() < 10.0 * energy.mean()
        # The mean force on the floor is the weight, up to the bounces at the ends of the interval.
        mass = file["grains/mass"][()].sum()
        force = -file["series/wall_force_y"][200:, 0].mean()
        assert force == pytest.approx(mass, rel=0.02)

    before = (whole / "summary.json").read_bytes()
    assert lab("analyse", "whole", "--quiet").returncode == 0
    assert (whole / "summary.json").read_bytes() == before
    for to, file in (("csv", "series.csv"), ("vtk", "grains.pvd"), ("ovito", "grains.dump")):
        result = lab("export", "whole", "--to", to)
        assert result.returncode == 0 and (whole / "export" / to / file).exists(), result.stderr


def test_sweep(lab):
    lab.scene(SCENE.replace("time = 2000", "time = 40").replace("count = 100", "count = 20"), "fall.toml")
    lab.scene('scene = "fall.toml"\nseeds = 2\n[vary]\nsource.height = [2.0, 8.0]\n', "sweep.toml")
    result = lab("sweep", "sweep.toml", "--out", "swept")
    assert result.returncode == 0, result.stderr
    rows = list(csv.DictReader((lab.path / "swept/table.csv").open()))
    assert [row["source.height"] for row in rows] == ["2.0", "8.0"]
    assert all(row["finished"] == "2" for row in rows)
    means = []
    for height in ("2", "8"):
        series = sorted((lab.path / "swept/members").glob(f"*{height}*/seed-1/run.h5"))
        with h5py.File(series[0], "r") as file:
            means.append(np.mean(file["series/kinetic_energy_per_grain"][()]))
    assert means[1] > 2.0 * means[0]  # it falls four times as far
