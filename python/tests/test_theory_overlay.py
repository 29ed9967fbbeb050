# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of theory over measured base forces shows the numbers of summary.json and nothing else."""

import json

import matplotlib
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from synthetic import base_row, pyramid, write_run
from synthetic_sweep import write_sweep

import repose
from repose import style, theory
from repose.errors import NotDrawn
from repose.pictures.run import RUN_PICTURES
from repose.pictures.sweep import SWEEP_PICTURES
from repose.pictures.theory_overlay import curve, label, per_degree
from repose.plot import main

POINTS = ["friction=0.2", "friction=0.5", "friction=0.4"]


def entry(slope=28.5, from_run=("slope_deg",), left=-8.0, width=18.0, scale=40.0, **more):
    """An entry as the program writes it; the residuals are 2 and -4 errors, and one has no error."""
    return {
        "model": "pile-continuum", "parameters": {"slope_deg": slope, "points": 101}, "from_run": list(from_run),
        "weight": 90.0, "base": {"centre": left + 0.5 * width, "width": width, "left": left, "spacing": 1.0},
        "scale": scale,
        "normal": {"chi_square": 20.0, "degrees": 4, "bins": 7, "rms": 1.0, "rms_over_mean": 0.1},
        "shear": {"chi_square": None, "degrees": 0, "bins": 0, "rms": 1.0, "rms_over_mean": 0.1},
        "residuals": {
            "x": [-3.0, 0.0, 3.0], "normal": [1.0, -2.0, 1.0], "normal_error": [0.5, 0.5, None],
            "shear": [0.0, 0.0, 0.0], "shear_error": [0.1, 0.1, None],
        }, **more,
    }  # fmt: skip


def add_theory(folder, entries):
    """Adds comparisons with theory to the summary of a folder."""
    path = folder / "summary.json"
    numbers = json.loads(path.read_text()) if path.is_file() else {}
    path.write_text(json.dumps({**numbers, "theory": entries}))
    return folder


@pytest.fixture
def folder(tmp_path):
    folder = write_run(tmp_path / "run", pyramid(16), base_row(30))
    return add_theory(folder, [entry(), entry(20, from_run=[], left=-7.0)])


def laid_out(figure):
    with matplotlib.rc_context(style.RC):
        FigureCanvasAgg(figure).draw()
    return figure


def lines_of(axes):
    """Lines of the models by their labels."""
    return {line.get_label(): line.get_xydata() for line in axes.get_lines() if line.get_label().startswith("pile")}


@pytest.mark.filterwarnings("error")
def test_lines_are_the_models_scaled_as_the_summary_says(folder):
    run = repose.open(folder)
    figure = laid_out(RUN_PICTURES["theory"](run, run.state))
    pile = theory.predict("pile-continuum", slope_deg=20, points=101)
    label_of = "pile-continuum slope_deg = 20: 5, –"
    for axes, name in zip(figure.axes, ("normal", "shear")):
        lines = lines_of(axes)
        assert list(lines) == ["pile-continuum: 5, –", label_of]
        np.testing.assert_array_equal(lines[label_of][:, 0], -7.0 + 18.0 * pile["x_over_b"])
        np.testing.assert_array_equal(lines[label_of][:, 1], 40.0 * pile[name])
        (bar,) = axes.containers
        bins = run.analysis["base"]
        np.testing.assert_array_equal(bar[0].get_xydata(), np.column_stack([bins["x"], bins[name]]))
        dots = next(line for line in axes.get_lines() if line.get_label() == "base disc")
        np.testing.assert_array_equal(dots.get_ydata(), run.base[name])
    texts = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert texts == ["base disc", "mean ± scatter of its discs / √n", "pile-continuum: 5, –", label_of]
    for line in figure.axes[2].get_lines():
        np.testing.assert_array_equal(line.get_ydata(), [2.0, -4.0, np.nan])
    assert [axes.get_ylabel() for axes in figure.axes][:2] == [
        "normal force\n(grain weights)",
        "shear force\n(grain weights)",
    ]


@pytest.mark.filterwarnings("error")
def test_texts_do_not_overlap(folder):
    run = repose.open(folder)
    figure = laid_out(RUN_PICTURES["theory"](run, run.state))
    upper, lower, last = figure.axes
    boxes = [figure.texts[0].get_window_extent(), upper.get_legend().get_window_extent()]
    boxes += [axes.yaxis.label.get_window_extent() for axes in (upper, lower, last)]
    for k, box in enumerate(boxes):
        assert not any(box.overlaps(other) for other in boxes[:k])


