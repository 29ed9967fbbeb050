# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a calibration file says: parameters with ranges and priors, targets with errors, the design of the points."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from scipy.special import ndtr, ndtri

UNIFORM = "uniform"
LOG_UNIFORM = "log-uniform"
NORMAL = "normal"


@dataclass(frozen=True)
class Parameter:
    """A key of the scene with its range and prior. Values have the unit of the key; `scaled` is 0 to 1 over the range,
    in the logarithm where the prior is log-uniform.

    Validated by python/tests/test_calibration_parts.py."""

    key: str
    low: float
    high: float
    prior: str = UNIFORM
    mean: float = 0.0  # of a normal prior, before the cut at the range
    deviation: float = 1.0

    def value(self, probability):
        """Values (n) below which the prior has these probabilities (n)."""
        probability = np.asarray(probability, dtype=float)
        if self.prior == NORMAL:
            below, above = ndtr((np.array([self.low, self.high]) - self.mean) / self.deviation)
            found = self.mean + self.deviation * ndtri(below + probability * (above - below))
            return np.clip(found, self.low, self.high)
        return self.from_scaled(probability)

    def scaled(self, value):
        """Places (n) in the range, from 0 to 1, of values (n)."""
        value = np.asarray(value, dtype=float)
        if self.prior == LOG_UNIFORM:
            return np.log(value / self.low) / np.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)

    def from_scaled(self, place):
        """Values (n) at places (n) in the range."""
        place = np.asarray(place, dtype=float)
        if self.prior == LOG_UNIFORM:
            return np.clip(self.low * (self.high / self.low) ** place, self.low, self.high)
        return np.clip(self.low + place * (self.high - self.low), self.low, self.high)

    def density(self, place):
        """The prior density at places (n), per unit of the place in the range."""
        place = np.asarray(place, dtype=float)
        if self.prior != NORMAL:
            return np.ones_like(place)
        below, above = ndtr((np.array([self.low, self.high]) - self.mean) / self.deviation)
        z = (self.from_scaled(place) - self.mean) / self.deviation
        width = (self.high - self.low) / self.deviation
        return width * np.exp(-0.5 * z**2) / np.sqrt(2.0 * np.pi) / (above - below)


@dataclass(frozen=True)
class Target:
    """A measured number: column of a sweep's table, value and standard error, both in the unit of the measure."""

    measure: str
    value: float
    error: float


@dataclass(frozen=True)
class Design:
    """How points are chosen, and when there are enough."""

    start: int = 16  # first points
    sequence: str = "sobol"
    batch: int = 4  # points of a later round
    most: int = 60  # points in all
    stop: float = 0.3  # deviation of the surrogate over the error of a target
    seed: int = 1  # of all random numbers of the calibration


@dataclass(frozen=True)
class Plan:
    """A calibration: d parameters, T targets."""

    parameters: "list[Parameter]"
    targets: "list[Target]"
    design: Design = field(default_factory=Design)
    seeds: int = 3  # members of a point
    title: str = ""
    path: str = ""  # of the file, as the user names it
    text: str = ""  # of the file
    scene: Path = Path()
    settings: str = ""  # the table [set] of the file, as written

    def values(self, probabilities):
        """Values (n, d) at probabilities (n, d) of the prior."""
        return np.column_stack([p.value(probabilities[:, k]) for k, p in enumerate(self.parameters)])

    def scaled(self, values):
        """Places (n, d) in the ranges of values (n, d)."""
        return np.column_stack([p.scaled(values[:, k]) for k, p in enumerate(self.parameters)])
