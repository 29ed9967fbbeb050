# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The box and the scale of forces that all pictures of a run share, so that its frames make a movie."""

from dataclasses import dataclass

import numpy as np

from repose.errors import NotDrawn
from repose.pictures.run.space_box import SpaceBox, space_box
from repose.pictures.run.visible_box import Box, supported, visible_box

WIDEST_PERCENTILE = 99.5  # forces above it have the largest width


@dataclass(frozen=True)
class CommonAxes:
    """What pictures of different states have in common."""

    box: "Box | SpaceBox | None"  # around the heaps of all states; None without a grain
    largest_force: float  # [M L/T^2] drawn with the largest width; 0 without a force


def common_axes(run):
    """Those of all frames and the last state. Grains in flight count only where no state has supported ones."""
    with_heap, without, sizes = [], [], []
    box_of = visible_box if run.attributes["dimension"] == 2 else space_box
    for state in (*map(run.frame, run.frames), run.state):
        sizes.append(sizes_of_forces(state))
        try:
            (with_heap if supported(state).any() else without).append(box_of(run, state))
        except NotDrawn:
            continue
    boxes = with_heap or without
    return CommonAxes(type(boxes[0]).around(boxes) if boxes else None, largest_force(np.concatenate(sizes)))


def sizes_of_forces(state):
    """[M L/T^2] of the contacts of a state that carry a force."""
    size = np.abs(np.nan_to_num(state.contacts.normal_force))
    return size[size > 0.0]


def largest_force(sizes):
    """The largest but for a few; 0 of none."""
    return float(np.percentile(sizes, WIDEST_PERCENTILE)) if len(sizes) else 0.0
