# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of sweeps show the measures of their points, over a parameter or by name."""

import json
import os
import shutil
import subprocess

import h5py
import matplotlib
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from synthetic_sweep import METHODS, NAMED, ONE, SCENE, SCENES, TWO, write_sweep

import repose
from repose import style
from repose.errors import NotDrawn
from repose.pictures.sweep import SWEEP_PICTURES, packing
from repose.pictures.sweep.key_label import key_label, meaning_of
from repose.pictures.sweep.panel import is_geometric
from repose.plot import main
from repose.scene_comments import key_comments


@pytest.fixture
def sweep(tmp_path):
    return repose.open(write_sweep(tmp_path / "sweep", **ONE))


def draw(sweep, name):
    """Figures of a picture, laid out."""
    with matplotlib.rc_context(style.RC):
        figures = SWEEP_PICTURES[name](sweep)
        for figure in figures:
            FigureCanvasAgg(figure).draw()
    return figures


def errorbars(axes):
    """(line, ends of the bars (K, 2, 2), label) of each container."""
    return [(bar[0], np.array(bar[2][0].get_segments()), bar.get_label()) for bar in axes.containers]


def test_angle_shows_means_errors_and_members(sweep):
    (figure,) = draw(sweep, "angle")
    axes = figure.axes[0]
    ((line, bars, _),) = errorbars(axes)
    np.testing.assert_allclose(line.get_xydata(), [[0.2, 20.0], [0.4, 20.2], [0.5, 20.1]])
    error = sweep.measures["angle_of_repose_deg.mean"]["error"]
    np.testing.assert_allclose(bars[:, 1, 1] - bars[:, 0, 1], 2.0 * np.nan_to_num(error[[0, 2, 1]]), atol=1e-12)
    dots = axes.get_lines()[0].get_xydata()
    assert len(dots) == 9
    np.testing.assert_allclose(sorted(dots[dots[:, 0] == 0.2, 1]), 20.0 + 0.01 * (np.arange(4) - 1.5))
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("friction", "angle of repose (deg)")
    assert figure.texts[0].get_text().splitlines()[1] == "friction: Coulomb coefficient mu"
    assert not figure.legends


def test_angle_has_a_line_for_each_value_of_the_second(tmp_path):
    (figure,) = draw(repose.open(write_sweep(tmp_path / "sweep", **TWO)), "angle")
    bars = errorbars(figure.axes[0])
    assert [label for _, _, label in bars] == ["spacing=1.0", "spacing=1.1"]
    np.testing.assert_allclose(bars[1][0].get_xydata(), [[0.2, 20.1], [0.3, 20.3], [0.5, 20.5]])
    assert len({line.get_color() for line, _, _ in bars}) == len({line.get_marker() for line, _, _ in bars}) == 2
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["spacing=1.0", "spacing=1.1"]
    box = figure.legends[0].get_window_extent()
    assert box.y0 > figure.axes[0].get_window_extent().y1


def test_angle_over_names(tmp_path):
    (figure,) = draw(repose.open(write_sweep(tmp_path / "sweep", **NAMED)), "angle")
    axes = figure.axes[0]
    names = [label.get_text() for label in axes.get_yticklabels()]
    assert names == ["continuous", "a_rather_long_name_of\n_a_point", "hooke"]
    ((line, bars, _),) = errorbars(axes)
    np.testing.assert_allclose(line.get_xydata(), [[20.0, 0.0], [20.1, 1.0], [20.2, 2.0]])
    assert bars[0, 1, 0] > bars[0, 0, 0]
    assert axes.get_ylim() == (2.5, -0.5)
    assert axes.get_xlabel() == "angle of repose (deg)"


def test_wide_ranges_are_logarithmic(tmp_path):
    stiffness = {"stiffness": [1e2, 1e3, 1e4]}
    (figure,) = draw(repose.open(write_sweep(tmp_path / "sweep", ["a", "b", "c"], stiffness)), "angle")
    assert figure.axes[0].get_xscale() == "log"


@pytest.mark.parametrize(
    "places, logarithmic",
    [([1, 10, 100], True), ([1e3, 2e3, 5e3, 1e4, 1e5], True), (range(1, 91), False), ([0, 10, 100], False), ([1, 100], False)],
)
def test_axes_are_logarithmic_where_places_are_even_by_ratios(places, logarithmic):
    assert is_geometric(np.array(places, dtype=float)) == logarithmic


