# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are interrupted or killed and then resumed: the same bits as an undisturbed run."""

import json
import random
import re
import shutil
import signal
import subprocess
import time

import h5py
import pytest
import xxhash
from conftest import LIMIT, PROGRAM, changed, summary, text_attribute
from interruption import KILLS, OTHER, PERIODIC, SCENE, assert_same_run, comparable, resumed, started, wait_for_checkpoint, wait_until

@pytest.fixture(scope="module", params=["open", "periodic"])
def undisturbed(request, tmp_path_factory):
    from conftest import Laboratory

    lab = Laboratory(tmp_path_factory.mktemp("undisturbed"))
    text = SCENE if request.param == "open" else PERIODIC
    start = time.monotonic()
    lab.run(text, out="whole")
    lab.text, lab.seconds = text, time.monotonic() - start
    return lab


def test_checkpoints_change_no_result_and_are_removed_at_the_end(undisturbed):
    lab = undisturbed
    assert not (lab.path / "whole/checkpoints").exists()
    without = lab.run(lab.text.replace("checkpoint = 1e-3", "checkpoint = 0"), out="without")
    a, b = comparable(lab.path / "whole"), comparable(without)
    assert a[0].pop("run/scene") != b[0].pop("run/scene")
    assert a == b


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_resuming_gives_the_same_bits(undisturbed, how):
    lab = undisturbed
    out = lab.path / f"cut{int(how)}"
    process = started(lab, out)
    wait_until(out, 70.0)
    process.send_signal(how)
    process.communicate(timeout=LIMIT)
    assert process.returncode == (-9 if how == signal.SIGKILL else 130)
    if how != signal.SIGKILL:
        assert text_attribute(out / "run.h5", "status") == "interrupted"
    resumed(lab, out, "--threads", "3")
    assert_same_run(lab.path / "whole", out)
    assert not (out / "checkpoints").exists()


def test_other_laws_and_sources_resume(lab):
    lab.text = OTHER
    whole = lab.run(OTHER, out="whole")
    out = lab.path / "cut"
    process = started(lab, out)
    wait_until(out, 50.0)
    process.kill()
    process.communicate(timeout=LIMIT)
    resumed(lab, out, "--threads", "3")
    assert_same_run(whole, out)


def test_interrupted_again_and_again(undisturbed):
    lab = undisturbed
    out = lab.path / "again"
    process = started(lab, out, "--threads", "2")
    for _ in range(6):
        time.sleep(0.15 * lab.seconds + 0.1)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=LIMIT)
        if process.returncode == 0:
            break
        process = subprocess.Popen([PROGRAM, "resume", str(out), "--quiet"], stderr=subprocess.PIPE, text=True)
    assert process.wait(timeout=LIMIT) in (0, 130)
    resumed(lab, out)
    assert_same_run(lab.path / "whole", out)


def test_kills_at_random_moments(undisturbed):
    """Each kill leaves a folder that can be analysed and resumed. The end is that of the undisturbed run."""
    lab = undisturbed
    moments = random.Random(7)
    for k in range(KILLS):
        out = lab.path / f"killed{k}"
        process = started(lab, out)
        while not (out / "run.h5").exists():
            time.sleep(0.002)
        time.sleep(moments.uniform(0.0, 1.2 * lab.seconds))
        process.kill()
        process.wait()
        looked_at = lab("analyse", out, "--quiet")
        assert looked_at.returncode == 0, looked_at.stderr
        resumed(lab, out)
        assert_same_run(lab.path / "whole", out)
        shutil.rmtree(out)


def test_a_kill_before_the_first_checkpoint_restarts_the_run(undisturbed):
    lab = undisturbed
    text = lab.text.replace("checkpoint = 1e-3", "checkpoint = 1000")
    usual, lab.text = lab.text, text
    process = started(lab, "early")
    lab.text = usual
    while not (lab.path / "early/frames/000001.h5").exists():
        time.sleep(0.002)
    process.kill()
    process.wait()
    assert not (lab.path / "early/checkpoints").exists()
    resumed(lab, "early")
    a, b = comparable(lab.path / "whole"), comparable(lab.path / "early")
    assert a[0].pop("run/scene") != b[0].pop("run/scene")
    assert a == b


def test_a_finished_run_is_not_changed(undisturbed):
    lab = undisturbed
    before = {path: path.read_bytes() for path in (lab.path / "whole").rglob("*") if path.is_file()}
    result = lab("resume", "whole")
    assert result.returncode == 0 and "finished" in result.stdout
    assert before == {path: path.read_bytes() for path in (lab.path / "whole").rglob("*") if path.is_file()}


def test_a_folder_in_use_is_refused(undisturbed):
    lab = undisturbed
    process = started(lab, "used")
    wait_for_checkpoint(lab.path / "used")
    try:
        for arguments in (["resume", "used"], ["analyse", "used"],
                          ["run", "scene.toml", "--out", "used", "--overwrite"]):
            result = lab(*arguments)
            assert result.returncode == 2 and "written here by another program" in result.stderr
    finally:
        process.kill()
        process.wait()
    resumed(lab, "used")
    assert_same_run(lab.path / "whole", lab.path / "used")


