# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of columns between two walls show the numbers of the files and Janssen's law, integrated here step by step."""

import math

import h5py
import matplotlib
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PathCollection, PolyCollection
from synthetic_column import (
    FLOOR, FRICTION, GRAVITY, HEIGHT, MASS, STRESS_RATIO, WIDTH, integrated_stress, motion, set_means, slices,
    write_column_run, write_column_sweep, write_heights,
)  # fmt: skip
from synthetic_sweep import write_sweep

import repose
from repose import style
from repose.errors import NotDrawn
from repose.pictures.janssen import Janssen
from repose.pictures.run import RUN_PICTURES
from repose.pictures.run.slips import thinned
from repose.pictures.sweep import SWEEP_PICTURES
from repose.plot import FORMATS, main

WEIGHT = MASS * GRAVITY
FRICTIONS = pytest.mark.parametrize("friction", [FRICTION, 0.0, 0.35])


def drawn(folder, name):
    """Figures of a picture, laid out; every text and legend lies within its figure."""
    source = repose.open(folder)
    with matplotlib.rc_context(style.RC):
        figures = SWEEP_PICTURES[name](source) if name in SWEEP_PICTURES else [RUN_PICTURES[name](source, source.state)]
        for figure in figures:
            FigureCanvasAgg(figure).draw()
            boxes = [part.get_window_extent() for part in [*figure.legends, *figure.texts]]
            for box in [*boxes, *(axes.get_tightbbox() for axes in figure.axes)]:
                assert box.x0 >= 0.0 and box.x1 <= figure.bbox.x1 and box.y0 >= 0.0 and box.y1 <= figure.bbox.y1
    return figures


def dashed(axes):
    """Coordinates of the dashed lines."""
    return [line.get_xydata() for line in axes.get_lines() if line.get_linestyle() == "--"]


def legend_of(figure):
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


@FRICTIONS
def test_janssen_is_the_balance_of_a_slice(friction):
    law = Janssen(WIDTH, HEIGHT, WEIGHT, STRESS_RATIO, friction)
    depth = np.array([0.0, 0.5, 3.0, HEIGHT])
    expected = [integrated_stress(z, WEIGHT, friction) for z in depth]
    np.testing.assert_allclose(law.stress(depth), expected, rtol=1e-6)
    np.testing.assert_allclose(law.pressure(depth), STRESS_RATIO * np.array(expected), rtol=1e-6)
    carried = 2.0 * friction * np.trapz(law.pressure(np.linspace(0.0, HEIGHT, 20001)), np.linspace(0.0, HEIGHT, 20001))
    assert law.stress(HEIGHT) * WIDTH + carried == pytest.approx(WEIGHT)  # floor and walls carry the weight


def test_janssen_is_that_of_the_compiled_theory():
    from repose import theory

    for friction, direction in ((0.35, "rest"), (-0.35, "pushed-up")):
        column = theory.predict("janssen", dimension=2, density=WEIGHT / (WIDTH * HEIGHT), solid_fraction=1, gravity=1,
                                width=WIDTH, stress_ratio=STRESS_RATIO, friction=0.35, height=HEIGHT, direction=direction)  # fmt: skip
        law = Janssen(WIDTH, HEIGHT, WEIGHT, STRESS_RATIO, friction)
        np.testing.assert_allclose(law.stress(column["depth"]), column["stress"], rtol=1e-9, atol=1e-12)


@FRICTIONS
def test_column_shows_stresses_beside_the_grains_with_the_law(tmp_path, friction):
    (figure,) = drawn(write_column_run(tmp_path / "run", friction), "column")
    grains, stresses = figure.axes
    assert grains.get_ylim() == stresses.get_ylim() and grains.get_position().y0 == stresses.get_position().y0
    lines = [part for part in grains.collections if isinstance(part, PathCollection) and not len(part.get_facecolor())]
    assert lines  # the force network
    table = slices()
    for patch, name in zip(stresses.patches, ("pressure", "shear")):
        np.testing.assert_allclose(patch.get_data().values, table[name])
        np.testing.assert_allclose(patch.get_data().edges, FLOOR + np.arange(0.0, 13.0, 2.0))
    points = stresses.get_lines()[0].get_xydata()
    np.testing.assert_allclose(points, np.column_stack([table["stress"], FLOOR + table["bottom"] + 1.0]))
    law, pressure = dashed(stresses)
    np.testing.assert_allclose(law[[0, -1], 1], [FLOOR + HEIGHT, FLOOR])  # from the surface to the floor where it is now
    for k in (0, 60, len(law) - 1):
        expected = integrated_stress(FLOOR + HEIGHT - law[k, 1], WEIGHT, friction)
        assert law[k, 0] == pytest.approx(expected, rel=1e-6)
        assert pressure[k] == pytest.approx([STRESS_RATIO * expected, law[k, 1]], rel=1e-6)
    texts = [text.get_text() for text in figure.texts]
    assert f"Janssen's law of the measured K = 0.75, friction {friction:.2f}:".replace("-", "−") in texts
    assert "mean over the last 15 √(σ/g):" in texts
    assert stresses.get_xlabel() == "stress / (mg/σ)"