@pytest.mark.parametrize(
    "key, reduced, si",
    [
        ("contact.normal.stiffness", "normal stiffness / (mg/σ)", "normal stiffness (N/m)"),
        ("method.critical_angle", "critical angle (deg)", "critical angle (deg)"),
        ("base.spacing", "base spacing (diameters)", "base spacing (diameters)"),
        ("source.height_above", "source height above", "source height above"),
        ("gravity", "gravity / g", "gravity (m/s²)"),
    ],
)
def test_keys_are_words_with_the_units_of_the_scene(key, reduced, si):
    comments = key_comments(SCENE)
    assert key_label(key, comments, style.Units(True)) == reduced
    assert key_label(key, comments, style.Units(False)) == si


def test_the_meaning_of_a_key_is_its_first_statement():
    comments = key_comments(SCENE)
    meaning = "critical angle: a disc sticks where its contact is less than this off upright"
    assert meaning_of("method.critical_angle", comments) == meaning
    assert meaning_of("source.count", comments) == ""


def test_comments_are_those_that_the_program_writes(tmp_path):
    program = os.environ.get("REPOSE_PROGRAM")
    if not program:
        pytest.skip("REPOSE_PROGRAM names no program")
    scene = tmp_path / "scene.toml"
    scene.write_text(subprocess.run([program, "scene", "heap"], capture_output=True, text=True, check=True).stdout)
    comments = key_comments(scene.read_text())
    assert comments["contact.friction"].unit == "" and comments["contact.friction"].meaning
    assert comments["method.time_step"].unit == "T" and comments["base.spacing"].meaning


def test_labels_do_without_scenes(tmp_path):
    folder = write_sweep(tmp_path / "sweep", **METHODS)
    shutil.rmtree(folder / "members")
    assert draw(repose.open(folder), "angle")[0].axes[0].get_xlabel() == "critical angle"


def test_profiles_without_a_force_are_left_out(tmp_path):
    folder = write_sweep(tmp_path / "sweep", **ONE)
    with h5py.File(folder / "sweep.h5", "a") as file:
        for name in ("normal", "shear"):
            file[f"profiles/0001/{name}"][()] = 0.0
    (figure,) = draw(repose.open(folder), "profiles")
    assert [axes.get_title() for axes in figure.axes] == [ONE["names"][0], ONE["names"][2]]


def test_dip_shows_both_indices_and_the_line_at_one(sweep):
    (figure,) = draw(sweep, "dip")
    members, profiles = figure.axes
    np.testing.assert_allclose(errorbars(members)[0][0].get_ydata(), [0.9, 1.1, 1.0])
    ((line, bars, _),) = errorbars(profiles)
    np.testing.assert_allclose(line.get_ydata(), [1.1, 1.3, 1.2])
    np.testing.assert_allclose(bars[0, 1, 1] - bars[0, 0, 1], 0.04)
    for axes in (members, profiles):
        assert [1.0, 1.0] in [list(line.get_ydata()) for line in axes.get_lines()]
    assert [axes.get_title() for axes in figure.axes] == ["mean over the members", "of the mean profile"]


def test_measures_show_those_that_exist(sweep):
    (figure,) = draw(sweep, "measures")
    assert [axes.get_ylabel() for axes in figure.axes] == [
        "coordination",
        "solid fraction\nof the core",
        "largest overlap\n/ diameter",
    ]
    np.testing.assert_allclose(errorbars(figure.axes[0])[0][0].get_ydata(), [4.0, 4.2, 4.1])


def test_profiles_have_a_panel_for_each_point(sweep):
    (figure,) = draw(sweep, "profiles")
    assert [axes.get_title() for axes in figure.axes] == ONE["names"]
    for axes, profile in zip(figure.axes, sweep.profiles):
        lines = {line.get_label(): line for line in axes.get_lines()}
        for name in ("normal", "shear"):
            np.testing.assert_allclose(lines[f"{name} force"].get_ydata(), profile.binned[name])
        band = [part for part in axes.collections if isinstance(part, PolyCollection)][0].get_paths()[0].vertices
        np.testing.assert_allclose(band[:, 1].max(), 1.1 * profile.binned["normal"].max())
        assert axes.get_xlim() == pytest.approx((-26.0, 26.0))
        assert axes.get_ylim()[1] > 12.0
    numbers = [axes.texts[0].get_text() for axes in figure.axes]
    assert numbers[0] == "4 members\ndip index 1.10 ± 0.02\n95 %: 1.05 to 1.15"
    assert numbers[1] == "4 members\ndip index 1.20 ± 0.02"
    assert numbers[2] == "1 member\ndip index 1.30"


