# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of runs show the numbers of the files: checked on the objects of the figures."""

import h5py
import matplotlib
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PathCollection, PolyCollection, QuadMesh
from matplotlib.colors import to_hex
from matplotlib.quiver import Quiver
from synthetic import base_row, pyramid, write_run
from synthetic_analysis import BIN, write_group

import repose
from repose import style
from repose.pictures.run import RUN_PICTURES
from repose.pictures.run.force_distribution import exponential
from repose.pictures.run.shapes import wall_places
from repose.pictures.run.stress import LEGEND_VALUE, LONGEST, principal

HEAP = dict(moving=pyramid(12), base=base_row(20))
BAND = "mean over 3 σ; band: ± scatter of its grains / √n"


@pytest.fixture
def folder(tmp_path):
    return write_run(tmp_path / "run", **HEAP)


def drawn(folder, name):
    """(run, figure) of a picture of the last state, laid out."""
    run = repose.open(folder)
    with matplotlib.rc_context(style.RC):
        figure = RUN_PICTURES[name](run, run.state)
        FigureCanvasAgg(figure).draw()
    return run, figure


def of_kind(axes, kind):
    return [artist for artist in axes.collections if isinstance(artist, kind)]


def legend_of(holder):
    """Labels in the legends of a figure, or in that of axes."""
    legends = holder.legends if hasattr(holder, "legends") else [holder.get_legend()]
    return [text.get_text() for legend in legends for text in legend.get_texts()]


def test_base_shows_the_bins_in_their_band(folder):
    run, figure = drawn(folder, "base")
    upper, lower = figure.axes
    bins = run.analysis["base"]
    for axes, name in ((upper, "normal"), (lower, "shear")):
        grains, line = axes.get_lines()[1:3]
        np.testing.assert_allclose(grains.get_ydata(), run.base[name])
        np.testing.assert_allclose(line.get_xdata(), bins["x"])
        np.testing.assert_allclose(line.get_ydata(), bins[name])
        band = of_kind(axes, PolyCollection)[0].get_paths()[0].vertices
        some = np.isfinite(bins["normal_error"])
        assert band[:, 0].min() == bins["x"][some].min()
        np.testing.assert_allclose(band[:, 1].max(), (bins[name] + bins[f"{name}_error"])[some].max())
    assert legend_of(figure) == ["base grain", BAND]
    assert "dip index 1.04" in figure.texts[0].get_text()
    assert "the band is no error of the profile" in figure.texts[0].get_text()
    assert upper.get_ylabel() == "normal force\n(grain weights)"


def test_base_shows_what_equilibrium_allows(folder):
    with h5py.File(folder / "analysis.h5", "r+") as file:
        x = file["base/x"][()]
        least, most = 0.5 * file["base/normal"][()], 2.0 * file["base/normal"][()] + 1.0
        most[1] = np.nan  # no bound
        write_group(file.create_group("force_range"), {"x": x, "min": least, "max": most}, bin_width=3.0)
    _, figure = drawn(folder, "base")
    upper, lower = figure.axes
    assert legend_of(figure) == ["base grain", BAND, "equilibrium allows"]
    band = of_kind(upper, PolyCollection)[1].get_paths()[0].vertices
    assert len(of_kind(lower, PolyCollection)) == 1
    for place, height in zip([*x, *x], [*least, *np.where(np.isnan(most), 1e6, most)]):
        assert np.isclose(band, [place, height]).all(axis=1).any()
    assert np.nanmax(most) < upper.get_ylim()[1] < 2.0 * np.nanmax(most)


def test_base_without_analysis_has_a_running_mean(folder):
    (folder / "analysis.h5").unlink()
    assert legend_of(drawn(folder, "base")[1]) == ["base grain", "mean of 5 grains"]


