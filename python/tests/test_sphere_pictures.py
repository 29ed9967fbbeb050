# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of runs of spheres show the numbers of the files: checked on the objects of the figures."""

from dataclasses import replace
from pathlib import Path

import h5py
import matplotlib
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import EllipseCollection, QuadMesh
from matplotlib.colors import to_hex
from synthetic_analysis import write_group
from synthetic_column import motion, slices
from synthetic_spheres import AXIS, SLOPE, cone, square_layer, walls_of, write_spheres
from test_plot import assert_shows_something

import repose
from repose import style
from repose.errors import NotDrawn
from repose.movie import picture_of
from repose.pictures.run.common_axes import common_axes
from repose.pictures.run.space_box import space_box
from repose.pictures.run.visible_box import Box
from repose.pictures.spheres import SPHERE_PICTURES
from repose.pictures.spheres.column import law_of_cylinder
from repose.pictures.spheres.cone import scatter_of_sectors
from repose.pictures.spheres.forces import lines_near
from repose.pictures.spheres.places import Plane, circles_in, upright_plane
from repose.pictures.spheres.projection import in_sight
from repose.pictures.spheres.section import carried
from repose.plot import main

FLOOR = dict(name="floor", point=[0.0, 0.0, -0.5], normal=[0.0, 0.0, 1.0])
BED = np.concatenate([square_layer(3, 0.0), square_layer(3, np.sqrt(0.5), 0.5)]) + [0.0, 0.0, 1.0]
NO_GRAINS = np.empty((0, 3))
RUNS = {
    "cone": dict(moving=cone(4.0), base=square_layer(8, 0.0)),
    "si": dict(moving=cone(3.0), base=square_layer(6, 0.0), diameter=0.002, units="SI", grain_weight=3e-5),
    "floor": dict(moving=cone(3.0) - [0.0, 0.0, np.sqrt(0.5)], walls=walls_of(FLOOR)),
    "periodic": dict(moving=BED, base=square_layer(3, 0.0), period=7.0, forces=False),
    "weightless": dict(moving=cone(3.0), base=square_layer(6, 0.0), grain_weight=0.0),
    "one": dict(moving=np.array([[0.0, 0.0, 5.0]]), rows=1, analysis=False),
    "nothing": dict(moving=NO_GRAINS, rows=0, analysis=False),
}
NO_BUDGET = {
    "budget": "the run kept no energy budget (output.energy)",
    "walls": "the run has no walls, or fewer than two rows in its time series",
}
NO_COLUMN = {
    "column": "no column in an upright cylinder was measured",
    "column_motion": "there is no column between two upright walls whose floor moves",
}
NO_FORCE = {"forces": "no contact carries a force"}
NO_ANALYSIS = dict.fromkeys(
    "force_distribution directions voronoi fields base_map base_rings cone avalanches slips column column_motion correlations".split(),
    "the last state has no analysis.h5 (repose analyse DIR writes it)",
)
FEW_ROWS = {"energy": "the time series has fewer than two rows"}
NOT_DRAWN = {
    "floor": NO_COLUMN,
    "periodic": NO_FORCE | NO_BUDGET | NO_COLUMN,
    "one": NO_FORCE | NO_BUDGET | FEW_ROWS | NO_ANALYSIS,
    "nothing": NO_FORCE | NO_BUDGET | FEW_ROWS | NO_ANALYSIS | dict.fromkeys(("projection", "slice"), "no grains"),
}


@pytest.fixture
def folder(tmp_path):
    return write_spheres(tmp_path / "run", **RUNS["cone"])


def drawn(folder, name):
    """(run, figure) of a picture of the last state, laid out."""
    run = repose.open(folder)
    with matplotlib.rc_context(style.RC):
        figure = SPHERE_PICTURES[name](run, run.state)
        FigureCanvasAgg(figure).draw()
    return run, figure


def circles_of(axes):
    return [artist for artist in axes.collections if isinstance(artist, EllipseCollection)]


def radii_of(circles):
    return circles._widths  # Matplotlib keeps half of the widths, and 3.6 has no method for them