def test_more_than_twelve_profiles_have_a_second_figure(tmp_path, capsys):
    names = [f"friction={0.1 * k:.1f}" for k in range(14)]
    folder = write_sweep(tmp_path / "sweep", names, {"contact.friction": [0.1 * k for k in range(14)]})
    assert [len(figure.axes) for figure in draw(repose.open(folder), "profiles")] == [12, 2]
    assert main([str(folder), "--only", "profiles", "--format", "png", "--dpi", "40"]) == 0
    pictures = [str(folder / "pictures" / name) for name in ("profiles.png", "profiles-2.png")]
    assert capsys.readouterr().out.splitlines() == pictures


MEASURED = [key for key, _ in packing.MEASURES]


def packings(folder, kind, keys=(packing.DENSITY, *MEASURED, *packing.FRACTIONS)):
    return repose.open(write_sweep(folder, **kind, keys=keys, profiles=False))


def test_packings_of_one_series(tmp_path):
    """Over the parameter and over the solid fraction, with all fractions in one panel."""
    sweep = packings(tmp_path / "sweep", ONE)
    along, over_density = draw(sweep, "packing")
    assert [axes.get_xlabel() for axes in along.axes] == ["friction"] * 5
    assert [axes.get_xlabel() for axes in over_density.axes] == ["solid fraction ρ"] * 4
    fractions = [label for _, _, label in errorbars(along.axes[4])]
    assert fractions == ["0", "1", "2", "3", "4", "5", "6+"]
    assert not along.legends and not over_density.legends


def test_packings_of_two_methods_are_overlaid(tmp_path):
    """A key that only one of them has is ignored: the points of a name are a series, and each fraction has a panel."""
    sweep = packings(tmp_path / "sweep", METHODS)
    along, over_density, fractions = draw(sweep, "packing")
    density, measured = sweep.measures[packing.DENSITY], [sweep.measures[key] for key in MEASURED]
    rows = {"deposition": [0, 1, 2], "contact-dynamics": [3, 4, 5]}
    for figure, place, drawn in (
        (along, np.array([0.0, 50.0, 90.0] * 2), [density, *measured]),
        (over_density, density["mean"], measured),
        (fractions, density["mean"], [sweep.measures[key] for key in packing.FRACTIONS]),
    ):
        assert len(figure.axes) == len(drawn)
        assert [text.get_text() for text in figure.legends[0].get_texts()] == list(rows)
        assert figure.legends[0].get_window_extent().y0 > figure.axes[0].get_window_extent().y1
        for axes, measure in zip(figure.axes, drawn):
            bars = errorbars(axes)
            assert [label for _, _, label in bars] == list(rows)
            assert len({line.get_color() for line, _, _ in bars}) == 2
            assert len({line.get_marker() for line, _, _ in bars}) == 2
            assert bars[1][0].get_markerfacecolor() == "none"  # both are visible where they coincide
            for line, _, name in bars:
                np.testing.assert_allclose(line.get_xydata(), np.column_stack([place, measure["mean"]])[rows[name]])
    assert along.axes[0].get_xlabel() == "critical angle (deg)"
    sideways, upright = (part.get_segments() for part in over_density.axes[0].containers[0][2])
    np.testing.assert_allclose([end[1, 0] - end[0, 0] for end in sideways], 2.0 * density["error"][:3])
    np.testing.assert_allclose([end[1, 1] - end[0, 1] for end in upright], 2.0 * measured[0]["error"][:3])


def test_packings_leave_out_fractions_without_grains(tmp_path):
    keys = (packing.DENSITY, *MEASURED, *packing.FRACTIONS[1:4])
    fractions = draw(packings(tmp_path / "sweep", METHODS, keys), "packing")[2]
    assert [axes.get_ylabel().split()[1] for axes in fractions.axes] == ["$P_1$", "$P_2$", "$P_3$"]


NO_RESPONSE = "not drawn: no two points of the sweep differ by one downward load alone"
NO_THEORY = "not drawn: no model was compared with it (repose plot DIR --theory MODEL)"
NO_COLUMNS = [
    "heights: not drawn: the sweep file asks for no fit over heights ([[fit]])",
    "columns: not drawn: no point has columns between two upright walls with forces",
    "phase: not drawn: fewer than 3 speeds of a wall driven by a spring whose slips were looked for",
]
NO_PACKINGS = "not drawn: no packings were measured over a numeric parameter"


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", [ONE, TWO, SCENES, NAMED], ids=["one", "two", "scenes", "named"])
def test_command_line_draws_a_sweep(tmp_path, capsys, kind):
    folder = write_sweep(tmp_path / "sweep", **kind)
    assert main([str(folder), "--format", "png,svg", "--dpi", "50"]) == 0
    printed = capsys.readouterr()
    not_drawn = ("packing", "response", "heights", "columns", "phase", "theory")
    drawn = [name for name in SWEEP_PICTURES if name not in not_drawn]
    expected = [str(folder / "pictures" / f"{name}.{end}") for name in drawn for end in ("png", "svg")]
    expected += [f"packing: {NO_PACKINGS}", f"response: {NO_RESPONSE}", *NO_COLUMNS, f"theory: {NO_THEORY}"]
    assert printed.out.splitlines() == expected
    assert printed.err == ""


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", [ONE, METHODS], ids=["one", "methods"])
def test_sweeps_are_printed(tmp_path, caplog, kind):
    """PDF and EPS; Matplotlib logs a warning where EPS would need transparency, which it lacks."""
    keys = ("angle_of_repose_deg.mean", "base_dip.index", "coordination", packing.DENSITY, *MEASURED, *packing.FRACTIONS)
    folder = write_sweep(tmp_path / "sweep", **kind, keys=keys)
    assert main([str(folder), "--format", "pdf,eps"]) == 0
    assert not caplog.records
    assert len(list((folder / "pictures").iterdir())) >= 12


