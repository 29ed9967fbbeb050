# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The floor of a column between two upright walls or in an upright cylinder, chosen as the analysis does."""

import numpy as np

from repose.pictures.run.shapes import wall_places

ROUNDING = 1e-9  # of a normal


def floor_wall(run):
    """The number of the wall that is the floor: the lowest level wall at the start, or of spheres the one that the
    analysis names; None where base grains are the floor."""
    if run.walls is None:
        return None
    if run.attributes["dimension"] == 3:
        column = run.analysis and run.analysis["column"]
        number = column.attributes.get("floor_wall", -1) if column else -1
        return None if number < 0 else number
    up = np.where(np.isfinite(run.walls["half_length"]), np.abs(run.walls["normal"][:, 1]), run.walls["normal"][:, 1])
    level = np.flatnonzero(up > 1.0 - ROUNDING)
    return level[np.argmin(run.walls["point"][level, 1])] if len(level) else None


def floor_height(run, state):
    """y [L] of the floor at the time of the state; base grains count as one at 0."""
    wall = floor_wall(run)
    return 0.0 if wall is None else wall_places(run, state)[0][wall, 1]
