# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the base below spheres show the numbers of the files: checked on the objects of the figures."""

import h5py
import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from matplotlib.quiver import Quiver
from synthetic_spheres import AXIS, cone, square_layer, write_spheres
from test_sphere_pictures import RUNS, circles_of, drawn, folder, radii_of  # noqa: F401, folder is a fixture

from repose.errors import NotDrawn
from repose.pictures.spheres.base_cells import NO_CELLS, mean_shear_of_cells, nearest_cells
from repose.pictures.spheres.base_map import mean_shear
from repose.pictures.spheres.base_rings import hydrostatic


def test_base_map_has_the_force_of_each_loaded_grain(folder):
    run, figure = drawn(folder, "base_map")
    idle, busy = circles_of(figure.axes[0])
    loaded = run.base["normal"] > 0.0
    np.testing.assert_allclose(busy.get_array(), run.base["normal"][loaded])
    np.testing.assert_allclose(busy.get_offsets(), np.column_stack([run.base["x"], run.base["y"]])[loaded])
    np.testing.assert_allclose(radii_of(busy), 0.5)
    (arrows,) = [artist for artist in figure.axes[0].collections if isinstance(artist, Quiver)]
    outwards = arrows.U * arrows.X + arrows.V * arrows.Y
    assert (outwards > 0.0).all()  # the shear of this base points outwards
    (cross,) = [line for line in figure.axes[0].get_lines() if line.get_marker() == "+"]
    assert (cross.get_xdata()[0], cross.get_ydata()[0]) == pytest.approx(tuple(AXIS))


def test_base_map_draws_upper_base_grains_over_lower_ones(tmp_path):
    base = square_layer(4, 0.0)
    base[::2, 2] = -0.4
    _, figure = drawn(write_spheres(tmp_path / "run", cone(3.0), base), "base_map")
    height = {tuple(place[:2]): place[2] for place in base}
    for circles in circles_of(figure.axes[0]):
        levels = [height[tuple(np.round(place, 6))] for place in circles.get_offsets()]
        assert levels == sorted(levels)


def test_base_map_of_a_floor_has_the_pressure_of_each_cell(tmp_path):
    run, figure = drawn(write_spheres(tmp_path / "run", **RUNS["floor"]), "base_map")
    axes = figure.axes[0]
    cells = nearest_cells(run.analysis["base_cells"], 0.995)
    assert 20 < len(cells["x"]) < len(run.analysis["base_cells"]["x"])
    (squares,) = [artist for artist in axes.collections if type(artist) is PolyCollection]
    np.testing.assert_allclose(squares.get_array(), cells["pressure"])
    corners = np.array([path.vertices[:4] for path in squares.get_paths()])
    np.testing.assert_allclose(corners.mean(axis=1), np.column_stack([cells["x"], cells["y"]]), atol=1e-12)
    np.testing.assert_allclose(np.ptp(corners, axis=1), 2.0)
    (arrows,) = [artist for artist in axes.collections if isinstance(artist, Quiver)]
    assert (arrows.U * arrows.X + arrows.V * arrows.Y >= 0.0).all()  # the shear of this floor points outwards
    assert "pressure on the floor / (mg/σ²)" in [text.get_text() for text in figure.texts]


def test_a_run_without_a_base_has_no_base_map(tmp_path):
    folder = write_spheres(tmp_path / "run", **RUNS["floor"])
    with h5py.File(folder / "analysis.h5", "a") as file:
        del file["base_cells"]
    with pytest.raises(NotDrawn, match=NO_CELLS):
        drawn(folder, "base_map")


def test_the_nearest_cells_hold_the_load():
    """A heap of 99 about x = 1 and two far cells with the rest."""
    cells = {"x": np.array([-50.0, 0.0, 1.0, 2.0, 40.0]), "y": np.zeros(5), "pressure": np.array([0.5, 24.0, 51.0, 24.0, 0.5])}
    assert list(nearest_cells(cells, 0.98)["x"]) == [0.0, 1.0, 2.0]
    assert list(nearest_cells(cells, 0.995)["x"]) == [0.0, 1.0, 2.0, 40.0]
    assert len(nearest_cells(cells, 1.0)["x"]) == 5
    still = {**cells, "pressure": np.zeros(5)}
    assert nearest_cells(still, 0.5) is still