@pytest.mark.filterwarnings("error")
@pytest.mark.filterwarnings("ignore::UserWarning:pyparsing")
@pytest.mark.parametrize("kind", RUNS)
def test_draws_every_picture_with_data(tmp_path, capsys, caplog, kind):
    """In all formats; Matplotlib logs a warning where EPS would need transparency, which it lacks."""
    folder = write_spheres(tmp_path / "run", **RUNS[kind])
    assert main([str(folder), "--dpi", "60", "--format", "png,svg,pdf,eps"]) == 0
    assert not caplog.records
    printed = capsys.readouterr()
    assert printed.err == ""
    not_drawn = NOT_DRAWN.get(kind, NO_BUDGET | NO_COLUMN)
    expected = []
    for name in SPHERE_PICTURES:
        if name in not_drawn:
            expected.append(f"{name}: not drawn: {not_drawn[name]}")
        else:
            expected += [str(folder / "pictures" / f"{name}.{suffix}") for suffix in ("png", "svg", "pdf", "eps")]
    assert printed.out.splitlines() == expected
    for line in expected:
        if line.endswith(".png"):
            assert_shows_something(Path(line))


def test_only_takes_the_names_of_spheres(folder, capsys):
    assert main([str(folder), "--only", "slice,cone", "--format", "png", "--frame", "0", "--dpi", "50"]) == 0
    assert [path.name for path in (folder / "pictures").iterdir()] == ["slice-000000.png"]
    assert "cone: not drawn: it shows the end of the run, not a frame" in capsys.readouterr().out
    with pytest.raises(SystemExit):
        main([str(folder), "--only", "stress"])
    assert f"unknown name 'stress', choose from {', '.join(SPHERE_PICTURES)}" in capsys.readouterr().err


@pytest.mark.parametrize("level, radius", [(0.0, 0.5), (0.3, 0.4), (-0.4, 0.3), (0.6, None)])
def test_a_sphere_is_cut_in_the_circle_of_its_section(tmp_path, level, radius):
    """sqrt(r^2 - y^2): 3, 4, 5."""
    run = repose.open(write_spheres(tmp_path / "run", np.array([[1.0, 0.0, 2.0]]), analysis=False))
    plane = Plane(0, 2, 1, level)
    centre, found, row = circles_in(run, run.state, plane, space_box(run, run.state).face(0, 2))
    if radius is None:
        assert len(row) == 0
    else:
        np.testing.assert_allclose(centre, [[1.0, 2.0]])
        np.testing.assert_allclose(found, [radius], rtol=1e-12)


def test_a_section_sees_spheres_across_a_periodic_side(tmp_path):
    """One at (3.3, -3.3) in a box of 7 is 0.2 from the plane y = 3.5 of the other side, and has its image at x = -3.7."""
    run = repose.open(write_spheres(tmp_path / "run", np.array([[3.3, -3.3, 2.0]]), period=7.0, analysis=False))
    centre, radius, row = circles_in(run, run.state, Plane(0, 2, 1, 3.5), space_box(run, run.state).face(0, 2))
    np.testing.assert_allclose(sorted(centre[:, 0]), [-3.7, 3.3])
    np.testing.assert_allclose(radius, np.sqrt(0.25 - 0.04))
    assert list(row) == [0, 0]


def test_slice_shows_the_section_at_the_middle_coloured_by_the_force(folder):
    run, figure = drawn(folder, "slice")
    held, moving = circles_of(figure.axes[0])
    grains = run.state.grains
    cut = np.abs(grains.position[:, 1]) < grains.radius
    np.testing.assert_allclose(moving.get_offsets(), grains.position[cut & ~grains.held][:, [0, 2]])
    np.testing.assert_allclose(held.get_offsets()[:, 1], 0.0)
    np.testing.assert_allclose(moving.get_array(), carried(run.state)[cut & ~grains.held])
    np.testing.assert_allclose(radii_of(moving), np.sqrt(0.25 - grains.position[cut & ~grains.held, 1] ** 2))
    assert to_hex(held.get_facecolor()[0]) == style.HELD
    assert "section at y = 0 σ" in figure.texts[0].get_text()
    assert "sum of normal forces on a grain (grain weights)" in [text.get_text() for text in figure.texts]


def test_each_force_is_carried_by_both_partners(folder):
    """Walls apart, the sum over grains is twice that over contacts."""
    state = repose.open(folder).state
    assert carried(state).sum() == pytest.approx(2.0 * state.contacts.normal_force.sum(), rel=1e-12)