def test_column_without_a_known_law_shows_the_stresses_alone(tmp_path):
    folder = write_column_run(tmp_path / "run", np.nan)
    (figure,) = drawn(folder, "column")
    assert not dashed(figure.axes[1]) and len(figure.axes[1].patches) == 2
    assert not any("Janssen" in text.get_text() for text in figure.texts)


def test_column_shows_which_loads_of_its_floor_statics_allows(tmp_path):
    write_column_run(tmp_path)
    run = repose.open(tmp_path)
    run.summary["force_range"] = {"load_ratio": {"min": 0.5, "max": 3.0}}
    with matplotlib.rc_context(style.RC):
        figure = RUN_PICTURES["column"](run, run.state)
    bars = [line for line in figure.axes[1].get_lines() if line.get_marker() == "|"]
    assert len(bars) == 1 and "stress at the floor" in legend_of(figure)
    np.testing.assert_allclose(bars[0].get_xdata(), np.array([0.5, 3.0]) * WEIGHT / WIDTH)
    np.testing.assert_allclose(bars[0].get_ydata(), FLOOR)
    run.summary["force_range"]["load_ratio"]["max"] = None  # no bound
    with matplotlib.rc_context(style.RC):
        figure = RUN_PICTURES["column"](run, run.state)
    assert not [line for line in figure.axes[1].get_lines() if line.get_marker() == "|"]


def test_column_motion(tmp_path):
    """The load is that of the lowest level wall at the rows of the motion."""
    (figure,) = drawn(write_column_run(tmp_path / "run"), "column_motion")
    moved, shortening, front, load = figure.axes
    table = motion()
    for line, name in zip(moved.get_lines()[:2], ("floor", "top")):
        np.testing.assert_allclose(line.get_xydata(), np.column_stack([table["time"], table[name]]))
    np.testing.assert_allclose(shortening.get_lines()[0].get_ydata(), table["shortening"])
    np.testing.assert_allclose(front.get_lines()[0].get_ydata(), table["front"])
    np.testing.assert_allclose(load.get_lines()[0].get_ydata(), 100.0 + table["time"])
    follows = [line.get_xdata()[0] for line in front.get_lines() if line.get_linestyle() == ":"]
    assert table["floor"][table["time"] == follows[0]] == pytest.approx(0.5, abs=0.05)
    assert "the floor having moved by 0.5 σ" in figure.texts[0].get_text()


@pytest.mark.parametrize("name", ["column", "column_motion"])
def test_runs_without_a_column_say_so(tmp_path, name):
    folder = write_column_run(tmp_path / "run")
    with h5py.File(folder / "analysis.h5", "a") as file:
        del file[name]
    run = repose.open(folder)
    with pytest.raises(NotDrawn, match="between two upright walls"):
        RUN_PICTURES[name](run, run.state)
    with pytest.raises(NotDrawn, match="not a frame"):
        RUN_PICTURES[name](run, run.frame(0))


def with_volumes(folder):
    with h5py.File(folder / "analysis.h5", "a") as file:
        file["slips/dilation"], file["slips/compaction"] = [3e-4, 2e-4, -1e-4], [np.nan, 1e-4, 2e-4]
    return folder


def test_slips_show_how_a_column_grows_and_shrinks(tmp_path):
    (figure,) = drawn(with_volumes(write_column_run(tmp_path / "run")), "slips")
    force, drops, volume = figure.axes
    shrinks, grows = volume.get_lines()[1:]
    np.testing.assert_allclose(grows.get_xydata(), [[4.0, 3e-4], [2.0, 2e-4], [1.0, -1e-4]])
    np.testing.assert_allclose(shrinks.get_xydata()[1:], [[2.0, 1e-4], [1.0, 2e-4]])
    assert [text.get_text() for text in volume.get_legend().get_texts()] == ["shrinks since the slip before", "grows in the slip"]


