# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the frames of a run have one size, one box and one scale, so that they make a movie."""

from dataclasses import replace

import h5py
import numpy as np
import pytest
from matplotlib.image import imread
from synthetic import base_row, pyramid, write_run

import repose
from repose.pictures.run import RUN_PICTURES
from repose.pictures.run.common_axes import common_axes
from repose.pictures.run.visible_box import visible_box
from repose.plot import main

OF_FRAMES = ("heap", "density", "forces")


@pytest.fixture
def folder(tmp_path):
    """The first frame is empty but for the base, the second has a third of the heap and larger forces."""
    folder = write_run(tmp_path / "run", pyramid(12), base_row(30))
    with h5py.File(folder / "run.h5", "a") as file:
        file["frames/000001"] = h5py.ExternalLink("frames/000001.h5", "/")
    first, second = (folder / "frames" / f"00000{k}.h5" for k in range(2))
    second.write_bytes(first.read_bytes())
    for path, kept in ((first, 60), (second, 90)):
        with h5py.File(path, "a") as file:
            ids = file["grains/id"][()][:kept]
            cut(file["grains"], np.arange(len(file["grains/id"])) < kept)
            cut(file["contacts"], np.isin(file["contacts/grains"][()], ids).all(axis=1))
            file["contacts/normal_force"][()] = 50.0
    return folder


def cut(group, kept):
    for name in list(group):
        values = group[name][()][kept]
        del group[name]
        group[name] = values


def sizes(folder, *options):
    arguments = [str(folder), "--only", ",".join(OF_FRAMES), "--format", "png", "--dpi", "50", *options]
    assert main(arguments) == 0
    return {path.stem: imread(path).shape[:2] for path in (folder / "pictures").iterdir()}


@pytest.mark.filterwarnings("error")
def test_all_frames_have_one_size(folder):
    drawn = sizes(folder, "--frame", "all")
    assert sorted(drawn) == sorted(f"{name}-00000{k}" for name in OF_FRAMES for k in range(2))
    drawn |= sizes(folder, "--same-axes")
    for name in OF_FRAMES:
        assert len({size for each, size in drawn.items() if each.startswith(name)}) == 1


def test_one_frame_has_the_size_of_all(folder):
    together = sizes(folder, "--frame", "all")
    assert sizes(folder, "--frame", "1") == together


def test_own_axes_differ(folder):
    shared = sizes(folder, "--frame", "1")
    assert sizes(folder, "--frame", "1", "--own-axes")["heap-000001"] != shared["heap-000001"]


def test_common_box_holds_those_of_all_states(folder):
    run = repose.open(folder)
    axes = common_axes(run)
    whole, part = visible_box(run, run.state), visible_box(run, run.frame(1))
    assert (axes.box.x_min, axes.box.x_max) == (min(whole.x_min, part.x_min), max(whole.x_max, part.x_max))
    assert (axes.box.y_min, axes.box.y_max) == (min(whole.y_min, part.y_min), max(whole.y_max, part.y_max))
    assert run.state.contacts.normal_force.max() < axes.largest_force <= 50.0


def test_grains_in_flight_do_not_widen_the_box(folder):
    before = common_axes(repose.open(folder)).box
    with h5py.File(folder / "frames" / "000000.h5", "a") as file:
        file["grains/position"][-1] = [0.0, 500.0]
        cut(file["contacts"], np.zeros(len(file["contacts/overlap"]), dtype=bool))
    assert common_axes(repose.open(folder)).box == before


def test_a_line_of_one_width_is_one_force_in_all_frames(folder):
    run = repose.open(folder)
    axes = common_axes(run)
    legends = []
    for state in (run.frame(1), run.state):
        figure = RUN_PICTURES["forces"](run, replace(state, axes=axes))
        handles = figure.legends[0].legend_handles if hasattr(figure.legends[0], "legend_handles") else figure.legends[0].legendHandles
        texts = figure.legends[0].get_texts()
        legends.append([(text.get_text(), line.get_linewidth()) for text, line in zip(texts, handles) if text.get_text()[-1].isdigit()])
    assert legends[0] == legends[1] and len(legends[0]) > 1


def test_frames_without_contacts_are_drawn_empty(folder):
    """A movie has no gaps."""
    with h5py.File(folder / "frames" / "000000.h5", "a") as file:
        cut(file["contacts"], np.zeros(len(file["contacts/overlap"]), dtype=bool))
    assert len(sizes(folder, "--frame", "all")) == 6


def test_a_run_without_frames_is_one_line(folder, capsys):
    with h5py.File(folder / "run.h5", "a") as file:
        del file["frames"]
    assert main([str(folder), "--frame", "all"]) == 2
    assert capsys.readouterr().err == f"repose plot: {folder}: no frame was saved (output.frames)\n"
