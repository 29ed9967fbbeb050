# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pair correlation and structure factor of a packing of spheres."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import analysis_table

NO_PACKING = "no packing was measured (analysis.packing)"


def draw(run, state):
    """Figure of the last state."""
    pairs = analysis_table(run, state, "pair_correlation", NO_PACKING)
    factor = run.analysis["structure_factor"]
    if len(pairs["r"]) == 0:
        raise NotDrawn(NO_PACKING)
    units = style.units_of(run)
    curves = [(pairs["r"], pairs["g"], pairs["error"], units.length("r"), "g(r)")]
    if factor is not None and len(factor["q"]):
        curves.append((factor["q"], factor["s"], factor["error"], "q σ" if units.reduced else "q (1/m)", "S(q)"))
    figure = Figure(figsize=(5.2, 0.3 + 2.0 * len(curves)))
    rows = figure.subplots(len(curves), 1, squeeze=False)[:, 0]
    for axes, (place, value, error, place_label, label) in zip(rows, curves):
        half = np.nan_to_num(error)
        axes.axhline(1.0, color=style.GREY, linewidth=0.6, linestyle="--", zorder=0.5)
        axes.fill_between(place, value - half, value + half, color=style.pale(style.SKY, 0.4), linewidth=0, zorder=0.8)
        axes.plot(place, value, color=style.BLUE, linewidth=0.9)
        axes.set_xlim(0.0, place.max())
        axes.set_ylim(bottom=0.0)
        axes.set(xlabel=place_label, ylabel=label)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - 0.2 / figure.get_figheight()), h_pad=0.6)
    style.caption(figure, "spheres in the slab; bands: ± standard error")
    return figure
