# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command line draws what a run has to show, says what it leaves out, and complains in one line."""

import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import h5py
import numpy as np
import pytest
from matplotlib.image import imread
from synthetic import base_row, pyramid, write_run

import repose
from repose.pictures import PICTURES, heap
from repose.plot import main

BED = np.concatenate([base_row(10, 0.5) + [0.5 * row, row * np.sqrt(3.0) / 2.0] for row in range(1, 6)])
FLYING = np.column_stack([np.linspace(-3.0, 3.0, 6), np.linspace(60.0, 90.0, 6)])
NOBODY = np.empty((0, 2))

NO_FORCE = "no contact carries a force that counts"
NO_TRACK = "no track: output.track = 0"
NO_CONTACTS = {
    "density": "no contacts",
    "forces": "no contact carries a force",
    "chains": NO_FORCE,
    "force_distribution": NO_FORCE,
    "voronoi": "no heap",
    "stress": "no heap",
}

RUNS = {
    "heap": dict(moving=pyramid(16), base=base_row(30)),
    "flying": dict(moving=np.concatenate([pyramid(12), FLYING]), base=base_row(30)),
    "all_flying": dict(moving=FLYING, base=base_row(10), surface=False),
    "si": dict(moving=pyramid(8), base=base_row(8), diameter=0.002, units="SI", grain_weight=3e-5),
    "failed": dict(moving=pyramid(8), base=base_row(8), status="failed"),
    "weightless": dict(moving=pyramid(8), base=base_row(8), grain_weight=0.0),
    "no_base": dict(moving=pyramid(8), surface=False),
    "plane": dict(moving=pyramid(8) - [0.0, np.sqrt(3.0) / 2.0 - 0.5], plane=True),
    "periodic": dict(moving=BED, base=base_row(10), period=20.0, surface=False),
    "one_grain": dict(moving=np.array([[0.0, 5.0]]), surface=False, rows=1),
    "column": dict(moving=np.column_stack([np.zeros(60), np.arange(1, 61)]), base=base_row(3), surface=False),
    "empty": dict(moving=NOBODY, base=base_row(10), surface=False),
    "nothing": dict(moving=NOBODY, surface=False, rows=0),
    "no_track": dict(moving=pyramid(8), base=base_row(8), track=False),
}
LEFT_OUT = {
    "all_flying": NO_CONTACTS,
    "no_base": {"base": "no row of base grains"},
    "plane": {"base": "no row of base grains"},
    "one_grain": {
        **NO_CONTACTS,
        "base": "no row of base grains",
        "energy": "fewer than two rows in the time series",
    },
    "empty": {**NO_CONTACTS, "base": "nothing rests on the base", "avalanches": NO_TRACK, "energy": "nothing moved"},
    "nothing": {
        **NO_CONTACTS,
        "heap": "no grains",
        "base": "no row of base grains",
        "avalanches": NO_TRACK,
        "energy": "fewer than two rows in the time series",
    },
    "no_track": {"avalanches": NO_TRACK},
}
WITHOUT_WALLS = {
    "budget": "no account of the energy (output.energy)",
    "walls": "no walls, or fewer than two rows in the time series",
}
NO_PACKING = dict.fromkeys(
    ("packing", "directions", "correlations", "surface"), "no packing was measured (analysis.packing)"
)

NO_THEORY = {"theory": "no theory was laid on it (repose plot DIR --theory MODEL)"}
NO_BASE = {"theory": "no row of base grains"}


def assert_shows_something(path):
    """A picture with ink, but not full of it, and more than two colours."""
    pixels = imread(path)[..., :3]
    ink = (pixels < 0.95).any(axis=-1).mean()
    assert 0.005 < ink < 0.8, f"{path.name}: {100 * ink:.1f} % of the pixels are not white"
    assert len(np.unique((pixels * 255).astype(int) @ [65536, 256, 1])) > 20


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", RUNS)
def test_draws_what_there_is(tmp_path, capsys, kind):
    folder = write_run(tmp_path / "run", **RUNS[kind])
    assert main([str(folder), "--dpi", "60"]) == 0
    printed = capsys.readouterr()
    assert printed.err == ""
    left_out = LEFT_OUT.get(kind, {}) | NO_PACKING | ({} if kind == "plane" else WITHOUT_WALLS)
    left_out |= NO_BASE if left_out.get("base") == NO_BASE["theory"] else NO_THEORY
    expected = []
    for name in PICTURES:
        if name in left_out:
            expected.append(f"{name}: not drawn: {left_out[name]}")
        else:
            expected += [str(folder / "pictures" / f"{name}.{suffix}") for suffix in ("png", "svg")]
    assert printed.out.splitlines() == expected
    files = {str(path) for path in (folder / "pictures").iterdir()}
    assert files == {line for line in expected if "not drawn" not in line}
    for path in map(Path, files):
        if path.suffix == ".png":
            assert_shows_something(path)
        else:
            assert ElementTree.parse(path).getroot().tag.endswith("svg")


