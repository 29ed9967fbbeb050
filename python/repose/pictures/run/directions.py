# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Polar diagram of the directions of contacts from the vertical, with the first harmonic and with all of them (Bratberg
2003, paper one, Fig. 9)."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from repose import style
from repose.pictures.run.analysis_parts import measured_packing


def draw(run, state):
    """Figure of the contacts in the slab of the last state."""
    packing = measured_packing(run, state, "directions")
    directions, harmonics = packing.parts["directions"], packing.parts["harmonics"]
    figure = Figure(figsize=(3.9, 4.1))
    axes = figure.add_subplot(projection="polar")
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    both = np.concatenate([directions["direction_deg"], directions["direction_deg"] + 180.0])
    density = np.tile(directions["density"], 2) * 180.0  # 1 where all directions are equally frequent
    error = np.tile(directions["error"], 2) * 180.0
    width = np.radians(directions.attributes["bin_width"])
    axes.bar(np.radians(both), density, width=width, color=style.GRAIN, edgecolor="white", linewidth=0.3)
    axes.errorbar(np.radians(both), density, yerr=error, fmt="none", ecolor=style.GREY, elinewidth=0.6)
    angle = np.radians(np.linspace(0.0, 360.0, 721))
    for count, colour, drawing in ((1, style.ORANGE, "--"), (len(harmonics["order"]), style.BLUE, "-")):
        series = expansion(angle, harmonics, count)
        orders = ", ".join(str(order) for order in harmonics["order"][:count])
        label = f"harmonic{'s' if count > 1 else ''} {orders}"
        axes.plot(angle, np.maximum(series, 0.0), color=colour, linewidth=1.1, linestyle=drawing, label=label)
    axes.set_ylim(0.0, 1.05 * max(density.max(), 1.0))
    axes.set_thetagrids(range(0, 360, 30), [f"{k if k <= 180 else k - 360}°" for k in range(0, 360, 30)])
    axes.set_rlabel_position(75.0)
    axes.yaxis.set_major_locator(MaxNLocator(4, prune="lower"))
    axes.grid(color=style.FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    figure.legend(loc="lower center", ncol=2)
    style.fit(figure, (0.0, 0.06, 1.0, 0.95))
    style.caption(figure, f"π p(θ) of {directions['count'].sum()} contacts in the slab, θ from the vertical; bars: √(count)")
    return figure


def expansion(angle, harmonics, count):
    """pi p(theta) at angles [rad], summed over the first `count` harmonics."""
    terms = list(zip(harmonics["order"], harmonics["cosine"], harmonics["sine"]))[:count]
    return 1.0 + sum(a * np.cos(m * angle) + b * np.sin(m * angle) for m, a, b in terms)