def test_slice_without_forces_shows_heights(tmp_path):
    folder = write_spheres(tmp_path / "run", **RUNS["periodic"])
    run, figure = drawn(folder, "slice")
    moving = circles_of(figure.axes[0])[1]
    np.testing.assert_allclose(moving.get_array(), moving.get_offsets()[:, 1])
    assert "z / σ" in [text.get_text() for text in figure.texts]


def test_forces_are_those_of_contacts_near_the_plane(folder):
    run = repose.open(folder)
    lines, contact = lines_near(run, run.state, upright_plane(space_box(run, run.state)))
    with h5py.File(folder / "run.h5") as file:
        point = file["contacts/point"][()]
    np.testing.assert_array_equal(contact, np.flatnonzero(np.abs(point[:, 1]) <= 0.5))
    grains = run.state.rows(run.state.contacts.grains[contact])
    np.testing.assert_allclose(lines, run.state.grains.position[grains])


def test_a_contact_across_a_periodic_edge_has_two_lines(tmp_path):
    """Along the diagonal of both level axes."""
    half = np.sqrt(0.125)
    pair = np.array([[3.5 - half, 3.5 - half, 1.0], [-3.5 + half, -3.5 + half, 1.0]])
    run = repose.open(write_spheres(tmp_path / "run", pair, period=7.0, analysis=False))
    lines, contact = lines_near(run, run.state, Plane(0, 2, 1, 3.5))
    assert list(contact) == [0, 0]
    np.testing.assert_allclose(np.linalg.norm(lines[:, 1] - lines[:, 0], axis=1), 1.0, rtol=1e-12)
    np.testing.assert_allclose(np.sort(lines[:, :, 0], axis=1), [[3.5 - half, 3.5 + half], [-3.5 - half, -3.5 + half]])


def test_the_projection_leaves_out_what_is_covered():
    """From back to front: one behind a larger one, this one, one beside it, and one half covered by the next."""
    flat = np.array([[0.1, 0.0], [0.0, 0.0], [3.0, 0.0], [6.0, 0.0], [6.5, 0.0]])
    radius = np.array([0.5, 1.0, 0.5, 0.5, 0.5])
    assert list(in_sight(flat, radius, Box(-2.0, 8.0, -2.0, 2.0), 1.0)) == [1, 2, 3, 4]


def test_the_projection_is_drawn_from_back_to_front(folder):
    run, figure = drawn(folder, "projection")
    side, top = figure.axes[:2]
    grains = run.state.grains
    for axes, flat, sign in ((side, [0, 2], -1.0), (top, [0, 1], 1.0)):
        (circles,) = circles_of(axes)
        offsets = np.asarray(circles.get_offsets())
        depth = 3 - sum(flat)
        assert 40 < len(offsets) < len(grains)
        assert {tuple(np.round(p, 6)) for p in offsets} <= {tuple(np.round(p[flat], 6)) for p in grains.position}
        moving = ~grains.held
        nearest = {}
        for p in grains.position[moving]:
            key = tuple(np.round(p[flat], 6))
            nearest[key] = max(nearest.get(key, -np.inf), sign * p[depth])
        drawn_depths = [nearest[tuple(np.round(p, 6))] for p in offsets if tuple(np.round(p, 6)) in nearest]
        assert drawn_depths == sorted(drawn_depths)
    assert [axes.get_ylabel() for axes in (side, top)] == ["z / σ", "y / σ"]


def test_cone_shows_the_surface_and_its_line(folder):
    run, figure = drawn(folder, "cone")
    profile, sectors = figure.axes
    surface = run.analysis["cone_surface"]
    used = surface["used"] == 1
    lines = [container.lines[0] for container in profile.containers]
    np.testing.assert_allclose(lines[0].get_ydata(), surface["height"][used])
    np.testing.assert_allclose(lines[1].get_xdata(), surface["r"][~used])
    bars = np.array([np.ptp(segment[:, 1]) for segment in profile.containers[0].lines[2][0].get_segments()])
    np.testing.assert_allclose(bars, 2.0 * 0.4 * np.sqrt(8.0 / 7.0) / np.sqrt(8.0), rtol=1e-9)
    texts = [text.get_text() for text in profile.get_legend().get_texts()]
    assert f"angle of repose {np.degrees(np.arctan(SLOPE)):.1f}°" in texts
    angle = run.analysis["cone_sectors"]["angle_deg"][:7]
    np.testing.assert_allclose(sectors.get_lines()[0].get_ydata(), angle)
    error = angle.std(ddof=1) / np.sqrt(7)
    assert sectors.get_legend().get_texts()[0].get_text() == f"mean of 7 sectors {angle.mean():.1f}° ± {error:.1f}°"


