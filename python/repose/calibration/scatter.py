# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Means of the members of each point, and their errors from the scatter between seeds."""

from dataclasses import dataclass

import numpy as np

POOL_WEIGHT = 8.0  # degrees of freedom that the variance pooled over all points counts as


@dataclass(frozen=True)
class Means:
    """A target at the P points that have it; the other points are left out."""

    rows: np.ndarray  # (P) rows of the points
    mean: np.ndarray  # (P) in the unit of the measure
    error: np.ndarray  # (P) standard error of the mean, with the pooled scatter
    count: np.ndarray  # (all points) members with a value
    deviation: float  # pooled standard deviation between members


def means_of(values):
    """Means of values (points, members) with NaN where a member has none. A point with fewer than two is left out.

    The variance of a point is its own (n - 1 degrees of freedom) and the one pooled over all points (as 8), weighted by
    these degrees: three seeds alone say little. Validated by python/tests/test_calibration_parts.py."""
    there = np.isfinite(values)
    count = there.sum(axis=1)
    rows = np.flatnonzero(count >= 2)
    n = count[rows]
    held = np.where(there[rows], values[rows], 0.0)
    mean = held.sum(axis=1) / n
    squares = np.where(there[rows], (values[rows] - mean[:, None]) ** 2, 0.0).sum(axis=1)
    degrees = n - 1.0
    pooled = squares.sum() / degrees.sum() if len(rows) else 0.0
    variance = (squares + POOL_WEIGHT * pooled) / (degrees + POOL_WEIGHT)
    return Means(rows, mean, np.sqrt(variance / n), count, float(np.sqrt(pooled)))
