# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Damaged and changed files of an interrupted run: the damage is reported, and nothing wrong comes out."""

import re
import shutil
import signal
from pathlib import Path

import pytest
from conftest import summary
from interruption import PARTS, SCENE, assert_same_run, resumed, started, wait_until


@pytest.fixture(scope="module")
def interrupted(tmp_path_factory):
    """A small interrupted run with both checkpoints, and its final state."""
    from conftest import Laboratory

    lab = Laboratory(tmp_path_factory.mktemp("interrupted"))
    text = SCENE.replace("count = 200", "count = 60").replace("half_width = 12", "half_width = 8").replace(
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
            result = lab(verb, "copy", "--quiet")
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
    assert result.returncode == 0 and "uses its [analysis] as it stands now" in result.stderr


def test_a_damaged_frame_is_reported_and_the_run_resumes(interrupted):
    lab = interrupted
    copy_of_cut(lab)
    path = lab.path / "copy/frames/000000.h5"
    path.write_bytes(path.read_bytes()[:-1])
    result = resumed(lab, "copy")
    assert result.stderr.startswith("repose: copy/frames/000000.h5: damaged"), result.stderr
    shutil.copy(lab.path / "cut/frames/000000.h5", path)
    assert_same_run(lab.path / "whole", lab.path / "copy")


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


def test_the_package_reports_once_that_it_cannot_detect_damage(interrupted, package, monkeypatch):
    from repose import hdf5

    monkeypatch.setattr(hdf5, "xxhash", None)
    hdf5.can_hash.cache_clear()
    with pytest.warns(UserWarning, match="no Python package xxhash") as caught:
        package.open(interrupted.path / "cut")
        package.open(interrupted.path / "cut")
    assert len(caught) == 1
    hdf5.can_hash.cache_clear()
