# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Forces as lines whose width is proportional to them."""

import numpy as np
from matplotlib.lines import Line2D

from repose import style
from repose.pictures.run.shapes import add_lines

WIDEST = 0.5  # grain diameters
LEVELS = 32  # of line width; lines below half a level are left out


def widest_line(run, panel):
    """Width [points] of the line of the largest force."""
    return WIDEST * run.attributes["grain_diameter"] * panel.points_per_length


def levels_of(size, largest):
    """Level of width (K) of forces of this size, 0 to LEVELS."""
    return np.round(LEVELS * np.minimum(size / largest, 1.0)).astype(int)


def add_forces(panel, lines, level, widest, colour):
    """Lines (K, 2, 2) [L] of forces of these levels (K)."""
    for k in range(1, LEVELS + 1):
        if (level == k).any():
            add_lines(panel, lines[level == k], widest * k / LEVELS, colour)


def handle_of_force(colour, width, name):
    return Line2D([], [], color=colour, linewidth=width, solid_capstyle="butt", label=name)


def scale_of_forces(largest, widest, steps=3):
    """Handles of a legend: lines of some round forces, and of the largest."""
    parts = _round_steps(largest)[-steps:]
    scale = [handle_of_force(style.INK, widest * part / largest, f"{part:g}") for part in parts]
    return [*scale, handle_of_force(style.INK, widest, f"≥ {largest:.3g}")]


def _round_steps(largest):
    """Three values of the sequence 1, 2, 5, 10, ... below `largest`, ascending."""
    power = np.floor(np.log10(largest))
    sequence = [step * 10.0 ** (power + k) for k in (-1, 0) for step in (1, 2, 5)]
    return [value for value in sequence if value <= 0.8 * largest][-3:]