def test_voronoi_colours_closed_cells_by_solid_fraction(folder):
    run, figure = drawn(folder, "voronoi")
    axes, bar = figure.axes
    opened, closed = of_kind(axes, PolyCollection)
    voronoi = run.analysis["voronoi"]
    inside = voronoi["closed"] == 1
    np.testing.assert_allclose(closed.get_array(), voronoi["solid_fraction"][inside])
    assert to_hex(opened.get_facecolor()[0]) == style.FAINT
    assert len(opened.get_paths()) == np.count_nonzero(~inside)
    first = voronoi["vertices"][: voronoi["offset"][1]]
    np.testing.assert_allclose(closed.get_paths()[0].vertices[:6], first)
    low, high = closed.get_clim()
    assert (low, high) == pytest.approx((0.8, 0.9))
    assert closed.get_cmap().name == bar._colorbar.cmap.name == style.PACKING
    assert legend_of(figure) == ["open cell"]
    assert "solid fraction of the cell" in [text.get_text() for text in figure.texts]


def test_cells_across_a_periodic_side_are_drawn_at_both_sides(tmp_path):
    bed = np.concatenate([base_row(10, 0.5) + [0.5 * row, row * np.sqrt(3.0) / 2.0] for row in range(1, 4)])
    folder = write_run(tmp_path / "run", bed, base_row(10), period=20.0, surface=False)
    _, figure = drawn(folder, "voronoi")
    closed = of_kind(figure.axes[0], PolyCollection)[-1]
    middle = np.sort([path.vertices[:6, 0].mean() for path in closed.get_paths()])
    np.testing.assert_allclose(np.diff(middle), 1.0)
    assert middle[0] - 0.5 <= -10.0 and middle[-1] + 0.5 >= 10.0
    assert len(middle) == 22  # 20 cells, two of them on both sides


def test_principal_stress():
    """Uniaxial along 30 degrees, hydrostatic, and none; the shear stress is the mean of both components."""
    along = np.array([np.cos(np.pi / 6.0), np.sin(np.pi / 6.0)])
    one = np.outer(along, along)
    table = {"stress_xx": np.array([one[0, 0], 2.0, 0.0]), "stress_yy": np.array([one[1, 1], 2.0, 0.0])}
    table.update(stress_xy=np.array([one[0, 1] + 0.1, 0.0, 0.0]), stress_yx=np.array([one[0, 1] - 0.1, 0.0, 0.0]))
    pressure, anisotropy, angle = principal(table)
    np.testing.assert_allclose(pressure, [0.5, 2.0, 0.0])
    np.testing.assert_allclose(anisotropy, [1.0, 0.0, np.nan], atol=1e-12)
    assert np.degrees(angle[0]) == pytest.approx(30.0)


def test_stress_shows_both_fields_and_bars_along_the_major_axis(folder):
    run, figure = drawn(folder, "stress")
    upper, lower = figure.axes[:2]
    fields = run.analysis["fields"]
    dense = fields["solid_fraction"] > 0.2
    for axes, name in ((upper, "solid_fraction"), (lower, None)):
        shown = of_kind(axes, QuadMesh)[0].get_array().reshape(dense.shape)
        expected = fields[name] if name else 0.5 * (fields["stress_xx"] + fields["stress_yy"])
        np.testing.assert_array_equal(np.ma.getmaskarray(shown), ~dense)
        np.testing.assert_allclose(shown[dense].data, expected[dense])
    assert upper.get_xlim() == lower.get_xlim() and upper.get_ylim() == lower.get_ylim()
    bars = np.array(of_kind(lower, LineCollection)[0].get_segments())
    along = bars[:, 1] - bars[:, 0]
    np.testing.assert_allclose(np.degrees(np.arctan2(along[:, 1], along[:, 0])), 60.0)
    length = np.hypot(*along.T)
    np.testing.assert_allclose(length, length[0])
    distance = np.unique(np.round(np.diff(np.unique(np.round(bars.mean(axis=1)[:, 0], 6))), 6))
    assert len(distance) == 1
    np.testing.assert_allclose(length[0], distance[0] * 0.3 / LONGEST)
    assert f"= {LEGEND_VALUE:g}" in legend_of(figure)[0]
    texts = [text.get_text() for text in figure.texts]
    assert "pressure / (mg/σ)" in texts and "solid fraction, Gaussian of width 1.5 σ" in texts


