# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The folders into which a run may be written, and their content after a full disk."""

import os
from pathlib import Path

import pytest
from conftest import HEAP, datasets, everything_in, summary, text_attribute


def contents(folder):
    return {p: (folder / p).read_bytes() for p in everything_in(folder) if (folder / p).is_file()}


@pytest.fixture
def scene(lab):
    lab.scene(HEAP.replace("count = 40", "count = 3"))
    return "scene.toml"


def test_folder_not_empty(lab, scene):
    (lab.path / "full").mkdir()
    (lab.path / "full/letter.txt").write_text("dear\n")
    lab.refused("run", scene, "--out", "full", parts=["full: folder is not empty; choose another --out, or --overwrite"])
    lab.refused("run", scene, "--out", "full", "--overwrite",
                parts=["full: folder is not empty and holds no run, so --overwrite leaves it alone"])
    assert (lab.path / "full/letter.txt").read_text() == "dear\n"


def test_folder_with_half_a_run_is_not_changed(lab, scene):
    (lab.path / "mine").mkdir()
    (lab.path / "mine/scene.toml").write_text("precious\n")
    (lab.path / "mine/frames").mkdir()
    (lab.path / "mine/frames/000000.h5").write_text("precious\n")
    lab.refused("run", scene, "--out", "mine", "--overwrite", parts=["holds no run"])
    assert (lab.path / "mine/scene.toml").read_text() == "precious\n"


def test_out_is_a_file_or_below_one(lab, scene):
    (lab.path / "letter.txt").write_text("dear\n")
    lab.refused("run", scene, "--out", "letter.txt", parts=["letter.txt: cannot write a run here: is a file"])
    lab.refused("run", scene, "--out", "letter.txt", "--overwrite", parts=["letter.txt: cannot write a run here: is a file"])
    lab.refused("run", scene, "--out", "letter.txt/a/b", parts=["letter.txt/a/b: cannot write a run here: ", "letter.txt is a file"])
    lab.refused("run", scene, "--out", scene, parts=["is a file"])
    assert (lab.path / "letter.txt").read_text() == "dear\n"


def test_out_is_a_broken_link(lab, scene):
    os.symlink("nowhere/at/all", lab.path / "link")
    lab.refused("run", scene, "--out", "link", parts=["link: cannot "])


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="no /proc here")
def test_out_where_the_system_refuses(lab, scene):
    for out in ("/proc/repose-out", "/proc/a/b"):
        said = lab.refused("run", scene, "--out", out, parts=[out])
        assert "cannot " in said and len(said.strip().splitlines()) == 1, said


def test_name_too_long(lab, scene):
    said = lab.refused("run", scene, "--out", "x" * 300)
    assert "File name too long" in said


def test_running_the_complete_scene_over_its_own_run(lab, scene):
    assert lab("run", scene, "--out", "out", "--quiet").returncode == 0
    before = datasets(lab.path / "out/run.h5")
    result = lab("run", "out/scene.toml", "--out", "out", "--overwrite", "--quiet")
    assert result.returncode == 0, result.stderr
    after = datasets(lab.path / "out/run.h5")
    assert all(before[name].tobytes() == after[name].tobytes() for name in before)


def test_default_folder_has_the_name_of_the_scene(lab):
    lab.scene(HEAP.replace("count = 40", "count = 2"), "little.toml")
    assert lab("run", "little.toml", "--quiet").returncode == 0
    assert (lab.path / "little/run.h5").is_file()
    lab.refused("run", "little.toml", "--quiet", parts=["little: folder is not empty"])


def test_empty_and_nested_folders_are_fine(lab, scene):
    (lab.path / "empty").mkdir()
    for out in ("empty", "a/b/c", "slash/"):
        result = lab("run", scene, "--out", out, "--quiet")
        assert result.returncode == 0, result.stderr
        assert (lab.path / out / "summary.json").is_file()