def test_a_finished_run_without_its_analysis_gets_it(undisturbed):
    """After a kill behind the last run.h5 the summary is that of an earlier state, and a checkpoint still exists."""
    lab = undisturbed
    for k, spoil in enumerate((lambda path: path.unlink(),
                               lambda path: path.write_text(path.read_text().replace('"finished"', '"running"')))):
        out = lab.path / f"unread{k}"
        shutil.copytree(lab.path / "whole", out)
        spoil(out / "summary.json")
        (out / "checkpoints").mkdir()
        (out / "checkpoints/0.h5").write_text("remains")
        assert "its analysis was missing and has been made" in lab("resume", out).stdout
        assert_same_run(lab.path / "whole", out)
        assert not (out / "checkpoints").exists()


def test_a_kill_during_the_start(lab):
    """A folder that was not complete at the kill does not count; a complete one is resumed."""
    text = SCENE.replace("time = 240", "time = 6")
    whole = lab.run(text, out="whole")
    (lab.path / "begun/new").mkdir(parents=True)
    (lab.path / "begun/new/scene.toml").write_text("half a")
    assert "holds no run" in lab("resume", "begun").stderr
    assert_same_run(whole, lab.run(text, out="begun"))
    assert not (lab.path / "begun/new").exists()
    for moved in range(4):
        out = lab.run(text.replace("rate = 5.0", "rate = 3.0"), out=f"ready{moved}")
        lab.run(text.replace("checkpoint = 1e-3", "checkpoint = 1e3").replace("time = 6", "time = 0.001"), out=f"{moved}")
        (lab.path / f"{moved}").rename(out / "ready")
        (out / "ready/scene.toml").write_text((whole / "scene.toml").read_text())
        with changed(out / "ready/run.h5") as file:
            file.attrs["status"] = file.attrs["status"].__class__(b"running")
            scene = file["scene"][()]
            del file["scene"]
            with h5py.File(whole / "run.h5", "r") as other:
                scene = other["scene"][()]
            file["scene"] = scene
        if moved > 0:
            shutil.rmtree(out / "frames", ignore_errors=True)
            shutil.rmtree(out / "track", ignore_errors=True)
        for name in ("scene.toml", "run.h5", "analysis.h5", "summary.json")[:moved]:
            (out / "ready" / name).replace(out / name)
        resumed(lab, out)
        assert_same_run(whole, out)
        assert not (out / "ready").exists()


def test_a_sweep_is_resumed_by_its_own_command(lab):
    lab.scene("points = []")
    (lab.path / "swept/scenes").mkdir(parents=True)
    lab.scene("x = 1", "swept/sweep.toml")
    result = lab("resume", "swept")
    assert result.returncode == 2 and "repose sweep swept/sweep.toml" in result.stderr


def test_a_failed_run_is_not_resumed(lab):
    """A grain runs into another between two steps."""
    lab.run("gravity = 0\n[method]\ntime_step = 0.01\n[contact]\nnormal = { law = 'hooke', stiffness = 1 }\n"
            "[[grain]]\nposition = [0.0, 0.0]\nvelocity = [30.0, 0.0]\n[[grain]]\nposition = [3.0, 0.0]\n"
            "[stop]\ntime = 5\n[output]\nseries = 0.01\n", expect=1)
    result = lab("resume", "out")
    assert result.returncode == 2 and "the run failed" in result.stderr


@pytest.mark.parametrize("folder, part", [("nowhere", "no such folder"), (".", "holds no run")])
def test_no_run_to_resume(lab, folder, part):
    result = lab("resume", folder)
    assert result.returncode == 2 and part in result.stderr


def test_state_hash_is_that_of_the_state(lab):
    """It is the same for any number of threads, and different for another seed."""
    text = SCENE.replace("time = 240", "time = 20")
    hashes = [summary(lab.run(text, *options, out=f"o{k}"))["state_hash"] for k, options in enumerate(
        (["--threads", "1"], ["--threads", "2"], ["--threads", "3"], ["--threads", "4"], ["--seed", "2"]))]
    assert len(set(hashes[:4])) == 1 and hashes[4] != hashes[0]
    assert re.fullmatch("[0-9a-f]{32}", hashes[0])


def test_summary_carries_its_checksum(undisturbed):
    """The checksum is that of the text before it. A sweep does not use a changed summary."""
    text = (undisturbed.path / "whole/summary.json").read_text()
    checksum = json.loads(text)["checksum"]
    assert list(json.loads(text))[-1] == "checksum" and re.fullmatch("[0-9a-f]{32}", checksum)
    assert xxhash.xxh3_128_hexdigest(text[: text.rindex(',\n  "checksum"')].encode()) == checksum


def test_the_analysis_keeps_the_hash_of_the_state(undisturbed):
    """With unequal sizes run.h5 holds spins, so it does not have the exact bits of the rim velocities."""
    lab = undisturbed
    shutil.copytree(lab.path / "whole", lab.path / "read_again")
    before = summary(lab.path / "read_again")
    assert lab("analyse", "read_again", "--quiet").returncode == 0
    assert summary(lab.path / "read_again") == before
