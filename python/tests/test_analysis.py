# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reading analysis.h5: its groups, None for absent ones, and one line about damage."""

import h5py
import numpy as np
import pytest
from synthetic import base_row, pyramid, write_run

import repose
from repose.analysis import GROUPS
from repose.errors import NotDrawn
from repose.pictures.run import RUN_PICTURES

PICTURE_OF = {
    "voronoi": ("voronoi", "there is no heap"),
    "fields": ("stress", "there is no heap"),
    "forces": ("force_distribution", "no contact force exceeds analysis.force_threshold"),
    "chains": ("chains", "no contact force exceeds analysis.force_threshold"),
    "force_lines": ("strongest", "no contact force exceeds analysis.force_threshold"),
    "stability": ("stability", "its stability was not analysed .repose analyse DIR --stability."),
    "drive": ("slips", "its slips were not looked for .repose analyse DIR --slips."),
    "motion": ("avalanches", "the run recorded no track .output.track = 0."),
}  # by group: the picture that needs it, and the reason why it is not drawn without


@pytest.fixture
def folder(tmp_path):
    return write_run(tmp_path / "run", pyramid(6), base_row(6))


def change(folder, damage):
    with h5py.File(folder / "analysis.h5", "a") as file:
        damage(file)


def test_reads_what_was_written(folder):
    run = repose.open(folder)
    assert list(run.analysis) == list(GROUPS)
    assert run.analysis.attributes["time"] == 120.0
    assert run.surface is run.analysis["surface"]
    assert run.surface.attributes["bin_width"] == 1.0
    assert run.analysis["base"].attributes["bin_width"] == 3.0
    assert len(run.analysis["voronoi"]["offset"]) == 20 + 1
    assert run.analysis["voronoi"]["vertices"].shape == (120, 2)
    assert run.analysis["fields"]["stress_xy"].shape == run.analysis["fields"]["density"].shape
    assert len(run.analysis["chains"]["chain"]) == len(run.state.contacts)
    assert list(run.analysis["avalanches"]["size"]) == [12, 30]
    assert run.analysis["bursts"].attributes["threshold"] == 5.0


def test_without_analysis(folder):
    (folder / "analysis.h5").unlink()
    run = repose.open(folder)
    assert run.analysis is None and run.surface is None
    for picture in ("chains", "force_distribution", "voronoi", "stress", "avalanches"):
        with pytest.raises(NotDrawn, match="the last state has no analysis.h5 .repose analyse DIR writes it."):
            RUN_PICTURES[picture](run, run.state)
    for picture in ("heap", "density", "forces", "base", "energy"):
        assert RUN_PICTURES[picture](run, run.state)


@pytest.mark.parametrize("group", PICTURE_OF)
def test_absent_group(folder, group):
    change(folder, lambda file: file.pop(group))
    run = repose.open(folder)
    assert run.analysis[group] is None
    picture, reason = PICTURE_OF[group]
    with pytest.raises(NotDrawn, match=reason):
        RUN_PICTURES[picture](run, run.state)


def test_a_frame_has_no_analysis(folder):
    run = repose.open(folder)
    for picture, _ in PICTURE_OF.values():
        with pytest.raises(NotDrawn, match="not a frame"):
            RUN_PICTURES[picture](run, run.frame(0))
    assert not RUN_PICTURES["heap"](run, run.frame(0)).legends  # no flanks


def test_analysis_of_an_earlier_state_is_none(folder):
    change(folder, lambda file: file.attrs.modify("time", 100.0))
    assert repose.open(folder).analysis is None


def test_analysis_of_other_contacts_is_none(folder):
    def damage(file):
        del file["chains/chain"]
        file["chains/chain"] = np.zeros(3, dtype=int)

    change(folder, damage)
    assert repose.open(folder).analysis is None


DAMAGES = {
    "another format": (lambda file: file.attrs.modify("format", np.bytes_(b"repose-run")), "not an analysis of Repose"),
    "another version": (lambda file: file.attrs.modify("format_version", 2), "format_version 2; this package reads 1"),
    "no time": (lambda file: file.attrs.pop("time"), "does not follow the format: no attribute time"),
    "no area": (lambda file: file.pop("voronoi/area"), "does not follow the format: no dataset /voronoi/area"),
}


@pytest.mark.parametrize("kind", DAMAGES)
def test_damage_is_reported_in_one_line(folder, kind):
    damage, complaint = DAMAGES[kind]
    change(folder, damage)
    with pytest.raises(repose.RunFolderError, match=f"analysis.h5: {complaint}") as caught:
        repose.open(folder)
    assert "\n" not in str(caught.value)


def test_file_that_is_not_hdf5(folder):
    (folder / "analysis.h5").write_text("no HDF5")
    with pytest.raises(repose.RunFolderError, match="analysis.h5: cannot be read"):
        repose.open(folder)
