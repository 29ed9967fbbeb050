# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Directions of the contacts of spheres from the vertical: all that count, and those above the mean force."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.pictures.run.analysis_parts import NO_FORCES, analysis_table

KINDS = (("direction_all", style.BLUE, "all that count"), ("direction_strong", style.ORANGE, "above the mean force"))


def draw(run, state):
    """Figure of the last state. Equal intervals of the cosine are equal solid angles: isotropic directions have the density 1."""
    forces = analysis_table(run, state, "forces", NO_FORCES)
    cosine = forces["direction_cosine"]
    half = 0.5 * (cosine[1] - cosine[0])
    edges = np.append(cosine - half, cosine[-1] + half)
    figure = Figure(figsize=(4.2, 2.8))
    axes = figure.subplots()
    axes.axhline(1.0, color=style.GREY, linewidth=0.6, linestyle="--", zorder=0.5)
    for name, colour, label in KINDS:
        axes.stairs(forces[name], edges, baseline=None, color=colour, linewidth=1.1, label=label)
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(bottom=0.0)
    axes.set(xlabel="|cos θ|, θ from the vertical", ylabel="probability density")
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.02), ncols=2, title="contacts", alignment="left", title_fontsize=7)
    style.fit(figure)
    return figure