def test_angle_of_a_flank_is_in_the_legend(tmp_path):
    """The slope is the square root of 3 on the left, and not defined on the right."""
    run = repose.open(write_run(tmp_path / "run", **RUNS["heap"]))
    legends = [text.get_text() for text in heap.draw(run, run.state).legends[0].get_texts()]
    assert legends == ["left flank 60.0°"]


def test_frame_and_choice(tmp_path, capsys):
    folder = write_run(tmp_path / "run", **RUNS["heap"])
    assert main([str(folder), "--only", "heap,energy", "--format", "png", "--frame", "0", "--dpi", "50"]) == 0
    assert [path.name for path in (folder / "pictures").iterdir()] == ["heap-000000.png"]
    assert "energy: not drawn: belongs to the whole run" in capsys.readouterr().out


def test_same_run_same_files(tmp_path):
    folder = write_run(tmp_path / "run", **RUNS["heap"])
    contents = []
    for _ in range(2):
        assert main([str(folder), "--only", "forces", "--dpi", "50"]) == 0
        contents.append([path.read_bytes() for path in sorted((folder / "pictures").iterdir())])
    assert contents[0] == contents[1]


def test_places_that_are_not_numbers_are_survived(tmp_path):
    folder = write_run(tmp_path / "run", **RUNS["failed"])
    with h5py.File(folder / "run.h5", "a") as file:
        file["grains/position"][-1] = np.nan
        file["contacts/normal_force"][:3] = np.nan
    assert main([str(folder), "--dpi", "50", "--format", "png"]) == 0
    assert len(list((folder / "pictures").iterdir())) == len(PICTURES) - len(WITHOUT_WALLS | NO_PACKING | NO_THEORY)


def test_many_grains_become_pixels_in_svg(tmp_path, monkeypatch):
    folder = write_run(tmp_path / "run", **RUNS["heap"])
    monkeypatch.setattr("repose.field.MOST_VECTORS", 50)
    assert main([str(folder), "--only", "heap", "--format", "svg"]) == 0
    assert "<image" in (folder / "pictures" / "heap.svg").read_text()


@pytest.mark.parametrize(
    "arguments, complaint",
    [
        (["--only", "heap,foo"], f"unknown name 'foo', choose from {', '.join(PICTURES)}"),
        (["--only", "profiles"], f"unknown name 'profiles', choose from {', '.join(PICTURES)}"),
        (["--format", "pdf"], "unknown name 'pdf', choose from png, svg"),
        (["--dpi", "many"], "'many' is not a whole number"),
        (["--frame", "last"], "'last' is not the number of a frame"),
        (["--frame", "9"], "no frame 000009 (saved: 000000 to 000000)"),
        (["--nonsense"], "unrecognized arguments"),
    ],
)
def test_wrong_options_are_one_line(tmp_path, capsys, arguments, complaint):
    folder = write_run(tmp_path / "run", **RUNS["heap"])
    assert_complains(capsys, [str(folder), *arguments], complaint)
    assert not (folder / "pictures").exists()


def test_no_folder_and_no_run_are_one_line(tmp_path, capsys):
    assert_complains(capsys, [str(tmp_path / "nowhere")], "no such folder")
    assert_complains(capsys, [str(tmp_path)], "no run.h5 or sweep.h5 in this folder")


def test_pictures_that_cannot_be_written_are_one_line(tmp_path, capsys):
    folder = write_run(tmp_path / "run", **RUNS["heap"])
    (folder / "pictures").write_text("a file in the way")
    assert_complains(capsys, [str(folder)], "pictures: cannot be written")


def assert_complains(capsys, arguments, complaint):
    try:
        status = main(arguments)
    except SystemExit as ended:
        status = ended.code
    printed = capsys.readouterr()
    assert status == 2
    assert complaint in printed.err
    assert printed.err.count("\n") == 1
    assert printed.out == ""


def test_as_a_module(tmp_path):
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).resolve().parent.parent)}
    command = [sys.executable, "-m", "repose.plot", str(tmp_path)]
    ended = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert ended.returncode == 2
    assert ended.stderr == f"repose plot: {tmp_path}: no run.h5 or sweep.h5 in this folder\n"
