# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of grains: the box that they show, and sizes and places of their shapes."""

import matplotlib
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from synthetic import base_row, pyramid, write_run

import repose
from repose import style
from repose.pictures.run.base import running_mean
from repose.pictures.run.grain_panel import make_panel
from repose.pictures.run.shapes import add_discs, centre_lines
from repose.pictures.run.visible_box import supported, visible_box


def flying(count):
    """Centres of grains high above a heap."""
    return np.column_stack([np.linspace(-3.0, 3.0, count), np.linspace(60.0, 90.0, count)])


def test_grains_in_flight_are_not_supported(tmp_path):
    grains = np.concatenate([pyramid(8), flying(5)])
    run = repose.open(write_run(tmp_path / "run", grains, base_row(40)))
    assert supported(run.state).sum() == len(pyramid(8))
    box = visible_box(run, run.state)
    assert box.y_max < 10.0
    assert box.x_max - box.x_min < 20.0


def test_a_bed_that_hops_is_shown_whole(tmp_path):
    """Rows above a gap of 1.5 diameters belong to the bed; a grain 4 diameters above these does not."""
    rows = np.concatenate([base_row(6) + [0.0, 1.0], base_row(6) + [0.0, 2.5], base_row(6) + [0.0, 3.5], [[0.0, 7.5]]])
    run = repose.open(write_run(tmp_path / "run", rows, base_row(6)))
    box = visible_box(run, run.state)
    assert 4.0 < box.y_max < 7.0


def test_pair_in_flight_is_not_supported(tmp_path):
    pair = np.array([[0.0, 50.0], [1.0, 50.0]])
    run = repose.open(write_run(tmp_path / "run", np.concatenate([pyramid(4), pair]), base_row(4)))
    assert (run.state.contacts.grains == run.state.grains.id[-1]).any()
    assert not supported(run.state)[-2:].any()


def test_distant_grain_is_outside_and_counted(tmp_path):
    grains = np.concatenate([pyramid(8), [[30.0, np.sqrt(3.0) / 2.0]]])
    run = repose.open(write_run(tmp_path / "run", grains, base_row(40)))
    assert supported(run.state)[-1]
    assert visible_box(run, run.state).x_max < 10.0
    figure = make_panel(run, run.state, with_legend=False).figure
    assert "36 grains (1 outside the picture), t = 120" in figure.texts[0].get_text()


def test_grains_are_shown_when_all_are_in_flight(tmp_path):
    run = repose.open(write_run(tmp_path / "run", flying(5)))
    box = visible_box(run, run.state)
    assert box.y_min < 60.0 and box.y_max > 90.0


def test_lines_across_a_periodic_side_are_drawn_at_both_sides(tmp_path):
    bed = np.concatenate([base_row(10, 0.2) + [0.5 * row, row * np.sqrt(3.0) / 2.0] for row in range(1, 4)])
    run = repose.open(write_run(tmp_path / "run", bed, base_row(10, 0.2), period=20.0))
    lines, contact = centre_lines(run, run.state)
    length = np.linalg.norm(lines[:, 1] - lines[:, 0], axis=1)
    np.testing.assert_allclose(length, 1.0 - run.state.contacts.overlap[contact], atol=1e-9)
    across, copies = np.unique(contact, return_counts=True)
    assert len(across) == len(run.state.contacts)
    assert set(copies) == {1, 2}
    twice = np.isin(contact, across[copies == 2])
    beyond = (lines[..., 0] < -10.0) | (lines[..., 0] > 10.0)
    assert beyond[twice].any(axis=1).all()
    assert not beyond[~twice].any()
    for side in (lines[twice, :, 0].min(), -lines[twice, :, 0].max()):
        assert -11.0 <= side < -10.0


def test_line_to_a_wall_ends_on_it(tmp_path):
    run = repose.open(write_run(tmp_path / "run", np.array([[0.0, 0.5], [1.0, 0.5]]), floor=True))
    lines, contact = centre_lines(run, run.state)
    with_wall = run.state.contacts.grains[contact, 1] < 0
    np.testing.assert_allclose(lines[with_wall], [[[0.0, 0.5], [0.0, 0.0]], [[1.0, 0.5], [1.0, 0.0]]], atol=1e-12)


@pytest.mark.parametrize("period", [None, 20.0])
def test_discs_have_their_size(tmp_path, period):
    """Fraction of dark pixels against pi r^2 over the area of the box; 1 % for the blurred rims of 28 discs."""
    grains = np.array([[2.0 * x, 2.0 * y] for x in range(-5, 2) for y in range(1, 5)], dtype=float)
    run = repose.open(write_run(tmp_path / "run", grains, period=period))
    with matplotlib.rc_context(style.RC):
        panel = make_panel(run, run.state, with_legend=False)
        chosen = np.ones(len(grains), dtype=bool)
        add_discs(panel, run, run.state, chosen, facecolor="black", linewidth=0.0)
        panel.axes.axis("off")
        panel.axes.set_position([0, 0, 1, 1])
        panel.figure.texts.clear()
        canvas = FigureCanvasAgg(panel.figure)
        canvas.draw()
    darkness = 1.0 - np.asarray(canvas.buffer_rgba())[..., 0].mean() / 255.0
    area = (panel.box.x_max - panel.box.x_min) * (panel.box.y_max - panel.box.y_min)
    assert darkness == pytest.approx(len(grains) * np.pi * 0.25 / area, rel=0.01)


def test_running_mean_is_shorter_at_the_ends():
    np.testing.assert_allclose(running_mean(np.array([0.0, 3.0, 6.0, 9.0]), 3), [1.5, 3.0, 6.0, 7.5])
    np.testing.assert_allclose(running_mean(np.array([1.0, 2.0]), 5), [1.5, 1.5])
