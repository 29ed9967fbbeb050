# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are interrupted, killed or damaged and then resumed: the same bits as an undisturbed run."""

import json
import os
import random
import re
import shutil
import signal
import subprocess
import time
from pathlib import Path

import h5py
import pytest
import xxhash
from conftest import PROGRAM, changed, datasets, summary, text_attribute

KILLS = int(os.environ.get("REPOSE_KILLS", "2"))
PARTS = int(os.environ.get("REPOSE_PARTS", "5"))  # parts of a file; it is cut or changed at the end of each

# A heap with everything that a run can have: poured grains of many sizes, frames, a track, a moving wall, a load, the
# energy budget. About two seconds of computing, with checkpoints as often as their cost allows.
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
count = 350
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
    result = lab("resume", out, "--quiet", *options, timeout=60)
    assert result.returncode == expect, result.stderr
    return result


def wait_for_checkpoint(folder, seconds=20):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if (folder / "checkpoints/1.h5").exists():
            return
        time.sleep(0.002)
    pytest.fail("no checkpoint")


def wait_until(folder, simulated, seconds=30):
    """Waits until a checkpoint of this simulated time exists, on a machine of any load."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        for path in folder.glob("checkpoints/?.h5"):
            with h5py.File(path, "r") as file:
                if file.attrs["time"] >= simulated:
                    return
        time.sleep(0.005)
    pytest.fail(f"no checkpoint of time {simulated}")


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
    process.communicate(timeout=30)
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
    process.communicate(timeout=30)
    resumed(lab, out, "--threads", "3")
    assert_same_run(whole, out)


def test_interrupted_again_and_again(undisturbed):
    lab = undisturbed
    out = lab.path / "again"
    process = started(lab, out, "--threads", "2")
    for _ in range(6):
        time.sleep(0.15 * lab.seconds + 0.1)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=30)
        if process.returncode == 0:
            break
        process = subprocess.Popen([PROGRAM, "resume", str(out), "--quiet"], stderr=subprocess.PIPE, text=True)
    assert process.wait(timeout=60) in (0, 130)
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
        assert "has been made now" in lab("resume", out).stdout
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


@pytest.fixture(scope="module")
def interrupted(tmp_path_factory):
    """A small interrupted run with both checkpoints, and its final state."""
    from conftest import Laboratory

    lab = Laboratory(tmp_path_factory.mktemp("interrupted"))
    text = SCENE.replace("count = 350", "count = 60").replace("half_width = 12", "half_width = 8").replace(
        "time = 120", "time = 60").replace("frames = 15", "frames = 30")
    lab.text = text
    lab.run(text, out="whole")
    process = started(lab, "cut")
    wait_until(lab.path / "cut", 35.0)
    process.send_signal(signal.SIGINT)
    process.wait()
    assert process.returncode == 130, "too late"
    return lab


def copy_of_cut(lab):
    shutil.rmtree(lab.path / "copy", ignore_errors=True)
    shutil.copytree(lab.path / "cut", lab.path / "copy")


def damaged(content, part, cut):
    """The content, cut at the end of a part or with the byte there changed."""
    place = len(content) * part // PARTS
    if cut:
        return content[:place]
    place = min(place, len(content) - 1)
    return content[:place] + bytes([content[place] ^ 0x15]) + content[place + 1 :]


def assert_clear(result):
    """Checks that each problem is one line that names the file."""
    assert result.returncode in (1, 2), f"exit {result.returncode}: {result.stderr}"
    lines = result.stderr.strip().splitlines()
    assert lines and all(line.removeprefix("repose: ").startswith("copy/") for line in lines), result.stderr


@pytest.mark.parametrize("cut", [True, False], ids=["cut", "changed"])
def test_a_damaged_checkpoint_is_reported_and_the_other_one_used(interrupted, cut):
    lab = interrupted
    for slot in (0, 1):
        for part in range(0, PARTS + (0 if cut else 1)):
            copy_of_cut(lab)
            path = lab.path / f"copy/checkpoints/{slot}.h5"
            path.write_bytes(damaged(path.read_bytes(), part, cut))
            result = resumed(lab, "copy")
            assert re.search(rf"checkpoints/{slot}.h5: damaged.*resuming from the other", result.stderr), result.stderr
            assert_same_run(lab.path / "whole", lab.path / "copy")


def test_both_checkpoints_damaged(interrupted):
    lab = interrupted
    copy_of_cut(lab)
    for slot in (0, 1):
        path = lab.path / f"copy/checkpoints/{slot}.h5"
        path.write_bytes(path.read_bytes()[:-1])
    result = lab("resume", "copy")
    assert result.returncode == 2 and len(result.stderr.strip().splitlines()) == 2, result.stderr


@pytest.mark.parametrize("cut", [True, False], ids=["cut", "changed"])
@pytest.mark.parametrize("name", ["run.h5", "scene.toml", "track/000000.h5", "analysis.h5", "summary.json"])
def test_damaged_files_give_no_wrong_analysis(interrupted, name, cut):
    """The analysis reports the damage, or gives the result of the undamaged folder: never another result."""
    lab = interrupted
    assert lab("analyse", "cut", "--quiet").returncode == 0
    right = summary(lab.path / "cut")
    for part in range(0, PARTS + (0 if cut else 1)):
        copy_of_cut(lab)
        path = lab.path / "copy" / name
        path.write_bytes(damaged(path.read_bytes(), part, cut))
        derived = name in ("analysis.h5", "summary.json")  # written again by the analysis: a few parts suffice
        for verb in ("analyse", "resume") if not derived or part % 10 == 0 else ("analyse",):
            result = lab(verb, "copy", "--quiet", timeout=60)
            if result.returncode != 0:
                assert_clear(result)
            elif verb == "analyse":
                assert summary(lab.path / "copy") == right
            else:
                assert_same_run(lab.path / "whole", lab.path / "copy")


def test_a_changed_scene_is_not_resumed(interrupted):
    lab = interrupted
    copy_of_cut(lab)
    path = lab.path / "copy/scene.toml"
    path.write_text(path.read_text().replace("friction = 0.5", "friction = 0.4"))
    for _ in ("with checkpoints", "without"):
        for verb in ("resume", "analyse"):
            result = lab(verb, "copy")
            assert_clear(result)
            assert "is not the scene" in result.stderr
        shutil.rmtree(lab.path / "copy/checkpoints", ignore_errors=True)


def test_changed_analysis_settings_are_used_and_reported(interrupted):
    lab = interrupted
    copy_of_cut(lab)
    path = lab.path / "copy/scene.toml"
    path.write_text(path.read_text().replace("bin_width = 2", "bin_width = 3"))
    result = lab("analyse", "copy", "--quiet")
    assert result.returncode == 0 and "its [analysis] is taken as it is now" in result.stderr


def test_a_damaged_frame_is_reported_and_the_run_resumes(interrupted):
    lab = interrupted
    copy_of_cut(lab)
    path = lab.path / "copy/frames/000000.h5"
    path.write_bytes(path.read_bytes()[:-1])
    result = resumed(lab, "copy")
    assert result.stderr.startswith("repose: copy/frames/000000.h5: damaged"), result.stderr
    shutil.copy(lab.path / "cut/frames/000000.h5", path)
    assert_same_run(lab.path / "whole", lab.path / "copy")


def test_a_sweep_is_resumed_by_its_own_command(lab):
    lab.scene("points = []")
    (lab.path / "swept/scenes").mkdir(parents=True)
    lab.scene("x = 1", "swept/sweep.toml")
    result = lab("resume", "swept")
    assert result.returncode == 2 and "repose sweep swept/sweep.toml" in result.stderr


def test_a_failed_run_is_not_resumed(lab):
    text = "contact = { normal = { law = 'hooke' } }\n" + "".join(
        f"[[grain]]\nposition = [{x}, 0.0]\n" for x in (0.0, 0.05)) + "[stop]\ntime = 5\n"
    lab.run(text, expect=1)
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


@pytest.mark.parametrize("cut", [True, False], ids=["cut", "changed"])
@pytest.mark.parametrize("name", ["run.h5", "analysis.h5", "summary.json", "frames/000000.h5"])
def test_damaged_files_are_not_read_by_the_package(interrupted, package, name, cut):
    """The Python package reports the damage in one line, or its data are right."""
    lab = interrupted
    right = package.open(lab.path / "cut")
    for part in range(0, PARTS + (0 if cut else 1)):
        copy_of_cut(lab)
        path = lab.path / "copy" / name
        path.write_bytes(damaged(path.read_bytes(), part, cut))
        try:
            found = package.open(lab.path / "copy")
            assert repr(found.attributes) == repr(right.attributes) and found.summary == right.summary
            assert same_state(found.state, right.state) and same_state(found.frame(0), right.frame(0))
            assert found.analysis["surface"].keys() == right.analysis["surface"].keys()
            intact = path.read_bytes()[512:] == (lab.path / "cut" / name).read_bytes()[512:]
            assert intact, f"part {part} was read as if nothing had happened"
        except package.RunFolderError as error:
            assert name.split("/")[-1] in str(error) and "\n" not in str(error)


def same_state(first, second):
    return all(getattr(first.grains, name).tobytes() == getattr(second.grains, name).tobytes()
               for name in ("id", "position", "velocity", "spin", "radius"))


@pytest.fixture
def package(monkeypatch):
    monkeypatch.syspath_prepend(str(Path(__file__).resolve().parents[2] / "python"))
    import repose

    return repose


def test_the_package_reports_once_that_it_cannot_detect_damage(undisturbed, package, monkeypatch):
    from repose import hdf5

    monkeypatch.setattr(hdf5, "xxhash", None)
    hdf5.can_hash.cache_clear()
    with pytest.warns(UserWarning, match="no Python package xxhash") as caught:
        package.open(undisturbed.path / "whole")
        package.open(undisturbed.path / "whole")
    assert len(caught) == 1
    hdf5.can_hash.cache_clear()
