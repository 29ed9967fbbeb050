# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Movies of the saved frames, read back by ffprobe."""

import json
import os
import shutil
import subprocess

import pytest
from conftest import HEAP, PROGRAM, everything_in

SCENE = HEAP + "[output]\nframes = 40\n"


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    from conftest import Laboratory

    lab = Laboratory(tmp_path_factory.mktemp("film"))
    lab.out = lab.run(SCENE)
    lab.states = len(list((lab.out / "frames").iterdir())) + 1
    return lab


def facts(path):
    said = subprocess.run(["ffprobe", "-loglevel", "error", "-count_frames", "-show_streams", "-of", "json", str(path)],
                          capture_output=True, text=True, check=True).stdout
    return json.loads(said)["streams"][0]


@pytest.mark.parametrize(("kind", "codec"), [("mp4", "h264"), ("webm", "vp9"), ("gif", "gif")])
def test_a_movie_has_every_frame_and_the_last_state(run, kind, codec):
    result = run("export", "out", "--to", "movie", "--format", kind, "--fps", "10", "--dpi", "60", "--picture", "heap")
    assert result.returncode == 0, result.stderr
    path = run.out / f"export/movie/heap.{kind}"
    stream = facts(path)
    assert stream["codec_name"] == codec and int(stream["nb_read_frames"]) == run.states
    assert stream["r_frame_rate"] == "10/1" and (kind == "gif" or stream["width"] % 2 == stream["height"] % 2 == 0)
    assert [name for name in everything_in(run.out / "export/movie") if "unfinished" in name] == []


def test_pictures_without_ffmpeg(run, tmp_path):
    """A PATH with nothing in it: the program starts Python by its full path."""
    out = tmp_path / "out"
    result = subprocess.run([PROGRAM, "export", str(run.out), "--to", "movie", "--dpi", "40", "--out", str(out)],
                            env={**os.environ, "PATH": str(tmp_path)}, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert everything_in(out) == ["forces", *(f"forces/{k:06d}.png" for k in range(run.states))]
    assert "ffmpeg" in result.stdout


def test_the_same_frames_are_the_same_film(run, tmp_path):
    for name in "ab":
        run("export", "out", "--to", "movie", "--dpi", "40", "--out", tmp_path / name)
    assert (tmp_path / "a/forces.mp4").read_bytes() == (tmp_path / "b/forces.mp4").read_bytes()


REFUSED = {
    "option of a movie": (["--to", "csv", "--fps", "3"], "--fps: for --to movie alone"),
    "frames": (["--to", "movie", "--frames", "last"], "--frames: a movie has all frames"),
    "rate": (["--to", "movie", "--fps", "0"], "'0' is not a whole number from 1 to 120"),
    "picture": (["--to", "movie", "--picture", "voronoi"], "--picture: must be one of heap, forces, density"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_a_movie_is_said_in_one_line(run, name):
    words, part = REFUSED[name]
    shutil.rmtree(run.out / "export", ignore_errors=True)
    assert run.refused("export", "out", *words, parts=[part]).count("\n") == 1


def test_a_run_without_frames_has_no_movie(lab):
    lab.run(HEAP + "[output]\nframes = 0\n")
    assert lab("export", "out", "--to", "movie").stderr == "repose export: out: no frame was saved (output.frames)\n"
    assert not (lab.path / "out/export").exists()