def test_overwrite_replaces_a_run_and_keeps_other_files(lab):
    text = HEAP + "[output]\nframes = 5\n"
    out = lab.run(text)
    frames = len(list((out / "frames").iterdir()))
    assert frames > 3
    (out / "notes.txt").write_text("mine\n")
    lab.run(text.replace("frames = 5", "frames = 0"), "--seed", "7", "--overwrite")
    assert (out / "notes.txt").read_text() == "mine\n"
    assert summary(out)["seed"] == 7
    assert not (out / "frames").exists() or not list((out / "frames").iterdir())
    assert "frames" not in {name.split("/")[1] for name in datasets(out / "run.h5")}


def test_a_bad_scene_with_overwrite_keeps_the_older_run(lab, scene):
    assert lab("run", scene, "--out", "out", "--quiet").returncode == 0
    before = contents(lab.path / "out")
    lab.refused("run", scene, "--out", "out", "--overwrite", "--set", "gravity=-1", parts=["gravity = -1"])
    assert contents(lab.path / "out") == before


# --- a full disk, simulated by a limit on the size of files in blocks of 1024 bytes

def test_disk_full_at_the_start(lab, scene):
    for blocks, name in ((0, "out/scene.toml"), (1, "scene.toml"), (6, "out/run.h5")):
        said = lab.refused("run", scene, "--out", "out", before=f"ulimit -f {blocks}", parts=[name, "cannot write", "File too large"])
        assert len(said.strip().splitlines()) == 1, said
        assert not (lab.path / "out").exists()


def test_disk_full_at_the_start_below_new_folders(lab, scene):
    lab.refused("run", scene, "--out", "a/b/c", before="ulimit -f 6", parts=["a/b/c/run.h5", "File too large"])
    assert not (lab.path / "a").exists()


def test_disk_full_at_the_start_keeps_an_existing_folder(lab, scene):
    (lab.path / "empty").mkdir()
    lab.refused("run", scene, "--out", "empty", before="ulimit -f 6", parts=["empty/run.h5"])
    assert everything_in(lab.path / "empty") == []


def test_disk_full_at_the_start_of_an_overwrite(lab, scene):
    """A run that cannot be replaced is not lost."""
    assert lab("run", scene, "--out", "out", "--quiet").returncode == 0
    before = contents(lab.path / "out")
    result = lab("run", scene, "--out", "out", "--overwrite", before="ulimit -f 6")
    assert result.returncode == 2
    assert contents(lab.path / "out") == before


@pytest.mark.parametrize("what", ["series", "grains"])
def test_disk_full_later(lab, what):
    """The start fits and a later output does not: the folder keeps the last complete output."""
    if what == "series":  # six columns of eight bytes a row
        text = HEAP.replace("count = 40", "count = 2").replace("at_rest = 1e-6\n", "") + "[output]\nframes = 5\nseries = 0.05\n"
    else:
        text = HEAP.replace("half_width = 8", "half_width = 20").replace("count = 40", "count = 150")
        text = text.replace("rate = 1.0", "rate = 5.0").replace("height = 10\nhalf_width = 2", "height = 20\nhalf_width = 6")
        text += "[output]\nframes = 2\n"
    lab.scene(text)
    result = lab("run", "scene.toml", "--out", "out", "--quiet", before="ulimit -f 64")
    assert result.returncode == 1, result.stderr
    assert ".h5" in result.stderr and "cannot write" in result.stderr and "File too large" in result.stderr
    assert len(result.stderr.strip().splitlines()) == 1, result.stderr
    out = lab.path / "out"
    assert not [p for p in everything_in(out) if p.endswith(".tmp")]
    assert text_attribute(out / "run.h5", "status") == "running"
    found = datasets(out / "run.h5")  # opens every link
    assert len(found["/series/time"]) > 5
    assert any(name.startswith("/frames/") for name in found)
    assert summary(out)["status"] == "running"
