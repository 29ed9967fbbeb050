# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Models of theory over the mean base profiles of the points of a sweep."""

from repose import style
from repose.errors import NotDrawn
from repose.pictures.theory_overlay import NO_MODEL, Comparison, draw_comparisons

SIDE_BY_SIDE = 2  # points in a figure


def draw(sweep):
    """A figure for every two points that have a comparison with theory."""
    entries = sweep.summary.get("theory")
    if not entries:
        raise NotDrawn(NO_MODEL)
    drawn = []
    for name, profile in zip(sweep.points, sweep.profiles):
        own = [entry for entry in entries if entry["point"] == name]
        if own and profile is not None:
            drawn.append(Comparison(name, profile, profile.binned, own))
    text = "means over the members of a point, with the standard errors between them"
    parts = [drawn[start : start + SIDE_BY_SIDE] for start in range(0, len(drawn), SIDE_BY_SIDE)]
    return [draw_comparisons(part, style.units_of(sweep), text) for part in parts]
