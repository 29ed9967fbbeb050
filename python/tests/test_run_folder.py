# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reading run folders: their data, and one line about damage."""

import h5py
import numpy as np
import pytest
from synthetic import base_row, pyramid, write_run

import repose


@pytest.fixture
def folder(tmp_path):
    return write_run(tmp_path / "run", pyramid(6), base_row(6))


def test_reads_what_was_written(folder):
    run = repose.open(folder)
    assert run.attributes["title"] == "A synthetic <heap>"
    assert run.attributes["periodic"] == 0
    grains = run.state.grains
    assert len(grains) == 12 + 20
    assert grains.position.shape == (32, 2)
    assert grains.held.sum() == 12
    assert grains.held.dtype == run.state.contacts.sliding.dtype == bool
    assert run.state.time == 120.0
    assert list(run.series["time"][:2]) == [0.0, 1.0]
    assert run.base.attributes["window_end"] == 120.0
    assert run.surface.attributes["bin_width"] == 1.0
    assert run.walls is None
    assert run.summary["base_dip"]["index"] == 1.04


def test_grains_of_contacts_are_found_by_ids_with_gaps(folder):
    state = repose.open(folder).state
    assert state.grains.id[-1] > len(state.grains)
    first, second = state.rows(state.contacts.grains).T
    apart = state.grains.position[first] - state.grains.position[second]
    distance = np.linalg.norm(apart, axis=1)
    np.testing.assert_allclose(apart / distance[:, None], state.contacts.normal, atol=1e-12)
    np.testing.assert_allclose(1.0 - distance, state.contacts.overlap, atol=1e-12)


@pytest.mark.parametrize("missing", [6, 10**6, -3])
def test_contact_with_a_missing_grain_is_an_error(folder, missing):
    state = repose.open(folder).state
    assert missing not in state.grains.id
    with pytest.raises(repose.RunFolderError, match="not in the file"):
        state.rows([0, missing])


def test_frames(folder):
    run = repose.open(folder)
    assert run.frames == ["000000"]
    frame = run.frame(0)
    assert (frame.time, frame.frame) == (60.0, "000000")
    assert len(frame.grains) == len(run.state.grains)
    with pytest.raises(repose.RunFolderError, match="no frame 000007 .saved: 000000 to 000000"):
        run.frame("7")


def test_frame_with_a_missing_file(folder):
    (folder / "frames" / "000000.h5").unlink()
    with pytest.raises(repose.RunFolderError, match="no 000000.h5"):
        repose.open(folder).frame(0)


def test_without_summary(folder):
    (folder / "summary.json").unlink()
    assert repose.open(folder).summary == {}


def remove_file(folder):
    (folder / "run.h5").unlink()


def write_noise(folder):
    (folder / "run.h5").write_text("no HDF5")


def cut_short(folder):
    whole = (folder / "run.h5").read_bytes()
    (folder / "run.h5").write_bytes(whole[: len(whole) // 2])


def remove_radius(folder):
    with h5py.File(folder / "run.h5", "a") as file:
        del file["grains/radius"]


def change_format(folder):
    with h5py.File(folder / "run.h5", "a") as file:
        file.attrs["format"] = "another"


def change_version(folder):
    with h5py.File(folder / "run.h5", "a") as file:
        file.attrs["format_version"] = 1


def remove_format(folder):
    with h5py.File(folder / "run.h5", "a") as file:
        del file.attrs["format"]


def remove_units(folder):
    with h5py.File(folder / "run.h5", "a") as file:
        del file.attrs["units"]


def break_summary(folder):
    (folder / "summary.json").write_text('{"base_dip": ')


DAMAGES = {
    remove_file: "no run.h5 or sweep.h5 in this folder",
    write_noise: "cannot be read",
    cut_short: "cannot be read",
    remove_radius: "radius",
    change_format: "not a run of Repose",
    change_version: "format_version 1; this package reads 4",
    remove_units: "no attribute units",
    remove_format: "not a run of Repose",
    break_summary: "summary.json: cannot be read",
}


@pytest.mark.parametrize("damage", DAMAGES, ids=lambda damage: damage.__name__)
def test_damage_is_reported_in_one_line(folder, damage):
    damage(folder)
    with pytest.raises(repose.RunFolderError, match=DAMAGES[damage]) as caught:
        repose.open(folder)
    assert "\n" not in str(caught.value)


def test_no_folder(tmp_path):
    with pytest.raises(repose.RunFolderError, match="no such folder"):
        repose.open(tmp_path / "nowhere")
