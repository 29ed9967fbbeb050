# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reading sweep folders: their data, the axis that they are drawn over, and one line about damage."""

import h5py
import numpy as np
import pytest
from synthetic import base_row, pyramid, write_run
from synthetic_sweep import NAMED, ONE, SCENES, TWO, write_sweep

import repose
from repose.pictures.sweep.axis import axis_of, name_without
from repose.pictures.sweep.panel import in_lines


@pytest.fixture
def sweep(tmp_path):
    return repose.open(write_sweep(tmp_path / "sweep", **ONE))


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


def test_open_distinguishes_runs_and_sweeps(tmp_path):
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
    """No number, one that does not separate all points, or one that some points lack."""
    axis = axis_of(repose.open(write_sweep(tmp_path / "sweep", NAMED["names"], parameters)))
    assert axis.key is None
    assert list(axis.place) == [0.0, 1.0, 2.0]


def test_parts_and_lines_of_names():
    assert name_without("soft_friction=0.5_spacing=1.1", "contact.friction", "0.5") == "soft_spacing=1.1"
    assert name_without("friction=0.5", "contact.friction", "0.5") == ""
    assert name_without("friction=0.55", "contact.friction", "0.5") is None
    assert in_lines("soft_friction=0.5_spacing=1.1", 20) == "soft_friction=0.5\n_spacing=1.1"


DAMAGES = {
    "another format": (lambda file: file.attrs.modify("format", np.bytes_(b"repose-run")), "not a sweep of Repose"),
    "another version": (lambda file: file.attrs.modify("format_version", 2), "format_version 2; this package reads 1"),
    "no title": (lambda file: file.attrs.pop("title"), "does not follow the format: no attribute title"),
    "no error": (lambda file: file.pop("measures/coordination/error"), "no dataset /measures/coordination/error"),
    "no members": (lambda file: file.pop("members"), "does not follow the format: .*members"),
    "no bins": (lambda file: file.pop("profiles/0001/binned"), "does not follow the format: .*binned"),
}


@pytest.mark.parametrize("kind", DAMAGES)
def test_damage_is_reported_in_one_line(tmp_path, kind):
    folder = write_sweep(tmp_path / "sweep", **ONE)
    damage, complaint = DAMAGES[kind]
    with h5py.File(folder / "sweep.h5", "a") as file:
        damage(file)
    with pytest.raises(repose.RunFolderError, match=f"sweep.h5: .*{complaint}") as caught:
        repose.open(folder)
    assert "\n" not in str(caught.value)
