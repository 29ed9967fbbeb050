# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pair correlation, density-density correlations along the axes, and the structure factor of a packing."""

from matplotlib.figure import Figure

from repose import style
from repose.pictures.run.analysis_parts import measured_packing

PANELS = (("radial", "g(r)", "r"), ("along_x", "g along x", "x"), ("along_y", "g along y", "y"))


def draw(run, state):
    """Figure of the slab of the last state: a panel for each measure that the analysis has."""
    parts = measured_packing(run, state, "radial", "structure_factor").parts
    units = style.units_of(run)
    panels = [(parts[name], label, units.length(symbol)) for name, label, symbol in PANELS if name in parts]
    figure = Figure(figsize=(5.4, 1.5 * (len(panels) + ("structure_factor" in parts)) + 0.2))
    grid = figure.subplots(len(panels) + ("structure_factor" in parts), 1, squeeze=False)[:, 0]
    for axes, (table, label, place) in zip(grid, panels):
        _curve(axes, table["distance"], table["value"], table["error"])
        axes.set(xlabel=place, ylabel=label)
    if "structure_factor" in parts:
        table = parts["structure_factor"]
        _curve(grid[-1], table["wave_number"], table["value"], table["error"])
        grid[-1].set(xlabel="q σ" if units.reduced else "q (1/m)", ylabel="S(q)")
    for axes in grid:
        axes.axhline(1.0, color=style.GREY, linewidth=0.6, linestyle="--", zorder=0.5)
        axes.set_xlim(left=0.0)
        axes.set_ylim(bottom=0.0)
    style.fit(figure, (0.0, 0.0, 1.0, 0.97), h_pad=0.6)
    style.caption(figure, "grains in the slab; bands: ± value / √(pairs counted)")
    return figure


def _curve(axes, place, value, error):
    axes.fill_between(place, value - error, value + error, color=style.pale(style.SKY, 0.4), linewidth=0, zorder=0.8)
    axes.plot(place, value, color=style.BLUE, linewidth=0.9)
