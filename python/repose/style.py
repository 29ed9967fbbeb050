# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""One look for all pictures: restrained, colour-blind safe (Okabe and Ito), vector friendly."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

BLACK = "#000000"
GREY = "#8c8c8c"
PALE = "#dfe3e8"
BLUE = "#0072b2"
ORANGE = "#d55e00"
GREEN = "#009e73"

# Beyond this many objects a vector file becomes slow to open: they are drawn as pixels inside it.
MOST_VECTORS = 20000

WIDTH = 7.2  # inches: two columns of a journal

plt.rcParams.update(
    {
        "font.size": 9,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.linewidth": 0.8,
        "legend.frameon": False,
        "legend.fontsize": 8,
        "svg.fonttype": "none",
        "svg.hashsalt": "repose",
        "figure.constrained_layout.use": True,
        "savefig.bbox": "standard",
    }
)


def heap_window(run, state):
    """x and y limits (x0, x1, y0, y1) around the grains that are part of the heap and the base below them [L]."""
    touching = np.zeros(len(state.id), dtype=bool)
    if len(state.pairs):
        touching[state.places(state.pairs[:, 0])] = True
        second = state.pairs[:, 1]
        touching[state.places(second[second >= 0])] = True
    shown = touching & ~state.fixed
    if not shown.any():
        shown = np.ones(len(state.id), dtype=bool)
    if not shown.any():
        return (-1.0, 1.0, -1.0, 1.0)
    diameter = float(run.attribute("grain_diameter"))
    low = (state.position[shown] - state.radius[shown, None]).min(axis=0)
    high = (state.position[shown] + state.radius[shown, None]).max(axis=0)
    floor = low[1]
    if state.fixed.any():
        floor = min(floor, (state.position[:, 1] - state.radius)[state.fixed].min())
    margin = 2.0 * diameter
    return (low[0] - margin, high[0] + margin, floor - 0.5 * diameter, high[1] + margin)


def heap_axes(run, window, extra_height=0.0):
    """A figure with equal scales that the window fills."""
    x0, x1, y0, y1 = window
    height = WIDTH * (y1 - y0) / (x1 - x0)
    figure, axes = plt.subplots(figsize=(WIDTH, min(max(height, 1.2), 9.0) + 0.75 + extra_height))
    axes.set_aspect("equal")
    axes.set_xlim(x0, x1)
    axes.set_ylim(y0, y1)
    axes.set_xlabel(run.length_label("x"))
    axes.set_ylabel(run.length_label("y"))
    return figure, axes


def inside(state, window, margin):
    """Which grains lie in the window [L]."""
    x, y = state.position[:, 0], state.position[:, 1]
    x0, x1, y0, y1 = window
    return (x > x0 - margin) & (x < x1 + margin) & (y > y0 - margin) & (y < y1 + margin)


def time_text(run, state):
    grains = int((~state.fixed).sum())
    unit = "" if run.attribute("units") == "reduced" else " s"
    return f"{grains} grains, t = {state.time:.6g}{unit}"