def test_many_rows_are_thinned_to_their_extremes():
    time = np.arange(100000.0)
    force = np.sin(time)
    force[[12345, 77777]] = 9.0, -9.0
    x, y, rows = thinned(time, force, 1000)
    assert rows == 200 and len(x) == len(y) == 1000 and (np.diff(x) >= 0.0).all()
    np.testing.assert_array_equal(force[x.astype(int)], y)
    assert {12345.0, 77777.0} <= set(x)
    assert thinned(time[:1000], force[:1000], 1000)[2] == 1


@pytest.mark.filterwarnings("error")
def test_many_slips_are_marked_by_their_ends(tmp_path, monkeypatch, caplog):
    folder = with_volumes(write_column_run(tmp_path / "run"))
    monkeypatch.setattr("repose.pictures.run.slips.MOST_ROWS", 6)
    monkeypatch.setattr("repose.pictures.run.slips.MOST_SHAPES", 2)
    (figure,) = drawn(folder, "slips")
    (marked,) = [part for part in figure.axes[0].collections if isinstance(part, LineCollection)]
    np.testing.assert_allclose(marked.get_segments(), [[[1, 6], [2, 2]], [[4, 4], [5, 2]], [[7, 4], [8, 3]]])
    assert "of every 4 rows of the force the least and the largest" in figure.texts[0].get_text()
    assert main([str(folder), "--only", "slips", "--format", ",".join(FORMATS), "--dpi", "60"]) == 0
    assert "<image" in (folder / "pictures" / "slips.svg").read_text()
    assert not caplog.records


def test_columns_of_a_sweep_have_bands_and_the_law_of_the_means(tmp_path):
    first, second = drawn(write_column_sweep(tmp_path / "sweep", 15), "columns")
    assert [len(figure.axes) for figure in (first, second)] == [12, 2]
    table = slices()
    for k, axes in enumerate(first.axes[:2]):
        stress, pressure = axes.get_lines()[:2]
        np.testing.assert_allclose(stress.get_xydata(), np.column_stack([table["depth"], table["stress"]])[::-1])
        np.testing.assert_allclose(pressure.get_ydata(), table["pressure"][::-1])
        bands = [part.get_paths()[0].vertices[:, 1] for part in axes.collections if isinstance(part, PolyCollection)]
        np.testing.assert_allclose([band.max() for band in bands], [1.1 * 6.0, 1.1 * 12.0])
        law, on_wall = dashed(axes)
        friction = FRICTION * (-1.0) ** k
        for at in (50, len(law) - 1):
            expected = integrated_stress(law[at, 0], WEIGHT, friction)
            assert [law[at, 1], on_wall[at, 1]] == pytest.approx([expected, STRESS_RATIO * expected], rel=1e-6)
        assert axes.texts[0].get_text() == f"4 members\nK = 0.75, f = {'−' if k == 0 else ''}0.20"
    assert legend_of(first) == ["vertical stress", "wall pressure", "Janssen", "K × Janssen"]
    assert "depth below the surface / σ" in [text.get_text() for text in first.texts]


def test_columns_without_scenes_have_no_law(tmp_path):
    folder = write_column_sweep(tmp_path / "sweep", 2)
    for path in folder.glob("members/*/*/scene.toml"):
        path.write_text("no = [scene")
    (figure,) = drawn(folder, "columns")
    assert not dashed(figure.axes[0]) and len(figure.axes) == 1


