# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sweep folders are read as written, and drawn over what varies."""

import json

import h5py
import matplotlib
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from synthetic import base_row, pyramid, write_run
from synthetic_sweep import write_sweep

import repose
from repose import style
from repose.not_drawn import NotDrawn
from repose.pictures.sweep import SWEEP_PICTURES, packing
from repose.pictures.sweep.axis import axis_of, broken, without_part
from repose.plot import main

FRICTION = {"contact.friction": [0.2, 0.5, 0.4]}
ONE = dict(names=["friction=0.2", "friction=0.5", "friction=0.4"], parameters=FRICTION)
TWO = dict(
    names=[f"friction={f}_spacing={s}" for f in (0.2, 0.3, 0.5) for s in (1.0, 1.1)],
    parameters={"contact.friction": [0.2, 0.2, 0.3, 0.3, 0.5, 0.5], "base.spacing": [1.0, 1.1] * 3},
)
SCENES = dict(
    names=[f"{name}_spacing={s}" for name in ("soft", "n144-long") for s in (1.0, 1.1, 1.2)],
    parameters={"base.spacing": [1.0, 1.1, 1.2] * 2},
)  # points whose scenes differ in what is no parameter
NAMED = dict(names=["continuous", "a_rather_long_name_of_a_point", "hooke"], parameters={"law": ["a", "b", None]})


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


def test_reads_what_was_written(sweep):
    assert isinstance(sweep, repose.SweepFolder)
    assert sweep.attributes["title"] == "A synthetic <sweep>"
    assert sweep.points == ONE["names"]
    assert list(sweep.finished) == [4, 4, 1]
    assert list(sweep.parameters["contact.friction"]) == [0.2, 0.5, 0.4]
    assert sweep.parameter_text["contact.friction"] == ["0.2", "0.5", "0.4"]
    np.testing.assert_allclose(sweep.measures["coordination"]["mean"], [4.0, 4.1, 4.2])
    assert np.isnan(sweep.measures["coordination"]["error"][2])
    assert len(sweep.values["coordination"]) == len(sweep.members["point"]) == 9
    assert set(sweep.members["status"]) == {"finished"}
    assert sweep.profiles[1].attributes["dip_index"] == pytest.approx(1.2)
    assert len(sweep.profiles[1]["x"]) == 61
    assert sweep.profiles[1].binned.attributes["bin_width"] == 5.0


def test_open_tells_runs_from_sweeps(tmp_path):
    assert isinstance(repose.open(write_run(tmp_path / "run", pyramid(3), base_row(3))), repose.RunFolder)
    with pytest.raises(repose.RunFolderError, match="no such folder"):
        repose.open(tmp_path / "nowhere")


def test_axis_along_a_number(sweep):
    axis = axis_of(sweep)
    assert axis.key == "contact.friction"
    assert [list(line.rows) for line in axis.lines] == [[0, 2, 1]]


def test_axis_with_a_line_for_each_value_of_the_second(tmp_path):
    """The parameter with more values is the axis."""
    axis = axis_of(repose.open(write_sweep(tmp_path / "sweep", **TWO)))
    assert axis.key == "contact.friction"
    assert {line.name: list(line.rows) for line in axis.lines} == {"spacing=1.0": [0, 2, 4], "spacing=1.1": [1, 3, 5]}


def test_axis_with_a_line_for_each_scene(tmp_path):
    axis = axis_of(repose.open(write_sweep(tmp_path / "sweep", **SCENES)))
    assert axis.key == "base.spacing"
    assert {line.name: list(line.rows) for line in axis.lines} == {"soft": [0, 1, 2], "n144-long": [3, 4, 5]}


@pytest.mark.parametrize("parameters", [{}, {"law": ["a", "b", None]}, {"n": [1.0, 1.0, 2.0]}, {"n": [1.0, 2.0, None]}])
def test_axis_of_names(tmp_path, parameters):
    """No number, one that does not tell all points apart, or one that some have not."""
    axis = axis_of(repose.open(write_sweep(tmp_path / "sweep", NAMED["names"], parameters)))
    assert axis.key is None
    assert list(axis.place) == [0.0, 1.0, 2.0]


def test_names():
    assert without_part("soft_friction=0.5_spacing=1.1", "contact.friction", "0.5") == "soft_spacing=1.1"
    assert without_part("friction=0.5", "contact.friction", "0.5") == ""
    assert without_part("friction=0.55", "contact.friction", "0.5") is None
    assert broken("soft_friction=0.5_spacing=1.1", 20) == "soft_friction=0.5\n_spacing=1.1"


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
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("contact.friction", "angle of repose (deg)")
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