def test_stress_in_cells_that_a_wall_cuts_is_that_before_the_wall(folder):
    """Half of each cell is behind a wall, and the densities with it: the picture shows what is before it."""
    _, whole = drawn(folder, "stress")
    with h5py.File(folder / "analysis.h5", "a") as file:
        for name in ("room", "density", "solid_fraction", "stress_xx", "stress_xy", "stress_yx", "stress_yy"):
            file[f"fields/{name}"][()] = 0.5 * file[f"fields/{name}"][()]
    _, cut = drawn(folder, "stress")
    for before, after in zip(whole.axes[:2], cut.axes[:2]):
        one, two = (of_kind(axes, QuadMesh)[0].get_array() for axes in (before, after))
        np.testing.assert_array_equal(np.ma.getmaskarray(one), np.ma.getmaskarray(two))
        np.testing.assert_allclose(one.compressed(), two.compressed())


def test_no_stress_is_called_by_the_sign_of_a_diameter(folder):
    _, figure = drawn(folder, "stress")
    assert not any("σ₁" in text for text in legend_of(figure))


def test_velocity_shows_the_speed_and_arrows(folder):
    run, figure = drawn(folder, "velocity")
    axes = figure.axes[0]
    fields = run.analysis["fields"]
    dense = fields["solid_fraction"] > 0.2
    shown = of_kind(axes, QuadMesh)[0].get_array().reshape(dense.shape)
    np.testing.assert_allclose(shown[dense].data, np.abs(fields["velocity_x"][dense]))
    (arrows,) = of_kind(axes, Quiver)
    assert (arrows.U > 0.0).all() and (arrows.V == 0.0).all() and len(arrows.U) > 5
    assert "speed of the mean flow / √(gσ)" in [text.get_text() for text in figure.texts]


def test_temperature(folder):
    run, figure = drawn(folder, "temperature")
    shown = of_kind(figure.axes[0], QuadMesh)[0].get_array()
    np.testing.assert_allclose(shown.compressed(), 0.25)
    assert "granular temperature / gσ" in [text.get_text() for text in figure.texts]


def test_stress_of_si_runs_has_their_units(tmp_path):
    folder = write_run(tmp_path / "run", **HEAP, diameter=0.002, units="SI", grain_weight=3e-5)
    texts = [text.get_text() for text in drawn(folder, "stress")[1].texts]
    assert "pressure (N/m)" in texts and "solid fraction, Gaussian of width 0.003 m" in texts


def test_force_distribution_shows_density_errors_and_the_exponential(folder):
    run, figure = drawn(folder, "force_distribution")
    axes = figure.axes[0]
    forces = run.analysis["forces"]
    some = forces["density"] > 0.0
    assert not some.all()
    assert axes.get_yscale() == "log"
    guide, points = axes.get_lines()[:2]
    np.testing.assert_allclose(guide.get_ydata(), np.exp(-guide.get_xdata()))
    np.testing.assert_allclose(guide.get_xdata(), [0.0, forces["f"][-1] + 0.5 * BIN])
    np.testing.assert_allclose(points.get_xydata(), np.column_stack([forces["f"], forces["density"]])[some])
    bars = np.array(of_kind(axes, LineCollection)[0].get_segments())
    np.testing.assert_allclose(bars[:, 1, 1] - bars[:, 0, 1], 2.0 * forces["error"][some])
    assert legend_of(axes) == ["exponential of the same mean", "normal forces"]
    assert axes.get_ylabel() == "probability density P(f)"
    assert figure.texts[0].get_text() == "bars: √(count); mean 2.5 grain weights; 40.0 % above the mean; 5.0 % sliding"


