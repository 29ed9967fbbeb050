# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Mohr's circle and the lines of the Coulomb limit."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.pictures.models import captions


def draw(prediction):
    """The circle, the principal stresses, the chosen plane, and the limit |shear| = tan(phi) normal."""
    figure = Figure(figsize=(4.6, 3.9))
    axes = figure.subplots()
    friction = np.radians(float(prediction.model.value("friction_deg")))
    angle = f"{float(prediction.model.value('plane_deg')):g}".replace("-", "\N{MINUS SIGN}")
    centre, radius = prediction["centre"], prediction["radius"]
    size = max(abs(centre) + radius, 1e-300)
    left = min(0.0, centre - radius) - 0.12 * size
    right = max(0.0, centre + radius) + 0.12 * size
    normal = np.array([0.0, 10.0 * size])
    half = 1.1 * radius if radius > 0.0 else 0.3 * size
    axes.axhline(0.0, color=style.FAINT, linewidth=0.7, zorder=0)
    axes.axvline(0.0, color=style.FAINT, linewidth=0.7, zorder=0)
    limit = np.tan(friction) * normal
    axes.fill_between(normal, -limit, limit, color=style.pale(style.GREEN, 0.10), linewidth=0.0, zorder=0)
    for side in (1.0, -1.0):
        axes.plot(normal, side * limit, color=style.GREEN, linewidth=1.0,
                  label="|shear| = normal tan φ" if side > 0.0 else None)
    axes.plot(prediction["normal"], prediction["shear"], color=style.BLUE, linewidth=1.4, label="all planes")
    axes.plot(centre, 0.0, marker="+", color=style.BLUE, markersize=6)
    principal = [prediction["minor"], prediction["major"]]
    axes.plot(principal, [0.0, 0.0], marker="s", color=style.INK, markersize=4, linestyle="none",
              label="principal stresses")
    plane = prediction["plane_normal"], prediction["plane_shear"]
    axes.plot([centre, plane[0]], [0.0, plane[1]], color=style.ORANGE, linewidth=0.9)
    axes.plot(*plane, marker="o", color=style.ORANGE, markersize=5, linestyle="none", zorder=4,
              label=f"plane at {angle}°")
    axes.set_xlim(left, right)
    axes.set_ylim(-1.25 * half, 1.25 * half)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel("normal stress, compression positive")
    axes.set_ylabel("shear stress")
    state = "slips" if prediction["yields"] else "stable"
    height = captions.add(figure, prediction.model, leave_out=("points",))
    inches = figure.get_size_inches()[1]
    figure.text(0.5, 1.0 - height / inches, f"R / (P sin φ) = {prediction['coulomb_ratio']:.4g}: {state}",
                ha="center", va="top", fontsize=8)
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, ncols=2, loc="upper center", bbox_to_anchor=(0.5, 1.0 - (height + 0.2) / inches))
    captions.fit_below(figure, height + 0.55)
    return figure