def test_heights_show_masses_and_both_laws(tmp_path):
    folder = write_sweep(tmp_path / "sweep", ["a", "b", "c"], {"source.count": [1, 2, 3]})
    write_heights(folder)
    (figure,) = drawn(folder, "heights")
    (axes,) = figure.axes
    assert axes.get_yscale() == "linear"
    for bars in axes.containers:
        np.testing.assert_allclose(bars[0].get_xydata(), [[2.0, 20.0], [4.0, 40.0], [8.0, 80.0]])
        ends = np.array(bars[2][0].get_segments())
        np.testing.assert_allclose(ends[:, 1, 1] - ends[:, 0, 1], [4.0, 8.0, 0.0])
    curves = {line.get_label(): line.get_xydata() for line in axes.get_lines() if "λ" in line.get_label()}
    two = "λ₁ = (6.00 ± 0.12) σ, λ₂ = (4.00 ± 0.12) σ, λ₁/λ₂ = 1.50 ± 0.12"
    one = "λ = (5.00 ± 0.12) σ; p = 0.25"
    assert list(curves) == [f"pushed up: {one}", f"pushed up: {two}", f"down: {one}", f"down: {two}"]
    for curve, length, scale, sign in zip(curves.values(), (5, 4, 5, 4), (5, 6, 5, 6), (1, 1, -1, -1)):
        for h, mass in (curve[60], curve[-1]):
            assert mass == pytest.approx(4.0 * scale * abs(math.exp(sign * h / length) - 1.0), rel=1e-9)
    assert legend_of(figure)[-2:] == ["few: too few", "mass of the whole column"]
    whole = [line.get_xydata()[-1] for line in axes.get_lines() if line.get_linestyle() == ":"]
    assert whole[0][1] == pytest.approx(4.0 * whole[0][0])
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("height of the column / σ", "apparent mass / m")


def test_heights_over_more_than_a_decade_are_logarithmic(tmp_path):
    folder = write_sweep(tmp_path / "sweep", ["a", "b", "c"], {"source.count": [1, 2, 3]})
    write_heights(folder, scale=5.0)
    assert drawn(folder, "heights")[0].axes[0].get_yscale() == "log"


SPEEDS = [0.5, 0.02, 0.1, 2.0, 0.08, 0.4]


def write_phase(folder, speeds):
    """Two frictions, and speeds as vectors, which have no number."""
    names = [f"velocity=-0.0--{v}-_friction={f}" for f in (0.4, 0.6) for v in (1, 2, 3)]
    parameters = {"contact.friction": [0.4] * 3 + [0.6] * 3, "plane.piston.velocity": [f"[0.0, {v}]" for v in (1, 2, 3)] * 2}
    write_sweep(folder, names, parameters, profiles=False)
    with h5py.File(folder / "sweep.h5", "a") as file:
        stuck = np.arange(6) / 10.0
        set_means(file, {"slips.relative_speed": speeds, "slips.stuck": stuck, "slips.deviation": 2.0 * stuck})
    return folder


def test_phase_has_a_line_for_each_friction_in_order_of_speed(tmp_path):
    (figure,) = drawn(write_phase(tmp_path / "sweep", SPEEDS), "phase")
    assert legend_of(figure) == ["friction=0.4", "friction=0.6"]
    assert [axes.get_ylabel() for axes in figure.axes] == ["fraction of the time stuck", "deviation of the force / mean"]
    for axes, scale in zip(figure.axes, (1.0, 2.0)):
        one, other = (bars[0].get_xydata() for bars in axes.containers)
        np.testing.assert_allclose(one, [[0.02, 0.1 * scale], [0.1, 0.2 * scale], [0.5, 0.0]])
        np.testing.assert_allclose(other, [[0.08, 0.4 * scale], [0.4, 0.5 * scale], [2.0, 0.3 * scale]])
        ends = np.array(axes.containers[0][2][0].get_segments())
        np.testing.assert_allclose(ends[:, 1, 1] - ends[:, 0, 1], 0.02)
        assert axes.get_xscale() == "log"
        assert [list(line.get_xdata()) for line in axes.get_lines() if line.get_linestyle() == "--"] == [[1.0, 1.0]]


@pytest.mark.parametrize("speeds", [[0.1] * 3 + [0.2] * 3, [0.1, 0.2] + [np.nan] * 4])
def test_phase_needs_three_speeds(tmp_path, speeds):
    with pytest.raises(NotDrawn, match="fewer than 3 speeds"):
        SWEEP_PICTURES["phase"](repose.open(write_phase(tmp_path / "sweep", speeds)))


@pytest.mark.filterwarnings("error")
def test_pictures_of_columns_are_written_in_every_format(tmp_path, caplog):
    run = with_volumes(write_column_run(tmp_path / "run"))
    sweep = write_column_sweep(tmp_path / "columns", 4)
    write_heights(sweep)
    phase = write_phase(tmp_path / "phase", SPEEDS)
    for folder, names in ((run, "column,column_motion,slips"), (sweep, "columns,heights"), (phase, "phase")):
        assert main([str(folder), "--only", names, "--format", ",".join(FORMATS), "--dpi", "60"]) == 0
        assert len(list((folder / "pictures").iterdir())) == len(FORMATS) * len(names.split(","))
    assert not caplog.records
