# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Stress ratio of a confined elastic column."""

import numpy as np
from matplotlib.figure import Figure

from repose import style, theory
from repose.pictures.models import captions


def draw(prediction):
    """The curve over all Poisson ratios, with the chosen one."""
    figure = Figure(figsize=(4.2, 3.0))
    axes = figure.subplots()
    ratios = np.linspace(-0.99, 0.5, 150)
    curve = [theory.predict(prediction.model.name, poisson_ratio=ratio)["stress_ratio"][0] for ratio in ratios]
    axes.axhspan(-0.5, 0.0, color=style.pale(style.FAINT, 0.35), linewidth=0.0, zorder=0)
    axes.text(-0.96, -0.04, "walls would have to pull", va="top", ha="left", fontsize=7, color=style.GREY)
    axes.plot(ratios, curve, color=style.BLUE, linewidth=1.4)
    chosen = prediction["poisson_ratio"][0], prediction["stress_ratio"][0]
    axes.plot(*chosen, "o", color=style.ORANGE, markersize=5)
    axes.annotate(f"K = {chosen[1]:.4g}", chosen, xytext=(-6, 4), textcoords="offset points", ha="right",
                  color=style.ORANGE)
    axes.set_xlim(-1.0, 0.52)
    axes.set_ylim(-0.5, 1.04)
    axes.set_xlabel("Poisson ratio ν")
    axes.set_ylabel("horizontal over vertical stress K")
    captions.fit_below(figure, captions.add(figure, prediction.model))
    return figure