def test_the_scatter_of_sectors_leaves_out_empty_ones():
    """Of 1, 2, 3: a deviation of 1 over the root of 3."""
    heights = np.array([[1.0, np.nan, 2.0, 3.0], [4.0, np.nan, np.nan, np.nan], [np.nan] * 4])
    np.testing.assert_allclose(scatter_of_sectors(heights), [1.0 / np.sqrt(3.0), 0.0, 0.0])


def test_voronoi_colours_the_section_by_solid_fraction(folder):
    run, figure = drawn(folder, "voronoi")
    held, opened, closed = circles_of(figure.axes[0])
    cells, grains = run.analysis["voronoi"], run.state.grains
    cut = (np.abs(grains.position[:, 1]) < grains.radius) & ~grains.held
    shown = np.isin(grains.id[cut], cells["id"][cells["closed"] == 1])
    np.testing.assert_allclose(closed.get_offsets(), grains.position[cut][shown][:, [0, 2]])
    expected = cells["solid_fraction"][np.searchsorted(cells["id"], grains.id[cut][shown])]
    np.testing.assert_allclose(closed.get_array(), expected)
    assert len(opened.get_offsets()) == np.count_nonzero(~shown) > 0
    assert to_hex(opened.get_facecolor()[0]) == style.FAINT and len(held.get_offsets()) > 0


def test_directions_are_densities_over_the_cosine(folder):
    run, figure = drawn(folder, "directions")
    every, strong = figure.axes[0].patches
    for stairs, name in ((every, "direction_all"), (strong, "direction_strong")):
        values, edges, _ = stairs.get_data()
        np.testing.assert_allclose(values, run.analysis["forces"][name])
        np.testing.assert_allclose(edges, np.linspace(0.0, 1.0, 21), atol=1e-12)


@pytest.mark.parametrize("kind", ["cone", "si", "weightless"])
def test_the_mean_force_is_in_grain_weights(tmp_path, kind):
    folder = write_spheres(tmp_path / "run", **RUNS[kind])
    if kind == "weightless":
        with h5py.File(folder / "analysis.h5", "a") as file:
            file["forces"].attrs["mean"] = 2.5
    caption = drawn(folder, "force_distribution")[1].texts[0].get_text()
    assert ("mean 2.5 grain weights" if kind != "weightless" else "mean 2.5 M L/T²") in caption


def test_fields_have_rows_along_z(folder):
    run, figure = drawn(folder, "fields")
    table = run.analysis["axial_fields"]
    names = ("solid_fraction", "density", "stress_zz", "stress_rr", "stress_tt", "stress_rz")
    panels = [axes for axes in figure.axes if [m for m in axes.collections if isinstance(m, QuadMesh)]][:6]
    for axes, name in zip(panels, names):
        (mesh,) = [m for m in axes.collections if isinstance(m, QuadMesh)]
        shown = mesh.get_array().reshape(table[name].shape)
        inside = table["solid_fraction"] > 0.0
        np.testing.assert_array_equal(np.ma.getmaskarray(shown), ~inside)
        np.testing.assert_allclose(shown[inside], table[name][inside])
        assert axes.get_ylim() == pytest.approx((0.0, table["z"][-1] + 0.5))
    assert panels[0].get_shared_x_axes().joined(panels[0], panels[5])


def test_janssen_in_a_cylinder_tends_to_its_plateau():
    """sigma = rho g D/(4 K friction) far below the surface, rho g h near it."""
    class Run:
        attributes = {"gravity": [0.0, 0.0, -2.0]}

    values = dict(radius=1.5, height=100.0, mass=0.6 * np.pi * 1.5**2 * 100.0, stress_ratio=0.5, friction=0.4)
    law = law_of_cylinder(Run, values)
    assert law.stress(100.0) == pytest.approx(0.6 * 2.0 * 3.0 / (4.0 * 0.5 * 0.4), rel=1e-11)  # less exp(-27)
    assert law.stress(1e-6) == pytest.approx(0.6 * 2.0 * 1e-6, rel=1e-5)