@pytest.mark.filterwarnings("error")
def test_sweep_without_a_finished_member(tmp_path, capsys):
    folder = write_sweep(tmp_path / "sweep", **ONE, members=0, profiles=False)
    assert main([str(folder)]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "profiles: not drawn: no point has a base that carries a force",
        "angle: not drawn: no member has angle_of_repose_deg.mean",
        "dip: not drawn: no member has a loaded base",
        "measures: not drawn: no member has any of the measures shown here",
        f"packing: {NO_PACKINGS}",
        f"response: {NO_RESPONSE}",
        *NO_COLUMNS,
        f"theory: {NO_THEORY}",
    ]


RESPONSE = """point,x_over_h,response,response_error,elastic,osl,diffusive,elastic_fitted
one,-0.5,0.25,0.03,0.3,1,0.1,0.28
one,0,0.75,0.05,0.8,0,3,0.79
one,0.5,0.375,0.02,0.3,1,0.1,0.28
two,-0.5,0.25,,0.3,1,0.1,
two,0,0.5,,0.8,0,3,
"""


@pytest.mark.filterwarnings("error")
def test_responses_are_drawn_with_theory(tmp_path):
    folder = write_sweep(tmp_path / "sweep", **ONE)
    (folder / "response.csv").write_text(RESPONSE)
    curves = {name: {"chi_square": 6.0, "bins": 3} for name in ("elastic", "osl", "diffusive", "elastic_fitted")}
    common = {"places": 1, "force": 1.0, "depth": {"mean": 17.0}}
    unknown = {name: {"chi_square": None, "bins": 1} for name in ("elastic", "osl", "diffusive")}
    fits = [
        {**common, "point": "one", "seeds": 3, "curves": curves, "fitted_poisson": 0.25},
        {**common, "point": "two", "seeds": 1, "curves": unknown, "fitted_poisson": None},
    ]
    (folder / "response.json").write_text(json.dumps(fits))
    axes = draw(repose.open(folder), "response")[0].axes
    assert [panel.get_title() for panel in axes] == ["one", "two"]
    points, bare = (panel.containers[0][0] for panel in axes)
    np.testing.assert_array_equal(points.get_xydata(), [[-0.5, 0.25], [0.0, 0.75], [0.5, 0.375]])
    np.testing.assert_array_equal(bare.get_xydata(), [[-0.5, 0.25], [0.0, 0.5]])
    texts = ["\n".join(text.get_text() for text in panel.texts) for panel in axes]
    assert "fitted ν = 0.25" in texts[0] and "elastic 2\n" in texts[0] and "χ²" not in texts[1]


def test_absent_measure(tmp_path):
    folder = write_sweep(tmp_path / "sweep", **ONE, keys=["coordination"])
    with pytest.raises(NotDrawn, match="no member has angle_of_repose_deg.mean"):
        draw(repose.open(folder), "angle")
    assert [axes.get_title() for axes in draw(repose.open(folder), "dip")[0].axes] == ["of the mean profile"]


@pytest.mark.parametrize(
    "options, complaint",
    [
        (["--only", "heap"], "unknown name 'heap', choose from profiles, angle, dip, measures"),
        (["--frame", "0"], "a sweep has no frames"),
    ],
)
def test_wrong_options_are_one_line(tmp_path, capsys, options, complaint):
    folder = write_sweep(tmp_path / "sweep", **ONE)
    try:
        status = main([str(folder), *options])
    except SystemExit as ended:
        status = ended.code
    printed = capsys.readouterr()
    assert status == 2
    assert complaint in printed.err and printed.err.count("\n") == 1
    assert not (folder / "pictures").exists()
