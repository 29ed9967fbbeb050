# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Species in the picture of a heap: by material and size, each with a colour and a name."""

import h5py
import numpy as np
import pytest
from matplotlib.collections import PathCollection
from matplotlib.colors import to_hex
from synthetic import base_row, pyramid, write_run

import repose
from repose import style
from repose.pictures.run import heap
from repose.pictures.run.species import kinds_of, members_of

MATERIALS = '[[material]]\nname = "sand"\n[[material]]\nname = "sugar"\n'
ONE_MATERIAL = """
[[species]]
name = "coarse"
[species.sizes]
kind = "uniform"
low = 0.9
high = 1.1
[[species]]
name = "fine"
sizes = { kind = "table", diameters = [0.2, 0.5], weights = [1, 1] }
"""
OVERLAPPING = ONE_MATERIAL.replace("0.9", "0.4")
TWO_MATERIALS = MATERIALS + '[[species]]\nname = "a"\nmaterial = "sand"\n[[species]]\nname = "b"\nmaterial = "sugar"\n'


def run_with(tmp_path, scene):
    """A heap of discs of diameter 1 and 0.5 in turn; every third is of the second material."""
    folder = write_run(tmp_path / "run", pyramid(8), base_row(8))
    with h5py.File(folder / "run.h5", "a") as file:
        file["scene"] = np.array([scene.encode()])
        moving = file["grains/fixed"][()] == 0
        number = np.arange(len(moving))
        file["grains/radius"][()] = np.where(moving & (number % 2 == 1), 0.25, 0.5)
        file["grains/material"][()] = np.where(moving & ("material" in scene) & (number % 3 == 0), 1, 0)
    return repose.open(folder)


@pytest.mark.parametrize(
    "scene, names, expected",
    [
        ("", [""], lambda grains: 0 * grains.material),
        (MATERIALS, ["sand", "sugar"], lambda grains: grains.material),
        (TWO_MATERIALS, ["a", "b"], lambda grains: grains.material),
        (ONE_MATERIAL, ["fine", "coarse"], lambda grains: grains.radius > 0.3),
        (OVERLAPPING, ["fine, coarse"], lambda grains: 0 * grains.material),
    ],
)
def test_kinds_are_told_apart_by_material_then_size(tmp_path, scene, names, expected):
    run = run_with(tmp_path, scene)
    kinds = kinds_of(run)
    assert [kind.name for kind in kinds] == names
    moving = ~run.state.grains.held
    np.testing.assert_array_equal(members_of(kinds, run.state.grains)[moving], expected(run.state.grains)[moving])


def test_materials_without_grains_have_no_colour(tmp_path):
    run = run_with(tmp_path, MATERIALS + '[[material]]\nname = "steel"\n')
    assert [kind.name for kind in kinds_of(run)] == ["sand", "sugar"]


def test_heap_has_a_colour_and_a_name_for_each(tmp_path):
    run = run_with(tmp_path, TWO_MATERIALS)
    figure = heap.draw(run, run.state)
    names = [[text.get_text() for text in legend.get_texts()] for legend in figure.legends]
    assert names == [["a", "b"], ["left flank 60.0°"]]
    drawn = {}
    for part in figure.axes[0].collections:
        if isinstance(part, PathCollection):
            drawn[to_hex(part.get_facecolor()[0])] = sum(np.count_nonzero(path.codes == 1) for path in part.get_paths())
    moving = ~run.state.grains.held
    for k in range(2):
        assert drawn[style.SPECIES[k]] == np.count_nonzero(moving & (run.state.grains.material == k))
        assert to_hex(figure.legends[0].get_patches()[k].get_facecolor()) == style.SPECIES[k]
