# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""A measure of a sweep by its points, with the values of its members."""

import numpy as np

from repose.not_drawn import NotDrawn
from repose.pictures.sweep.axis import draw_measure

CAPTION = "mean ± standard error of the members of a point (faint: each of them)"


def has(sweep, key):
    """Whether some point has a mean of the measure."""
    return key in sweep.measures and bool(np.isfinite(sweep.measures[key]["mean"]).any())


def draw_measured(axes, axis, sweep, key):
    """Means, standard errors and the values of all members; NotDrawn if no point has the measure."""
    if not has(sweep, key):
        raise NotDrawn(f"no member has {key}")
    measure = sweep.measures[key]
    draw_measure(axes, axis, measure["mean"], measure["error"], sweep.members["point"], sweep.values.get(key))
