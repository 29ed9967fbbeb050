# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Rows of the series, moments of the track and frames each come at an interval of their own."""

import h5py
import numpy as np
import pytest
from conftest import HEAP, datasets, summary

DROP = """[method]
kind = "contact-dynamics"
time_step = 0.005
[base]
kind = "plane"
[[grain]]
position = [0.0, 1.5]
[stop]
time = 4.0
[output]
track = 0.1
frames = 0.3
"""


def times(out):
    """The times of the rows of the series, of the moments of the track, and of the frames."""
    found = datasets(out / "run.h5")
    with h5py.File(out / "run.h5") as file:
        frames = [file[f"frames/{name}"].attrs["time"] for name in sorted(file.get("frames", ()))]
        track = [t for name in sorted(file.get("track", ())) for t in file[f"track/{name}/time"][()]]
    return found["/series/time"], np.array(track), np.array(frames)


def test_track_and_frames_do_not_wait_for_rows_of_the_series(lab):
    series, track, frames = times(lab.run(DROP))
    assert series == pytest.approx(np.arange(1, 5))
    assert track == pytest.approx(0.1 * np.arange(1, 41))
    assert frames == pytest.approx(0.3 * np.arange(1, 14))


def test_intervals_between_rows(lab):
    series, track, frames = times(lab.run(DROP, "--set", "output.series=0.7", "--set", "output.track=0.8",
                                          "--set", "output.frames=1.5"))
    assert series == pytest.approx([0.7, 1.4, 2.1, 2.8, 3.5, 4.0])  # the last row is that of the end
    assert track == pytest.approx([0.8, 1.6, 2.4, 3.2, 4.0])
    assert frames == pytest.approx([1.5, 3.0])


def test_the_track_ends_with_the_run(lab):
    series, track, _ = times(lab.run(DROP, "--set", "output.track=0.9"))
    assert track == pytest.approx([0.9, 1.8, 2.7, 3.6, 4.0])
    assert series[-1] == track[-1]


def test_output_changes_no_bit(lab):
    hashes = [summary(lab.run(HEAP, "--set", f"output.frames={frames}", "--set", f"output.track={track}", out=out))[
        "state_hash"] for out, frames, track in (("none", 0, 0), ("often", 0.37, 0.11))]
    assert hashes[0] == hashes[1]


# Grains that have left the box since the last row are in no frame; the series counts them with its next row.
def test_frames_hold_no_lost_grains(lab):
    rain = "".join(f"[[grain]]\nposition = [{x}, 0.0]\n" for x in range(-3, 4))
    scene = rain + "[box]\nfloor = -2.1\n[stop]\ntime = 4.5\n[output]\nseries = 4.0\nframes = 1.0\n"
    out = lab.run(scene)
    with h5py.File(out / "run.h5") as file:
        counts = [len(file[f"frames/{name}/grains/id"]) for name in sorted(file["frames"])]
    assert counts == [7, 7, 0, 0]  # after 2.0 they have fallen by 2