def test_force_distribution_begins_at_the_threshold(folder):
    """The exponential beside it has the same mean and no force below the threshold either."""
    with h5py.File(folder / "analysis.h5", "a") as file:
        file["forces/f"][()] = file["forces/f"][()] + 0.08
    axes = drawn(folder, "force_distribution")[1].axes[0]
    guide = axes.get_lines()[0]
    assert guide.get_xdata()[0] == pytest.approx(0.08)
    assert legend_of(axes)[:2] == ["exponential of the same mean above the threshold", "force threshold"]
    f = np.linspace(0.08, 40.0, 400001)
    density = exponential(f, 0.08)
    np.testing.assert_allclose(guide.get_ydata(), exponential(guide.get_xdata(), 0.08))
    assert [np.trapz(density, f), np.trapz(f * density, f)] == pytest.approx([1.0, 1.0], abs=1e-5)


def test_density_shows_the_solid_fraction_and_says_what_the_lines_are(folder):
    run, figure = drawn(folder, "density")
    fields = run.analysis["fields"]
    shown = of_kind(figure.axes[0], QuadMesh)[0].get_array()
    np.testing.assert_allclose(shown.compressed(), fields["solid_fraction"][fields["solid_fraction"] > 0.2])
    assert "solid fraction, Gaussian of width 1.5 σ" in [text.get_text() for text in figure.texts]
    assert legend_of(figure) == ["pair in contact; lines are sparse where the packing is loose"]
    (folder / "analysis.h5").unlink()
    _, figure = drawn(folder, "density")
    assert not of_kind(figure.axes[0], QuadMesh) and len(figure.axes) == 1


