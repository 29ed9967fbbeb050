# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""`repose.plot` draws every picture that a run has data for, gives a reason for the others, and reports errors in one line."""

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
from repose.pictures.run import RUN_PICTURES, heap
from repose.plot import FORMATS, main

BED = np.concatenate([base_row(10, 0.5) + [0.5 * row, row * np.sqrt(3.0) / 2.0] for row in range(1, 6)])
FLYING = np.column_stack([np.linspace(-3.0, 3.0, 6), np.linspace(60.0, 90.0, 6)])
NO_GRAINS = np.empty((0, 2))

NO_FORCE = "no contact force exceeds analysis.force_threshold"
NO_TRACK = "the run recorded no track (output.track = 0)"
NO_ROW = "there is no base of grains and no plane as base"
FEW_ROWS = "the time series has fewer than two rows"
NOT_ANALYSED = "its stability was not analysed (repose analyse DIR --stability)"
NO_SLIPS = "its slips were not looked for (repose analyse DIR --slips)"
NO_CONTACTS = {
    "density": "no contacts",
    "forces": "no contact carries a force",
    "chains": NO_FORCE,
    "strongest": NO_FORCE,
    "weakest": NO_FORCE,
    "force_distribution": NO_FORCE,
    "stability": NOT_ANALYSED,
    "slips": NO_SLIPS,
    "voronoi": "there is no heap",
    "stress": "there is no heap",
    "velocity": "there is no heap",
    "temperature": "there is no heap",
}

RUNS = {
    "heap": dict(moving=pyramid(16), base=base_row(30)),
    "flying": dict(moving=np.concatenate([pyramid(12), FLYING]), base=base_row(30)),
    "all_flying": dict(moving=FLYING, base=base_row(10), surface=False),
    "si": dict(moving=pyramid(8), base=base_row(8), diameter=0.002, units="SI", grain_weight=3e-5),
    "failed": dict(moving=pyramid(8), base=base_row(8), status="failed"),
    "weightless": dict(moving=pyramid(8), base=base_row(8), grain_weight=0.0),
    "no_base": dict(moving=pyramid(8), surface=False),
    "floor": dict(moving=pyramid(8) - [0.0, np.sqrt(3.0) / 2.0 - 0.5], floor=True),
    "periodic": dict(moving=BED, base=base_row(10), period=20.0, surface=False),
    "one_grain": dict(moving=np.array([[0.0, 5.0]]), surface=False, rows=1),
    "column": dict(moving=np.column_stack([np.zeros(60), np.arange(1, 61)]), base=base_row(3), surface=False),
    "empty": dict(moving=NO_GRAINS, base=base_row(10), surface=False),
    "nothing": dict(moving=NO_GRAINS, surface=False, rows=0),
    "no_track": dict(moving=pyramid(8), base=base_row(8), track=False),
}
NOT_DRAWN = {
    "all_flying": NO_CONTACTS,
    "no_base": {"base": NO_ROW},
    "floor": {"base": NO_ROW},
    "one_grain": {
        **NO_CONTACTS,
        "base": NO_ROW,
        "energy": FEW_ROWS,
    },
    "empty": {**NO_CONTACTS, "base": "nothing rests on the base", "avalanches": NO_TRACK, "energy": "nothing moved"},
    "nothing": {
        **NO_CONTACTS,
        "heap": "no grains",
        "base": NO_ROW,
        "avalanches": NO_TRACK,
        "energy": FEW_ROWS,
    },
    "no_track": {"avalanches": NO_TRACK},
}
NO_WALLS = {
    "budget": "the run kept no energy budget (output.energy)",
    "walls": "the run has no walls, or fewer than two rows in its time series",
}
NO_PACKING = dict.fromkeys(
    ("packing", "directions", "correlations", "surface"), "no packing was measured (analysis.packing)"
)
NO_COLUMN = {
    "column": "there are no grains between two upright walls, or its method has no forces",
    "column_motion": "there is no column between two upright walls whose floor moves",
}

NO_THEORY = {"theory": "no model was compared with it (repose plot DIR --theory MODEL)"}


def assert_shows_something(path):
    """The picture has ink but is not full of it, and has more than two colours."""
    pixels = imread(path)[..., :3]
    ink = (pixels < 0.95).any(axis=-1).mean()
    assert 0.005 < ink < 0.8, f"{path.name}: {100 * ink:.1f} % of the pixels are not white"
    assert len(np.unique((pixels * 255).astype(int) @ [65536, 256, 1])) > 20


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", RUNS)
def test_draws_every_picture_with_data(tmp_path, capsys, kind):
    folder = write_run(tmp_path / "run", **RUNS[kind])
    assert main([str(folder), "--dpi", "60"]) == 0
    printed = capsys.readouterr()
    assert printed.err == ""
    not_drawn = NOT_DRAWN.get(kind, {}) | NO_PACKING | NO_COLUMN | ({} if kind == "floor" else NO_WALLS)
    not_drawn |= {"theory": "the run has no base profile"} if not_drawn.get("base") == NO_ROW else NO_THEORY
    expected = []
    for name in RUN_PICTURES:
        if name in not_drawn:
            expected.append(f"{name}: not drawn: {not_drawn[name]}")
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


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", ["heap", "floor", "periodic"])
def test_every_picture_is_printed(tmp_path, caplog, kind):
    """PDF and EPS of all pictures; Matplotlib logs a warning where EPS would need transparency, which it lacks."""
    folder = write_run(tmp_path / "run", **RUNS[kind])
    assert main([str(folder), "--format", "pdf,eps"]) == 0
    assert not caplog.records
    heads = {"pdf": b"%PDF-1.4", "eps": b"%!PS-Adobe-3.0 EPSF-3.0"}
    files = sorted((folder / "pictures").iterdir())
    assert len(files) > 20
    for path in files:
        content = path.read_bytes()
        assert content.startswith(heads[path.suffix[1:]])
        assert path.suffix == ".eps" or b"/Type3" not in content


