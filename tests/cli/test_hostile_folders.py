# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pipes in the place of files, folders that change under a run, two programs in one folder, files of other runs and
forged ones, and sweeps that cannot be meant."""

import os
import shutil
import signal
import subprocess
import time

import numpy as np
import pytest
from conftest import HEAP, LIMIT, PROGRAM, assert_plain, changed, everything_in

SMALL = HEAP.replace("count = 40", "count = 3")
LONG = HEAP.replace("at_rest = 1e-6\n", "").replace("time = 500", "time = 1e6")


# --- files that are none

def fifo(path):
    path.unlink(missing_ok=True)
    os.mkfifo(path)


@pytest.mark.parametrize("path", ["/dev/zero", "/dev/null", "pipe"])
@pytest.mark.parametrize("verb", ["check", "run", "sweep", "solve"])
def test_only_regular_files_are_read(lab, verb, path):
    os.mkfifo(lab.path / "pipe")
    result = lab(verb, path)
    assert result.returncode == 2 and "is no regular file" in result.stderr, result.stderr


@pytest.mark.parametrize("name", ["run.h5", "scene.toml", "summary.json", "analysis.h5", "frames/000000.h5"])
def test_a_pipe_in_a_run_folder_blocks_nothing(lab, heap, name):
    shutil.copytree(heap, lab.path / "out")
    fifo(lab.path / "out" / name)
    for words in (["analyse"], ["resume"], ["plot", "--only", "heap", "--format", "png"], ["export", "--to", "csv"],
                  ["export", "--to", "vtk"]):
        if name in ("summary.json", "analysis.h5") and words[0] in ("analyse", "resume"):
            continue  # written again
        result = lab(words[0], "out", *words[1:])
        assert result.returncode in (0, 1, 2)
        assert_plain(result.stderr)
        if name == "run.h5":
            assert result.returncode == 2 and "is no regular file" in result.stderr, (words, result.stderr)


def test_tables_and_pictures_follow_links_and_keep_pipes(lab):
    (lab.path / "real").mkdir()
    for name, words in (("table.csv", ["--csv"]), ("picture.png", ["--plot"])):
        (lab.path / name).symlink_to(f"real/{name}")
        for _ in ("no file behind the link", "a file behind it"):
            assert lab("theory", "pile-continuum", *words, name).returncode == 0
            assert (lab.path / name).is_symlink() and (lab.path / "real" / name).stat().st_size > 100
        pipe = f"pipe-{name}"
        os.mkfifo(lab.path / pipe)
        result = lab.shell(f"cat {pipe} > got & $REPOSE theory pile-continuum {words[0]} {pipe}; status=$?; wait; exit $status")
        assert result.returncode == 0, result.stderr
        assert (lab.path / "got").read_bytes() == (lab.path / "real" / name).read_bytes()
        assert (lab.path / pipe).is_fifo()


def test_a_device_stays_one(lab):
    assert lab("theory", "pile-continuum", "--csv", "/dev/null").returncode == 0
    result = lab("theory", "pile-continuum", "--csv", "/dev/full")
    assert result.returncode == 1 and "/dev/full: cannot write: No space left on device" in result.stderr
    assert not os.path.isfile("/dev/null") and not os.path.isfile("/dev/full")
    printed = lab("theory", "pile-continuum").stdout
    assert lab.shell("$REPOSE theory pile-continuum --csv /dev/stdout > table.csv").returncode == 0
    assert (lab.path / "table.csv").read_text() == printed


# --- folders that change, or that two programs use

def running(lab, *words):
    return subprocess.Popen([PROGRAM, *words], cwd=lab.path, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def wait_for(condition):
    end = time.monotonic() + LIMIT
    while not condition():
        assert time.monotonic() < end, "too late"
        time.sleep(0.02)


@pytest.mark.parametrize("change", ["renamed", "deleted", "replaced"])
def test_a_run_whose_folder_goes_stops_and_says_so(lab, change):
    lab.scene(LONG + "[output]\nframes = 5\n")
    process = running(lab, "run", "scene.toml", "--out", "out", "--quiet")
    wait_for(lambda: list((lab.path / "out").glob("frames/*.h5")))
    (lab.path / "out").rename(lab.path / "moved")
    if change == "deleted":
        shutil.rmtree(lab.path / "moved")
    if change == "replaced":
        (lab.path / "out").mkdir()
    _, said = process.communicate(timeout=LIMIT)
    assert process.returncode == 1
    assert said == "out: this folder was moved or deleted while the program wrote into it\n" or "cannot write" in said
    assert not (lab.path / "out").exists() or not everything_in(lab.path / "out")


SWEEP = "scene = 'scene.toml'\nseeds = 3\n"


def test_two_sweeps_on_one_folder(lab):
    lab.scene(LONG)
    lab.scene(SWEEP, "sweep.toml")
    process = running(lab, "sweep", "sweep.toml", "--out", "out", "--quiet", "--threads", "1")
    wait_for(lambda: list((lab.path / "out").glob("members/*/*/run.h5")))
    for more in ([], ["--overwrite"]):
        result = lab("sweep", "sweep.toml", "--out", "out", *more)
        assert result.returncode == 2 and "written here by another program" in result.stderr, result.stderr
    assert lab("analyse", "out").returncode == 2
    assert list((lab.path / "out").glob("members/*/*/run.h5"))
    process.send_signal(signal.SIGINT)
    assert process.wait(60) == 130


def test_a_sweep_whose_folder_goes_stops_and_says_so(lab):
    lab.scene(HEAP)
    lab.scene("scene = 'scene.toml'\nseeds = 500\n", "sweep.toml")
    process = running(lab, "sweep", "sweep.toml", "--out", "out", "--quiet")
    wait_for(lambda: list((lab.path / "out").glob("members/*/*/summary.json")))
    (lab.path / "out").rename(lab.path / "moved")
    _, said = process.communicate(timeout=LIMIT)
    assert process.returncode == 1 and "was moved or deleted" in said, said
    assert not (lab.path / "out/sweep.toml").exists()


# --- sweeps

def vary(count, keys):
    values = ", ".join(f"{0.1 + k / 1e4:.4f}" for k in range(count))
    return SWEEP + "[vary]\n" + "".join(f"{key} = [{values}]\n" for key in keys)


def claim(measure):
    return SWEEP + f"[[claim]]\ntext = 'x'\nmeasure = '{measure}'\npoint = 'scene'\nabove = 1\n"


WRONG_SWEEPS = {
    "a thousand million points": (vary(1000, ["contact.friction", "source.rate", "grains.polydispersity"]),
                                  "vary and point make 1e+09 points: at most 10000"),
    "claim on no measure": (claim("angel_of_repose"), 'claim[0].measure = "angel_of_repose": no such measure'),
    "claim on no part": (claim("angle_of_repose_deg.median"), "no such measure"),
    "claim on two numbers": (claim("packing.solid_fraction"), "packing.solid_fraction.mean or .error"),
    "claim on the run": (claim("wall_seconds"), "no such measure"),
    "no name": (SWEEP + "[[point]]\nname = ''\n", 'point[0].name = "": must not be empty'),
    "long name": (SWEEP + f"[[point]]\nname = '{'x' * 300}'\n", "the name of a point has 300 letters"),
    "seed beyond doubles": ("scene = 'scene.toml'\nseeds = [9223372036854775807]\n", "seeds: 9223372036854775807: must be"),
    "long title": (f"title = '{'x' * 70000}'\n" + SWEEP, "title: has 70000 bytes"),
}


@pytest.mark.parametrize("name", WRONG_SWEEPS)
def test_wrong_sweeps_are_found_before_anything_runs(lab, name):
    text, part = WRONG_SWEEPS[name]
    lab.scene(SMALL)
    lab.scene(text, "sweep.toml")
    assert_plain(lab.refused("sweep", "sweep.toml", "--out", "out", parts=["sweep.toml", part]))


@pytest.mark.parametrize("harm", ["missing", "damaged", "a pipe"])
def test_a_member_without_its_run_is_run_again(lab, harm):
    lab.scene(SMALL)
    lab.scene(SWEEP, "sweep.toml")
    assert lab("sweep", "sweep.toml", "--out", "out", "--quiet").returncode == 0
    table = (lab.path / "out/table.csv").read_bytes()
    path = lab.path / "out/members/scene/seed-2/run.h5"
    content = path.read_bytes()
    path.unlink()
    if harm == "damaged":
        path.write_bytes(content[:-1])
    if harm == "a pipe":
        os.mkfifo(path)
    assert lab("sweep", "sweep.toml", "--out", "out", "--quiet").returncode == 0
    assert path.read_bytes()[:19] == b"repose sealed file\n"
    assert (lab.path / "out/table.csv").read_bytes() == table


# --- files of other runs, and forged ones

@pytest.fixture(scope="module")
def two_runs(tmp_path_factory):
    """The same scene with two seeds, with frames and a track."""
    from conftest import Laboratory

    lab = Laboratory(tmp_path_factory.mktemp("two"))
    text = HEAP.replace("count = 40", "count = 10") + "[output]\nframes = 5\ntrack = 5\n"
    lab.run(text, "--seed", "1", out="one")
    lab.run(text, "--seed", "2", out="two")
    return lab.path


@pytest.mark.parametrize("name, words", [
    ("run.h5", ["analyse"]), ("run.h5", ["export", "--to", "vtk"]), ("run.h5", ["plot"]),
    ("analysis.h5", ["plot"]), ("analysis.h5", ["export", "--to", "csv"]),
    ("frames/000001.h5", ["plot", "--frame", "1"]), ("frames/000001.h5", ["export", "--to", "vtk"]),
    ("frames/000001.h5", ["export", "--to", "ovito"]), ("track/000000.h5", ["analyse"]),
])
def test_a_file_of_another_run_is_refused(lab, two_runs, name, words):
    shutil.copytree(two_runs / "one", lab.path / "out")
    shutil.copy(two_runs / "two" / name, lab.path / "out" / name)
    result = lab(words[0], "out", *words[1:])
    assert result.returncode == 2, result.stderr
    lines = [line for line in result.stderr.strip().splitlines() if "has changed since the run" not in line]
    assert len(lines) == 1 and "out/" in lines[0], result.stderr


def test_an_array_that_is_larger_than_its_file_is_refused(lab, heap):
    shutil.copytree(heap, lab.path / "out")
    with changed(lab.path / "out/run.h5") as file:
        del file["contacts/normal"]
        file.create_dataset("contacts/normal", shape=(2_000_000_000, 2), dtype="f8", chunks=(1024, 2))
    for words in (["analyse"], ["export", "--to", "vtk"], ["export", "--to", "csv"], ["plot"]):
        result = lab(words[0], "out", *words[1:], before="ulimit -v 4000000")
        assert result.returncode == 2 and "is larger than its content" in result.stderr, (words, result.stderr)


def forge_ids(file):
    file["grains/id"][1] = file["grains/id"][0]


def forge_length(file):
    values = file["grains/radius"][()]
    del file["grains/radius"]
    file["grains/radius"] = values[:-1]


def forge_rank(file):
    values = file["grains/position"][()]
    del file["grains/position"]
    file["grains/position"] = np.stack([values, values])


def forge_type(file):
    del file["grains/mass"]
    file["grains/mass"] = np.array([b"heavy"] * 3)


def forge_radius(file):
    file["grains/radius"][2] = -1.0


def forge_lever(file):
    file["contacts/lever"][0] = 1e308


def forge_place(file):
    file["grains/position"][0] = [0.0, 1e100]


@pytest.mark.parametrize("forge", [forge_lever, forge_place, forge_ids, forge_length, forge_rank, forge_type, forge_radius])
def test_forged_grains_are_refused(lab, heap, forge):
    shutil.copytree(heap, lab.path / "out")
    with changed(lab.path / "out/run.h5") as file:
        forge(file)
    for words in (["analyse"], ["export", "--to", "vtk"], ["export", "--to", "contact-problem"]):
        result = lab(words[0], "out", *words[1:])
        assert result.returncode == 2 and result.stderr.startswith("out/run.h5: "), (words, result.stderr)
        assert_plain(result.stderr)