def test_chains_draw_the_contacts_of_each_in_its_colour(folder):
    run, figure = drawn(folder, "chains")
    field, histogram = figure.axes
    chains = run.analysis["chains"]
    own = 3  # colours fit into the legend of this narrow figure
    loaded = chains["chain"][run.state.contacts.normal_force > 0.0]
    lines = {}
    for part in of_kind(field, PathCollection):
        if len(part.get_facecolor()) == 0:  # lines, not discs
            count = sum(len(path.vertices) // 2 for path in part.get_paths())
            colour = to_hex(part.get_edgecolor()[0])
            lines[colour] = lines.get(colour, 0) + count
    expected = {style.SERIES[k]: np.count_nonzero(loaded == k) for k in range(own)}
    assert lines == {**expected, style.GREY: np.count_nonzero(loaded >= own)}
    assert legend_of(figure) == [*(str(size) for size in chains["contacts"][:own]), "5 others"]
    assert "contacts per strong cluster" in [text.get_text() for text in figure.texts]  # it branches: no chain
    assert figure.legends[0].get_window_extent().x1 < figure.bbox.x1
    steps = {patch.get_label(): patch.get_data().values for patch in histogram.patches}
    for name, column in (("all contacts", "direction_all"), ("above the mean force", "direction_strong")):
        values = run.analysis["forces"][column]
        np.testing.assert_allclose(steps[name], [*values, values[0]])  # the first bin holds 0 and 180
    edges = histogram.patches[0].get_data().edges
    np.testing.assert_allclose(edges, np.arange(-7.5, 188.0, 15.0))
    assert histogram.get_xlim() == (0.0, 180.0)


@pytest.mark.parametrize("name", ["strongest", "weakest"])
def test_lines_of_force_are_the_contacts_of_the_analysis(folder, name):
    """Each once, the horizontal ones in their own colour; the widest is that of the largest force."""
    run, figure = drawn(folder, name)
    contacts = run.state.contacts
    rows = np.unique(run.analysis["force_lines"][name])
    horizontal = np.abs(contacts.normal[rows, 1]) < 0.25
    lines, widest = {}, 0.0
    for part in of_kind(figure.axes[0], PathCollection):
        if len(part.get_facecolor()) == 0:  # lines, not discs
            count = sum(len(path.vertices) // 2 for path in part.get_paths())
            colour = to_hex(part.get_edgecolor()[0])
            lines[colour] = lines.get(colour, 0) + count
            widest = max(widest, *part.get_linewidths())
    expected = {style.INK: np.count_nonzero(~horizontal), style.ORANGE: np.count_nonzero(horizontal)}
    assert {colour: lines.get(to_hex(colour), 0) for colour in expected} == expected
    assert ("horizontal" in legend_of(figure)) == horizontal.any()
    largest = contacts.normal_force[rows].max()
    assert f"≥ {largest:.3g}" in legend_of(figure)
    assert widest == max(handle.get_linewidth() for legend in figure.legends for handle in legend.get_lines())
    assert f"{name} contact, in grain weights" in [text.get_text() for text in figure.texts]


def test_stability_shows_the_mode_as_arrows(folder):
    """Centred on the grains; small displacements have none."""
    run, figure = drawn(folder, "stability")
    (arrows,) = of_kind(figure.axes[0], Quiver)
    mode = run.analysis["stability"]
    long = np.abs(mode["displacement"][:, 0]) * 2.5 > 0.15
    np.testing.assert_allclose(arrows.U, 2.5 * mode["displacement"][long, 0])
    np.testing.assert_allclose(arrows.V, 0.0)
    centre = run.state.grains.position[run.state.rows(mode["id"])][long]
    np.testing.assert_allclose(arrows.XY + 0.5 * np.column_stack([arrows.U, arrows.V]), centre)
    assert legend_of(figure) == ["unstable: -2.5 grain weights per diameter"]


def test_slips_are_marked_on_the_force_and_their_drops_counted(folder):
    _, figure = drawn(folder, "slips")
    force, drops = figure.axes
    (marked,) = of_kind(force, LineCollection)
    np.testing.assert_allclose(marked.get_segments(), [[[1, 6], [2, 2]], [[4, 4], [5, 2]], [[7, 4], [8, 3]]])
    np.testing.assert_allclose(drops.lines[0].get_xydata(), [[1.0, 1.0], [2.0, 2 / 3], [4.0, 1 / 3]])
    # The law of exponent 2 falls as 1/x from the first drop on.
    np.testing.assert_allclose(drops.lines[1].get_xydata()[-1], [4.0, 0.25])
    assert "3 slips of wall piston; drops: undecided: 3 events" in [text.get_text() for text in figure.texts]


def test_avalanches_show_sizes_angles_and_depth(folder):
    run, figure = drawn(folder, "avalanches")
    moved, angles, depth = figure.axes
    motion = run.analysis["motion"]
    np.testing.assert_allclose(moved.patches[0].get_data().values, motion["moved"])
    spans = np.array(of_kind(moved, LineCollection)[0].get_segments())
    np.testing.assert_allclose(spans, [[[20.0, 12.0], [24.0, 12.0]], [[80.0, 30.0], [90.0, 30.0]]])
    assert moved.get_ylim()[1] > 30.0
    for line, name in zip(angles.get_lines(), ("left", "right")):
        np.testing.assert_allclose(line.get_ydata(), motion[f"angle_{name}"])
        assert line.get_label() == f"{name} flank"
    np.testing.assert_allclose(depth.get_lines()[0].get_ydata(), motion["depth"])
    assert depth.get_xlim() == (0.0, 120.0)
    assert depth.get_ylabel() == "depth of the\nmoving layer / σ"
    caption = figure.texts[0].get_text()
    assert caption == "2 avalanches of 10 grains or more in 2 √(σ/g), the largest of 30 grains"


def test_track_without_an_avalanche(folder):
    with h5py.File(folder / "analysis.h5", "a") as file:
        file["motion/moved"][:] = 0
        file["motion/depth"][:] = np.nan
        for name in list(file["avalanches"]):
            del file["avalanches"][name]
            file["avalanches"][name] = np.empty(0)
    _, figure = drawn(folder, "avalanches")
    assert figure.texts[0].get_text() == "no avalanches of 10 grains or more in 2 √(σ/g)"
    assert legend_of(figure.axes[0]) == ["moved in one interval"]


@pytest.mark.parametrize("name", ["heap", "forces", "chains", "strongest", "weakest", "stability", "voronoi", "stress"])
@pytest.mark.parametrize("moving", [pyramid(3), pyramid(12)], ids=["small", "large"])
def test_legends_stay_within_the_figure(tmp_path, name, moving):
    _, figure = drawn(write_run(tmp_path / "run", moving, base_row(20)), name)
    for part in [*figure.legends, *figure.texts, *figure.axes]:
        box = part.get_tightbbox() if part in figure.axes else part.get_window_extent()
        assert box.x0 >= 0.0 and box.x1 <= figure.bbox.x1 and box.y0 >= 0.0 and box.y1 <= figure.bbox.y1


def test_walls_show_the_force_of_the_grains(tmp_path):
    folder = write_run(tmp_path / "run", moving=pyramid(8) - [0.0, np.sqrt(3.0) / 2.0 - 0.5], floor=True)
    run, figure = drawn(folder, "walls")
    (axes,) = figure.axes
    (line,) = axes.get_lines()
    np.testing.assert_allclose(line.get_xdata(), run.series["time"])
    np.testing.assert_allclose(line.get_ydata(), 3.0)  # pushed down along minus its normal
    assert legend_of(axes) == ["floor"]


# The normal of a wall that rotates turns back with its angle: a force of 3 along it at each row is a pressure of 3 at each.
# Its angle is no displacement.
def test_a_rotating_wall_shows_the_force_along_its_normal(tmp_path):
    folder = write_run(tmp_path / "run", moving=pyramid(8), floor=True)
    with h5py.File(folder / "run.h5", "a") as file:
        angle = np.linspace(0.0, 1.5, len(file["series/time"]))
        normal = np.array([np.sin(1.5 - angle), np.cos(1.5 - angle)])  # [0, 1] at the end
        file["walls/rotates"][0] = 1
        file["series/wall_displacement"][:, 0] = angle
        file["series/wall_force_x"][:, 0], file["series/wall_force_y"][:, 0] = -3.0 * normal
    _, figure = drawn(folder, "walls")
    (axes,) = figure.axes
    np.testing.assert_allclose(axes.get_lines()[0].get_ydata(), 3.0)


def test_moved_wall_is_drawn_at_its_displacement(tmp_path):
    folder = write_run(tmp_path / "run", moving=pyramid(8), floor=True)
    with h5py.File(folder / "run.h5", "a") as file:
        file["walls/direction"][0] = [0.0, -1.0]
        file["series/wall_displacement"][:, 0] = np.linspace(0.0, 2.0, len(file["series/time"]))
        file.attrs["time"] = file["series/time"][-1]
    run, figure = drawn(folder, "heap")
    traces = [line for line in figure.axes[0].get_lines() if to_hex(line.get_color()) == style.HELD]
    assert len(traces) == 1
    points, _ = wall_places(run, run.state)
    assert points.tolist() == [[0.0, -2.0]]
    run, figure = drawn(folder, "walls")
    force, displacement = figure.axes
    np.testing.assert_allclose(force.get_lines()[0].get_ydata(), -3.0)  # pushed in the direction of its motion
    np.testing.assert_allclose(displacement.get_lines()[0].get_ydata(), run.series["wall_displacement"][:, 0])


def test_budget_shows_every_entry(tmp_path):
    folder = write_run(tmp_path / "run", moving=pyramid(8), floor=True)
    run, figure = drawn(folder, "budget")
    top, bottom = figure.axes
    added = run.energy["sources"] + run.energy["walls_work"] + run.energy["loads_work"]
    assert legend_of(top)[0] == "input"
    by_label = {line.get_label(): line.get_ydata() for line in top.get_lines()}
    np.testing.assert_allclose(by_label["input"], added / added.max())
    for label, name in (("damping", "damping"), ("at walls", "walls"), ("elastic", "elastic"), ("lost grains", "lost")):
        np.testing.assert_allclose(by_label[label], run.energy[name] / added.max())
    np.testing.assert_allclose(bottom.get_lines()[0].get_ydata(), run.energy["error"] / added.max())