def test_dip_shows_both_indices_and_the_line_at_one(sweep):
    (figure,) = draw(sweep, "dip")
    members, profiles = figure.axes
    np.testing.assert_allclose(errorbars(members)[0][0].get_ydata(), [0.9, 1.1, 1.0])
    ((line, bars, _),) = errorbars(profiles)
    np.testing.assert_allclose(line.get_ydata(), [1.1, 1.3, 1.2])
    np.testing.assert_allclose(bars[0, 1, 1] - bars[0, 0, 1], 0.04)
    for axes in (members, profiles):
        assert [1.0, 1.0] in [list(line.get_ydata()) for line in axes.get_lines()]
    assert [axes.get_title() for axes in figure.axes] == ["of each member", "of the mean profile"]


def test_measures_are_those_that_exist(sweep):
    (figure,) = draw(sweep, "measures")
    assert [axes.get_ylabel() for axes in figure.axes] == [
        "coordination",
        "solid fraction\nof the core",
        "deepest overlap\n/ diameter",
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
    assert numbers[:2] == ["4 members\ndip index 1.10 ± 0.02", "4 members\ndip index 1.20 ± 0.02"]
    assert numbers[2] == "1 member\ndip index 1.30"


def test_more_than_twelve_profiles_go_on_in_another_figure(tmp_path, capsys):
    names = [f"friction={0.1 * k:.1f}" for k in range(14)]
    folder = write_sweep(tmp_path / "sweep", names, {"contact.friction": [0.1 * k for k in range(14)]})
    assert [len(figure.axes) for figure in draw(repose.open(folder), "profiles")] == [12, 2]
    assert main([str(folder), "--only", "profiles", "--format", "png", "--dpi", "40"]) == 0
    pictures = [str(folder / "pictures" / name) for name in ("profiles.png", "profiles-2.png")]
    assert capsys.readouterr().out.splitlines() == pictures


MEASURED = [key for key, _ in packing.MEASURES]
METHODS = dict(
    names=[f"{name}_critical_angle={angle}" for name in ("deposition", "contact-dynamics") for angle in (0, 50, 90)],
    parameters={"method.critical_angle": [0, 50, 90] * 2, "method.tolerance": [None] * 3 + [1e-3] * 3},
)


def packings(folder, kind, keys=(packing.DENSITY, *MEASURED, *packing.SHARES)):
    return repose.open(write_sweep(folder, **kind, keys=keys, profiles=False))


def test_packings_of_one_series(tmp_path):
    """Over the parameter and over the solid fraction, all shares in one panel."""
    sweep = packings(tmp_path / "sweep", ONE)
    along, over_density = draw(sweep, "packing")
    assert [axes.get_xlabel() for axes in along.axes] == ["contact.friction"] * 5
    assert [axes.get_xlabel() for axes in over_density.axes] == ["solid fraction ρ"] * 4
    shares = [label for _, _, label in errorbars(along.axes[4])]
    assert shares == ["0", "1", "2", "3", "4", "5", "6+"]
    assert not along.legends and not over_density.legends


def test_packings_of_two_methods_are_overlaid(tmp_path):
    """A key that only one of them has tells nothing: the points of a name are a series, and each share has a panel."""
    sweep = packings(tmp_path / "sweep", METHODS)
    along, over_density, shares = draw(sweep, "packing")
    density, measured = sweep.measures[packing.DENSITY], [sweep.measures[key] for key in MEASURED]
    rows = {"deposition": [0, 1, 2], "contact-dynamics": [3, 4, 5]}
    for figure, place, drawn in (
        (along, np.array([0.0, 50.0, 90.0] * 2), [density, *measured]),
        (over_density, density["mean"], measured),
        (shares, density["mean"], [sweep.measures[key] for key in packing.SHARES]),
    ):
        assert len(figure.axes) == len(drawn)
        assert [text.get_text() for text in figure.legends[0].get_texts()] == list(rows)
        assert figure.legends[0].get_window_extent().y0 > figure.axes[0].get_window_extent().y1
        for axes, measure in zip(figure.axes, drawn):
            bars = errorbars(axes)
            assert [label for _, _, label in bars] == list(rows)
            assert len({line.get_color() for line, _, _ in bars}) == len({line.get_marker() for line, _, _ in bars}) == 2
            assert bars[1][0].get_markerfacecolor() == "none"  # where the two lie on each other, both are seen
            for line, _, name in bars:
                np.testing.assert_allclose(line.get_xydata(), np.column_stack([place, measure["mean"]])[rows[name]])
    assert along.axes[0].get_xlabel() == "method.critical_angle (deg)"
    sideways, upright = (part.get_segments() for part in over_density.axes[0].containers[0][2])
    np.testing.assert_allclose([end[1, 0] - end[0, 0] for end in sideways], 2.0 * density["error"][:3])
    np.testing.assert_allclose([end[1, 1] - end[0, 1] for end in upright], 2.0 * measured[0]["error"][:3])


def test_packings_leave_out_shares_that_nobody_has(tmp_path):
    keys = (packing.DENSITY, *MEASURED, *packing.SHARES[1:4])
    shares = draw(packings(tmp_path / "sweep", METHODS, keys), "packing")[2]
    assert [axes.get_ylabel().split()[1] for axes in shares.axes] == ["$P_1$", "$P_2$", "$P_3$"]


NO_RESPONSE = "not drawn: no points of the sweep differ in one downward load alone"
NO_THEORY = "not drawn: no theory was laid on it (repose plot DIR --theory MODEL)"
NO_PACKINGS = "not drawn: no packings measured over a parameter that is a number"


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", [ONE, TWO, SCENES, NAMED], ids=["one", "two", "scenes", "named"])
def test_command_line_draws_a_sweep(tmp_path, capsys, kind):
    folder = write_sweep(tmp_path / "sweep", **kind)
    assert main([str(folder), "--format", "png,svg", "--dpi", "50"]) == 0
    printed = capsys.readouterr()
    drawn = [name for name in SWEEP_PICTURES if name not in ("packing", "response", "theory")]
    expected = [str(folder / "pictures" / f"{name}.{end}") for name in drawn for end in ("png", "svg")]
    expected += [f"packing: {NO_PACKINGS}", f"response: {NO_RESPONSE}", f"theory: {NO_THEORY}"]
    assert printed.out.splitlines() == expected
    assert printed.err == ""


@pytest.mark.filterwarnings("error")
def test_sweep_without_anything_finished(tmp_path, capsys):
    folder = write_sweep(tmp_path / "sweep", **ONE, members=0, profiles=False)
    assert main([str(folder)]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "profiles: not drawn: no point has a base profile",
        "angle: not drawn: no member has angle_of_repose_deg.mean",
        "dip: not drawn: no member has a loaded base",
        "measures: not drawn: no member has any of its measures",
        f"packing: {NO_PACKINGS}",
        f"response: {NO_RESPONSE}",
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
def test_responses_stand_beside_theory(tmp_path):
    folder = write_sweep(tmp_path / "sweep", **ONE)
    (folder / "response.csv").write_text(RESPONSE)
    curves = {name: {"chi_square": 6.0, "bins": 3} for name in ("elastic", "osl", "diffusive", "elastic_fitted")}
    common = {"places": 1, "force": 1.0, "depth": {"mean": 17.0}}
    unknown = {name: {"chi_square": None, "bins": 1} for name in ("elastic", "osl", "diffusive")}
    facts = [
        {**common, "point": "one", "seeds": 3, "curves": curves, "fitted_poisson": 0.25},
        {**common, "point": "two", "seeds": 1, "curves": unknown, "fitted_poisson": None},
    ]
    (folder / "response.json").write_text(json.dumps(facts))
    axes = draw(repose.open(folder), "response")[0].axes
    assert [panel.get_title() for panel in axes] == ["one", "two"]
    points, bare = (panel.containers[0][0] for panel in axes)
    np.testing.assert_array_equal(points.get_xydata(), [[-0.5, 0.25], [0.0, 0.75], [0.5, 0.375]])
    np.testing.assert_array_equal(bare.get_xydata(), [[-0.5, 0.25], [0.0, 0.5]])
    texts = ["\n".join(text.get_text() for text in panel.texts) for panel in axes]
    assert "fitted ν = 0.25" in texts[0] and "elastic 2\n" in texts[0] and "χ²" not in texts[1]


def test_measure_that_is_absent(tmp_path):
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


DAMAGES = {
    "another format": (lambda file: file.attrs.modify("format", np.bytes_(b"repose-run")), "not a sweep of Repose"),
    "another version": (lambda file: file.attrs.modify("format_version", 2), "format_version 2; this reads 1"),
    "no title": (lambda file: file.attrs.pop("title"), "not as the format says: no attribute title"),
    "no error": (lambda file: file.pop("measures/coordination/error"), "no dataset /measures/coordination/error"),
    "no members": (lambda file: file.pop("members"), "not as the format says: .*members"),
    "no bins": (lambda file: file.pop("profiles/0001/binned"), "not as the format says: .*binned"),
}


@pytest.mark.parametrize("kind", DAMAGES)
def test_damage_is_named_in_one_line(tmp_path, kind):
    folder = write_sweep(tmp_path / "sweep", **ONE)
    damage, complaint = DAMAGES[kind]
    with h5py.File(folder / "sweep.h5", "a") as file:
        damage(file)
    with pytest.raises(repose.RunFolderError, match=f"sweep.h5: .*{complaint}") as caught:
        repose.open(folder)
    assert "\n" not in str(caught.value)