def test_angle_of_a_flank_is_in_the_legend(tmp_path):
    """The slope is the square root of 3 on the left and undefined on the right."""
    run = repose.open(write_run(tmp_path / "run", **RUNS["heap"]))
    legends = [text.get_text() for text in heap.draw(run, run.state).legends[0].get_texts()]
    assert legends == ["left flank 60.0°"]


def test_frame_and_choice(tmp_path, capsys):
    folder = write_run(tmp_path / "run", **RUNS["heap"])
    assert main([str(folder), "--only", "heap,energy", "--format", "png", "--frame", "0", "--dpi", "50"]) == 0
    assert [path.name for path in (folder / "pictures").iterdir()] == ["heap-000000.png"]
    assert "energy: not drawn: it shows the whole run, not a frame" in capsys.readouterr().out


def test_same_run_same_files(tmp_path):
    """In every format."""
    folder = write_run(tmp_path / "run", **RUNS["heap"])
    contents = []
    for _ in range(2):
        assert main([str(folder), "--only", "forces", "--dpi", "50", "--format", ",".join(FORMATS)]) == 0
        contents.append([path.read_bytes() for path in sorted((folder / "pictures").iterdir())])
    assert contents[0] == contents[1]


def test_draws_runs_with_positions_and_forces_that_are_nan(tmp_path):
    folder = write_run(tmp_path / "run", **RUNS["failed"])
    with h5py.File(folder / "run.h5", "a") as file:
        file["grains/position"][-1] = np.nan
        file["contacts/normal_force"][:3] = np.nan
    assert main([str(folder), "--dpi", "50", "--format", "png"]) == 0
    assert len(list((folder / "pictures").iterdir())) == len(RUN_PICTURES) - len(NO_WALLS | NO_COLUMN | NO_PACKING | NO_THEORY)


@pytest.mark.filterwarnings("error")
def test_every_picture_of_many_grains_is_printed(tmp_path, monkeypatch, caplog):
    folder = write_run(tmp_path / "run", **RUNS["heap"])
    monkeypatch.setattr("repose.pictures.run.grain_panel.MOST_VECTOR_GRAINS", 50)
    assert main([str(folder), "--format", ",".join(FORMATS), "--dpi", "50"]) == 0
    assert not caplog.records
    drawn = RUN_PICTURES.keys() - (NO_WALLS | NO_COLUMN | NO_PACKING | NO_THEORY).keys()
    assert len(list((folder / "pictures").iterdir())) == len(FORMATS) * len(drawn)


def test_many_grains_become_pixels_in_svg(tmp_path, monkeypatch):
    folder = write_run(tmp_path / "run", **RUNS["heap"])
    monkeypatch.setattr("repose.pictures.run.grain_panel.MOST_VECTOR_GRAINS", 50)
    assert main([str(folder), "--only", "heap", "--format", "svg"]) == 0
    assert "<image" in (folder / "pictures" / "heap.svg").read_text()


@pytest.mark.parametrize(
    "arguments, complaint",
    [
        (["--only", "heap,foo"], f"unknown name 'foo', choose from {', '.join(RUN_PICTURES)}"),
        (["--only", "profiles"], f"unknown name 'profiles', choose from {', '.join(RUN_PICTURES)}"),
        (["--format", "gif"], "unknown name 'gif', choose from png, svg, pdf, eps"),
        (["--dpi", "many"], "'many' is not a whole number"),
        (["--frame", "last"], "'last' is not the number of a frame"),
        (["--frame", "9"], "no frame 000009 (saved: 000000 to 000000)"),
        (["--same-axes", "--own-axes"], "not allowed with argument"),
        (["--nonsense"], "unrecognized arguments"),
    ],
)
def test_wrong_options_are_one_line(tmp_path, capsys, arguments, complaint):
    folder = write_run(tmp_path / "run", **RUNS["heap"])
    assert_reports(capsys, [str(folder), *arguments], complaint)
    assert not (folder / "pictures").exists()


def test_no_folder_and_no_run_are_one_line(tmp_path, capsys):
    assert_reports(capsys, [str(tmp_path / "nowhere")], "no such folder")
    assert_reports(capsys, [str(tmp_path)], "no run.h5 or sweep.h5 in this folder")


def test_pictures_that_cannot_be_written_are_one_line(tmp_path, capsys):
    folder = write_run(tmp_path / "run", **RUNS["heap"])
    (folder / "pictures").write_text("a file in the way")
    assert_reports(capsys, [str(folder)], "pictures: cannot be written")


def assert_reports(capsys, arguments, complaint):
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
