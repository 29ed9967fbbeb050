# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Models of theory over the mean base profiles of the points of a sweep."""

from repose import style
from repose.not_drawn import NotDrawn
from repose.pictures.laid_on import NONE, Measured, figure_of

SIDE_BY_SIDE = 2  # points in a figure


def draw(sweep):
    """A figure for every two points that theory was laid on."""
    entries = sweep.summary.get("theory")
    if not entries:
        raise NotDrawn(NONE)
    drawn = []
    for name, profile in zip(sweep.points, sweep.profiles):
        own = [entry for entry in entries if entry["point"] == name]
        if own and profile is not None:
            drawn.append(Measured(name, profile, profile.binned, own))
    text = "means of ensembles; errors between their members"
    parts = [drawn[start : start + SIDE_BY_SIDE] for start in range(0, len(drawn), SIDE_BY_SIDE)]
    return [figure_of(part, style.units_of(sweep), text) for part in parts]
