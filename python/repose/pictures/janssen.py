# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Janssen's law of a column between two walls or in a cylinder, without the compiled part of the package.

The same as `repose theory janssen`; here friction may also be 0, or negative: walls that push down.
"""

from dataclasses import dataclass

import numpy as np

from repose import style

STRESS, PRESSURE = style.BLUE, style.PURPLE  # colours of vertical stress and wall pressure, measured and by the law


@dataclass(frozen=True)
class Janssen:
    """A column with stress_ratio = wall pressure / vertical stress."""

    width: float  # [L]
    height: float  # [L]
    weight: float  # [M L/T^2]; of a cylinder per length
    stress_ratio: float
    friction: float  # upward force of the walls on the grains over the normal force

    @classmethod
    def in_cylinder(cls, radius, height, weight, stress_ratio, friction):
        """The law in a cylinder of radius R: s' = weight/(pi R^2 height) - 2 stress_ratio friction s/R. It is the law
        between two walls of width R that carry weight/(pi R) per length."""
        return cls(radius, height, weight / (np.pi * radius), stress_ratio, friction)

    def stress(self, depth):
        """Vertical stress [M/T^2], in a cylinder [M/(L T^2)], at a depth [L] below the surface (n): the solution of
        s' = weight/(width height) - s/L from 0, with the screening length L = width/(2 stress_ratio friction)."""
        rate = 2.0 * self.stress_ratio * self.friction / self.width
        without = self.weight / (self.width * self.height)
        return without * (depth if rate == 0.0 else -np.expm1(-rate * depth) / rate)

    def pressure(self, depth):
        """Pressure on the walls (n), in the same unit."""
        return self.stress_ratio * self.stress(depth)

    @property
    def known(self):
        """Whether all its numbers are, and the column has a weight."""
        numbers = [self.width, self.height, self.weight, self.stress_ratio, self.friction]
        return bool(np.isfinite(numbers).all()) and self.weight > 0.0
