# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Solid fractions and coordination numbers of packings."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from repose import style
from repose.pictures.models import captions


def draw(prediction):
    """A row for each packing: solid fraction with error, and contacts per grain; discs above spheres."""
    names, dimensions = prediction["name"], prediction["dimension"]
    figure = Figure(figsize=(5.4, 0.9 + 0.175 * len(names)))
    axes = figure.subplots()
    fractions, errors, contacts = prediction["solid_fraction"], prediction["error"], prediction["coordination"]
    for row, name in enumerate(names):
        discs = dimensions[row] == 2
        colour = style.BLUE if discs else style.ORANGE
        exact = errors[row] == 0.0
        axes.axhline(row, color=style.FAINT, linewidth=0.5, zorder=0)
        if np.isfinite(fractions[row]):
            axes.errorbar(fractions[row], row, xerr=errors[row] if errors[row] > 0.0 else None, color=colour,
                          fmt="o" if discs else "s", markersize=4.5, markerfacecolor=colour if exact else "white",
                          elinewidth=0.9, capsize=2)
            axes.text(1.01, row, f"{fractions[row]:.4g}", ha="right", va="center", fontsize=7)
        if np.isfinite(contacts[row]):
            axes.text(1.07, row, f"{contacts[row]:g}", ha="center", va="center", fontsize=7)
    axes.text(1.01, -0.9, "c", ha="right", va="center", fontsize=7, color=style.GREY)
    axes.text(1.07, -0.9, "contacts", ha="center", va="center", fontsize=7, color=style.GREY)
    axes.set_yticks(range(len(names)), names)
    axes.tick_params(axis="y", length=0)
    axes.spines["left"].set_visible(False)
    axes.set_ylim(len(names) - 0.5, -1.3)
    axes.set_xlim(0.34, 1.11)
    axes.set_xticks(np.arange(0.4, 0.91, 0.1))
    axes.set_xlabel("solid fraction c", x=0.37)
    handles = [
        Line2D([], [], color=colour, marker=marker, markersize=4.5, markerfacecolor=face, linestyle="none", label=label)
        for colour, marker, face, label in (
            (style.BLUE, "o", style.BLUE, "discs, exact"),
            (style.BLUE, "o", "white", "discs, measured"),
            (style.ORANGE, "s", style.ORANGE, "spheres, exact"),
            (style.ORANGE, "s", "white", "spheres, measured"),
        )
        if ("discs" in label and 2 in dimensions) or ("spheres" in label and 3 in dimensions)
    ]
    height = captions.add(figure, prediction.model)
    inches = figure.get_size_inches()[1]
    figure.legend(handles=handles, ncols=4, loc="upper center", bbox_to_anchor=(0.5, 1.0 - height / inches))
    captions.fit_below(figure, height + 0.15)
    return figure