CYLINDER = dict(name="pipe", shape="frustum", point=[AXIS[0], AXIS[1], 4.0], normal=[0.0, 0.0, 1.0], half_length=9.0)
IN_CYLINDER = {"radius": 2.5, "axis_x": AXIS[0], "axis_y": AXIS[1], "floor": 1.5, "floor_wall": 1}
IN_CYLINDER |= {"height": 12.0, "mass": 60.0, "stress_ratio": 0.75, "friction": 0.2}


@pytest.fixture
def column_folder(tmp_path):
    """The slices of a column between walls, in a cylinder about AXIS above the second wall."""
    folder = write_spheres(tmp_path / "column", cone(4.0), walls=walls_of(CYLINDER, FLOOR))
    with h5py.File(folder / "analysis.h5", "a") as file:
        write_group(file.create_group("column"), slices(), **IN_CYLINDER)
        write_group(file.create_group("column_motion"), motion())
    return folder


def test_a_column_in_a_cylinder_has_its_section_and_the_law(column_folder):
    run, figure = drawn(column_folder, "column")
    grains, stresses = figure.axes
    assert grains.get_ylim() == stresses.get_ylim()
    for patch, name in zip(stresses.patches, ("pressure", "shear")):
        np.testing.assert_allclose(patch.get_data().values, slices()[name])
        np.testing.assert_allclose(patch.get_data().edges, 1.5 + np.arange(0.0, 13.0, 2.0))  # from the floor
    dashed = [line.get_xydata() for line in stresses.get_lines() if line.get_linestyle() == "--"]
    law = law_of_cylinder(run, IN_CYLINDER)
    np.testing.assert_allclose(dashed[0][[0, -1]], [[0.0, 13.5], [law.stress(12.0), 1.5]], atol=1e-12)
    depth = np.linspace(0.0, 12.0, 20001)
    carried = 2.0 * np.pi * 2.5 * 0.2 * np.trapz(law.pressure(depth), depth)
    assert law.stress(12.0) * np.pi * 2.5**2 + carried == pytest.approx(60.0)  # floor and cylinder carry the weight
    assert stresses.get_xlabel() == "stress / (mg/σ²)"
    assert f"section at y = {AXIS[1]:g}" in figure.texts[0].get_text()


def test_the_motion_of_a_column_in_a_cylinder(column_folder):
    """The load is the force along z on the wall that the analysis names."""
    _, figure = drawn(column_folder, "column_motion")
    moved, _, front, load = figure.axes
    np.testing.assert_allclose(moved.get_lines()[0].get_ydata(), motion()["floor"])
    np.testing.assert_allclose(front.get_lines()[0].get_ydata(), motion()["front"])
    np.testing.assert_allclose(load.get_lines()[0].get_ydata(), 3.0)


def test_frames_share_a_box_and_its_colours(folder):
    run = repose.open(folder)
    axes = common_axes(run)
    whole = space_box(run, run.state)
    assert axes.box == whole  # the frame has the same grains
    shown = [SPHERE_PICTURES["projection"](run, replace(state, axes=axes)) for state in (run.frame(0), run.state)]
    assert shown[0].get_size_inches() == pytest.approx(shown[1].get_size_inches())


def test_spheres_in_flight_do_not_widen_the_box(tmp_path):
    flying = np.array([[0.0, 0.0, 60.0], [0.0, 30.0, 61.0], [-30.0, 0.0, 62.0]])
    still = repose.open(write_spheres(tmp_path / "still", **RUNS["cone"]))
    run = repose.open(write_spheres(tmp_path / "run", np.concatenate([cone(4.0), flying]), square_layer(8, 0.0)))
    assert space_box(run, run.state) == space_box(still, still.state)
    figure = SPHERE_PICTURES["slice"](run, run.state)
    assert "(3 outside the picture)" in figure.texts[0].get_text()


def test_movies_of_spheres(folder):
    run = repose.open(folder)
    assert picture_of(run, "heap") is SPHERE_PICTURES["projection"]
    assert picture_of(run, "forces") is SPHERE_PICTURES["forces"]
    with pytest.raises(NotDrawn, match="density: is drawn in two dimensions alone"):
        picture_of(run, "density")


def test_positions_that_are_nan_are_left_out(folder):
    with h5py.File(folder / "run.h5", "a") as file:
        file["grains/position"][-1] = np.nan
        file["contacts/normal_force"][:3] = np.nan
    assert main([str(folder), "--dpi", "50", "--format", "png", "--only", "projection,slice,forces"]) == 0
    assert len(list((folder / "pictures").iterdir())) == 3
