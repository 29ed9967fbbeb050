# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Stresses on the base of a cone under oriented stress linearity."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.pictures.models import captions

STRESSES = (
    ("normal", "σzz", style.BLUE),
    ("shear", "σrz", style.ORANGE),
    ("radial", "σrr", style.GREEN),
    ("hoop", "σφφ", style.INK),
)


def draw(prediction):
    """Figure of the stresses along a radius, the yield margin below them."""
    figure = Figure(figsize=(4.6, 4.4))
    stresses, margin = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [3, 1]})
    at = prediction["r_over_R"]
    stresses.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
    for name, symbol, colour in STRESSES:
        hoop = name == "hoop"  # it may coincide with the radial stress
        stresses.plot(
            at,
            prediction[name],
            color=colour,
            linewidth=0.9 if hoop else 1.4,
            linestyle=(0, (4, 3)) if hoop else "-",
            label=f"{name} {symbol}",
        )
    if prediction["dip"] == 1.0:
        place, peak, depth = (prediction[name] for name in ("peak_at", "peak_normal", "dip_depth"))
        stresses.plot([0.0, place], [peak, peak], color=style.GREY, linewidth=0.6, linestyle=(0, (4, 3)), zorder=0)
        stresses.set_ylim(top=1.18 * peak)
        stresses.text(0.01, 1.02 * peak, f"dip {100.0 * depth:.3g} %", va="bottom", fontsize=7, color=style.GREY)
    for axes in (stresses, margin):
        axes.axvline(prediction["s_inner"], color=style.FAINT, linewidth=0.6, zorder=0)
    stresses.set_ylabel("stress / ρgh")
    stresses.legend(loc="upper right", ncols=2)
    margin.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
    margin.plot(at, prediction["yield_margin"], color=style.GREY, linewidth=1.2)
    lowest = prediction["yield_margin"].min()
    if lowest < 0.0:
        below = np.minimum(prediction["yield_margin"], 0.0)
        margin.fill_between(at, below, color=style.pale(style.ORANGE, 0.25), linewidth=0, zorder=0.8)
    margin.set_ylim(min(1.1 * lowest, -0.08), 1.05)
    margin.set(xlabel="r / R", ylabel="yield margin", xlim=(0.0, 1.0))
    figure.align_ylabels()
    defaults = () if prediction.model.value("model") == "custom" else ("mu", "eta")
    captions.fit_below(figure, captions.add(figure, prediction.model, leave_out=("points", *defaults)))
    return figure
