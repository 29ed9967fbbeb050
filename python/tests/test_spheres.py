# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reading run folders of spheres: vectors of three numbers, data frames, a notebook, and absent forces."""

import h5py
import numpy as np
import pytest
from synthetic_spheres import cone, square_layer, write_spheres

import repose


@pytest.fixture
def folder(tmp_path):
    return write_spheres(tmp_path / "run", cone(3.0), square_layer(6, 0.0))


def test_vectors_have_three_numbers(folder):
    run = repose.open(folder)
    assert run.attributes["dimension"] == 3
    grains, contacts = run.state.grains, run.state.contacts
    assert len(grains) == len(cone(3.0)) + 13**2
    for vectors in (grains.position, grains.velocity, grains.spin):
        assert vectors.shape == (len(grains), 3)
    for vectors in (contacts.normal, contacts.tangential_force, contacts.history):
        assert vectors.shape == (len(contacts), 3)
    first, second = run.state.rows(contacts.grains).T
    apart = grains.position[first] - grains.position[second]
    np.testing.assert_allclose(apart / np.linalg.norm(apart, axis=1)[:, None], contacts.normal, atol=1e-12)
    assert run.frame(0).grains.position.shape == grains.position.shape
    assert run.surface is None


def test_data_frames_have_columns_for_x_y_and_z(folder):
    pytest.importorskip("pandas")
    state = repose.open(folder).state
    table = state.grains.to_pandas()
    for name in ("position", "velocity", "spin"):
        for k, axis in enumerate("xyz"):
            np.testing.assert_array_equal(table[f"{name}_{axis}"], getattr(state.grains, name)[:, k])
    assert {"normal_z", "tangential_force_z", "history_z", "first", "second"} <= set(state.contacts.to_pandas().columns)


def test_a_run_without_forces_has_zeros_of_the_same_shapes(tmp_path):
    contacts = repose.open(write_spheres(tmp_path / "run", cone(3.0), square_layer(6, 0.0), forces=False)).state.contacts
    assert contacts.normal_force.shape == contacts.sliding.shape == (len(contacts),)
    assert contacts.tangential_force.shape == contacts.history.shape == (len(contacts), 3)
    assert not contacts.normal_force.any() and not contacts.tangential_force.any()


def test_a_notebook_shows_the_projection(folder):
    run = repose.open(folder)
    assert "<img" not in run._repr_html_() and "<iframe" not in run._repr_html_()
    (folder / "pictures").mkdir()
    (folder / "pictures/projection.png").write_bytes(b"some picture")
    assert "<img" in run._repr_html_() and "A synthetic cone" in run._repr_html_()


@pytest.mark.parametrize("group, column", [("cone_surface", "sector_height"), ("base_rings", "load"), ("axial_fields", "stress_rz")])
def test_a_missing_column_is_one_line(folder, group, column):
    with h5py.File(folder / "analysis.h5", "a") as file:
        del file[group][column]
    with pytest.raises(repose.RunFolderError, match=f"analysis.h5: does not follow the format: no dataset /{group}/{column}") as caught:
        repose.open(folder)
    assert "\n" not in str(caught.value)