def test_mean_shear_of_groups_of_cells_counts_those_without_a_load():
    """Two by two cells of sides 2 and 3, of which one is not listed, and a cell of the next group along x."""
    cells = {"x": np.array([1.0, 1.0, 3.0, 5.0]), "y": np.array([1.0, 4.0, 1.0, 1.0])}
    cells |= {"shear_x": np.array([1.0, 2.0, 5.0, 4.0]), "shear_y": np.array([0.0, 8.0, 0.0, -4.0])}
    middle, mean = mean_shear_of_cells(cells, np.array([2.0, 3.0]), 2)
    np.testing.assert_allclose(middle, [[2.0, 2.5], [6.0, 2.5]])
    np.testing.assert_allclose(mean, [[2.0, 2.0], [1.0, -1.0]])
    each = mean_shear_of_cells(cells, np.array([2.0, 3.0]), 1)[1]
    np.testing.assert_allclose(each, np.column_stack([cells["shear_x"], cells["shear_y"]]))


def test_mean_shear_of_cells_keeps_the_sum():
    place = np.array([[0.5, 0.5], [1.5, 0.5], [2.5, 0.5]])
    middle, mean = mean_shear(place, np.array([[1.0, 0.0], [3.0, 2.0], [-4.0, 1.0]]), 2.0)
    np.testing.assert_allclose(middle, [[1.0, 1.0], [3.0, 1.0]])
    np.testing.assert_allclose(mean, [[2.0, 1.0], [-4.0, 1.0]])


def test_the_hydrostatic_pressure_is_that_of_the_height_and_carries_the_load():
    """Rings of areas pi and 3 pi below heights of 3 and 1, and one beyond the surface: a load of 12 is 2/pi times the height."""
    rings = {"r": np.array([0.5, 1.5, 2.5]), "inner": np.arange(3.0), "outer": np.arange(1.0, 4.0), "load": np.array([4.0, 11.0, 12.0])}
    surface = {"r": np.array([0.5, 1.5]), "height": np.array([3.0, 1.0])}
    pressure = hydrostatic(rings, surface)
    np.testing.assert_allclose(pressure, np.array([3.0, 1.0, 0.0]) * 2.0 / np.pi)
    assert np.sum(pressure * np.pi * np.array([1.0, 3.0, 5.0])) == pytest.approx(12.0, rel=1e-12)
    assert hydrostatic(rings, {"r": np.array([0.5]), "height": np.array([np.nan])}) is None


def test_base_rings_show_the_rings_and_the_dip_of_the_experiment(folder):
    run, figure = drawn(folder, "base_rings")
    upper, lower = figure.axes
    rings = run.analysis["base_rings"]
    for axes, name in ((upper, "pressure"), (lower, "shear")):
        container = axes.containers[0]
        np.testing.assert_allclose(container.lines[0].get_ydata(), rings[name])
        bars = np.array([segment[:, 1] for segment in container.lines[2][0].get_segments()])
        half = np.nan_to_num(rings[f"{name}_error"])
        np.testing.assert_allclose(bars, np.column_stack([rings[name] - half, rings[name] + half]))
    (band,) = [c for c in upper.collections if c.get_label().startswith("20 to 30 %")]
    corners = band.get_paths()[0].vertices
    largest, at = rings["pressure"].max(), rings["r"][rings["pressure"].argmax()]
    np.testing.assert_allclose([corners[:, 1].min(), corners[:, 1].max()], [0.7 * largest, 0.8 * largest])
    assert corners[:, 0].max() == at
    assert "dip index 1.04 ± 0.02" in figure.texts[0].get_text()
    assert upper.get_ylabel() == "pressure / (mg/σ²)"
