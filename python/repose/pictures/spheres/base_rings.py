# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pressure and shear of a conical heap on its base by rings, beside the hydrostatic pressure of the same load."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import analysis_table

NO_RINGS = "the pressure on the base was not measured by rings"
# Smid and Novosad (1981) found the pressure under the apex of cones of sand and fertilizer at 32.6 degrees to be 20 %
# (small piles) to 30 % (the largest) below its largest value, as Liffman, Chan and Hughes (1992) report.
MEASURED_DIP = (0.2, 0.3)
DIP_LABEL = """20 to 30 % below the largest: centre of cones of sand and fertilizer
(Smid and Novosad 1981, after Liffman et al. 1992)"""


def draw(run, state):
    """Figure of the time window at the end of the run."""
    rings = analysis_table(run, state, "base_rings", NO_RINGS)
    if len(rings["r"]) == 0 or not np.nanmax(rings["pressure"], initial=0.0) > 0.0:
        raise NotDrawn("nothing rests on the base")
    units = style.units_of(run)
    figure = Figure(figsize=(5.2, 4.1))
    upper, lower = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [2, 1]})
    for axes, name, colour in ((upper, "pressure", style.BLUE), (lower, "shear", style.ORANGE)):
        axes.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
        error = np.nan_to_num(rings[f"{name}_error"])
        drawing = dict(fmt="o-", color=colour, markersize=3, linewidth=0.8, elinewidth=0.9, capsize=1.8)
        axes.errorbar(rings["r"], rings[name], error, label="mean over a ring", **drawing)
        axes.set_ylabel(units.stress({"pressure": "pressure", "shear": "outward\nshear"}[name]))
    _add_hydrostatic(upper, run, rings)
    _add_measured_dip(upper, rings)
    upper.set_ylim(bottom=0.0)
    lower.set_xlim(0.0, rings["outer"].max())
    lower.set_xlabel(units.length("r"))
    figure.align_ylabels()
    handles, labels = upper.get_legend_handles_labels()
    handles, labels = handles[-1:] + handles[:-1], labels[-1:] + labels[:-1]  # bars come last, but matter most
    width, height = figure.get_size_inches()
    rows = sum(1 + label.count("\n") for label in labels)
    figure.legend(handles, labels, loc="upper left", bbox_to_anchor=(0.08 / width, 1.0 - 0.26 / height), ncol=1)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - (0.34 + 0.15 * rows) / height))
    style.caption(figure, _caption(run))
    return figure


def hydrostatic(rings, surface):
    """Pressure [M/(L T^2)] in each ring of a heap with this mean surface that has the load of all rings and presses on its base
    by its height alone: the sum of pressure times area is that load. None without a height."""
    height = np.interp(rings["r"], surface["r"], np.nan_to_num(surface["height"]), right=0.0)
    area = np.pi * (rings["outer"] ** 2 - rings["inner"] ** 2)
    volume = np.sum(height * area)
    return rings["load"][-1] / volume * height if volume > 0.0 else None


def _add_hydrostatic(axes, run, rings):
    surface = run.analysis["cone_surface"]
    pressure = hydrostatic(rings, surface) if surface and len(surface["r"]) else None
    if pressure is not None:
        label = "ρgh below the mean surface, ρ from the load of the base"
        axes.plot(rings["r"], pressure, color=style.GREY, linewidth=1.0, linestyle="--", label=label)


def _add_measured_dip(axes, rings):
    """The range of the central pressure that the experiment would have under the largest one here, up to its place."""
    peak = int(np.nanargmax(rings["pressure"]))
    if peak == 0:
        return
    largest = rings["pressure"][peak]
    low, high = ((1.0 - depth) * largest for depth in MEASURED_DIP[::-1])
    drawing = dict(color=style.pale(style.GREEN, 0.3), linewidth=0, zorder=0.4, label=DIP_LABEL)
    axes.fill_between([0.0, rings["r"][peak]], low, high, **drawing)


def _caption(run):
    window = run.base.attributes if run.base is not None else {}
    begin, until = window.get("window_start", run.state.time), window.get("window_end", run.state.time)
    units = style.units_of(run)
    text = f"mean over t = {begin:.6g} to {units.time_value(until)}" if begin < until else f"at t = {units.time_value(until)}"
    dip = run.summary.get("base_dip") or {}
    if dip.get("index") is not None:
        error = dip.get("index_error")
        text += f"; dip index {dip['index']:.2f}" + (f" ± {error:.2f}" if error is not None else "")
    return text + "; bars: ± scatter of sectors / √n"