def test_labels_name_the_kind_and_the_given_parameters():
    assert label(entry()) == "pile-continuum"
    assert label(entry(30, from_run=[])) == "pile-continuum"  # the default
    assert label(entry(31.25, from_run=[])) == "pile-continuum slope_deg = 31.25"
    given = {"model": "custom", "angle_deg": 31, "slope_deg": 28.9, "mu": 0.2, "eta": None, "points": 201}
    assert label(entry(model="osl", parameters=given)) == "osl custom angle_deg = 31, mu = 0.2"
    x, force = curve(entry(model="osl", parameters=given | {"model": "fpa", "mu": None}), "normal")
    expected = theory.predict("osl", **{"model": "fpa", "angle_deg": 31, "slope_deg": 28.9})
    np.testing.assert_array_equal(force, 40.0 * expected["normal"])
    assert len(x) == 201


def test_chi_square_per_degree_as_text():
    assert per_degree({"chi_square": 20.0, "degrees": 3}) == "6.67"
    assert per_degree({"chi_square": 20000.0, "degrees": 3}) == "6667"
    assert per_degree({"chi_square": None, "degrees": 0}) == "–"


@pytest.mark.filterwarnings("error")
def test_command_line_draws_theory_alone_and_with_other_pictures(folder, capsys):
    assert main([str(folder), "--only", "theory", "--dpi", "50"]) == 0
    assert capsys.readouterr().out.splitlines() == [str(folder / f"pictures/theory.{end}") for end in ("png", "svg")]
    assert main([str(folder), "--dpi", "50", "--format", "png"]) == 0
    assert str(folder / "pictures/theory.png") in capsys.readouterr().out.splitlines()


def test_reasons_why_it_is_not_drawn(folder):
    run = repose.open(folder)
    with pytest.raises(NotDrawn, match="not a frame"):
        RUN_PICTURES["theory"](run, run.frame(0))
    run.summary["theory"][0]["parameters"]["slope_deg"] = 80
    with pytest.raises(NotDrawn, match="slope_deg = 80"):
        RUN_PICTURES["theory"](run, run.state)
    del run.summary["theory"]
    with pytest.raises(NotDrawn, match="no model was compared with it"):
        RUN_PICTURES["theory"](run, run.state)


@pytest.mark.filterwarnings("error")
def test_a_figure_of_a_sweep_shows_two_points(tmp_path):
    folder = write_sweep(tmp_path / "sweep", POINTS, {"contact.friction": [0.2, 0.5, 0.4]})
    entries = [entry(20.0 + k, point=name, members=4, scale=10.0 + k) for k, name in enumerate(POINTS)]
    sweep = repose.open(add_theory(folder, entries))
    first, second = map(laid_out, SWEEP_PICTURES["theory"](sweep))
    assert len(first.axes) == 6 and len(second.axes) == 3
    uppers = [first.axes[0], first.axes[1], second.axes[0]]
    for k, axes in enumerate(uppers):
        assert axes.get_legend().get_title().get_text().split("\n")[0] == POINTS[k]
        pile = theory.predict("pile-continuum", slope_deg=20.0 + k, points=101)
        np.testing.assert_array_equal(lines_of(axes)["pile-continuum: 5, –"][:, 1], (10.0 + k) * pile["normal"])
        np.testing.assert_array_equal(axes.containers[0][0].get_ydata(), sweep.profiles[k].binned["normal"])
    assert first.axes[0].get_ylim() == first.axes[1].get_ylim()


def test_points_without_theory_are_left_out(tmp_path):
    folder = add_theory(write_sweep(tmp_path / "sweep", POINTS), [entry(point=POINTS[1], members=4)])
    (figure,) = SWEEP_PICTURES["theory"](repose.open(folder))
    assert len(figure.axes) == 3


def test_a_damaged_summary_of_a_sweep_is_reported_in_one_line(tmp_path):
    folder = write_sweep(tmp_path / "sweep", POINTS)
    (folder / "summary.json").write_text('{\n  "theory": [],\n  "checksum": "00"\n}\n')
    with pytest.raises(repose.RunFolderError, match="summary.json: damaged") as caught:
        repose.open(folder)
    assert "\n" not in str(caught.value)
