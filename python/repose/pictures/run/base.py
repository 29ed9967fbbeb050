# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Normal and shear force of the heap on the grains of its base."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.error_band import draw_with_error_band

SMOOTHING = 5  # grains in the running mean, as for the dip index


def draw(run, state):
    """Figure of the time window at the end of the run."""
    if state.frame:
        raise NotDrawn("it shows the end of the run, not a frame")
    if run.base is None:
        raise NotDrawn("there is no base of grains and no plane as base")
    x, normal, shear = (run.base[name] for name in ("x", "normal", "shear"))
    loaded = np.flatnonzero((normal != 0.0) | (shear != 0.0))
    if len(loaded) == 0:
        raise NotDrawn("nothing rests on the base")
    units = style.units_of(run)
    bins = run.analysis and run.analysis["base"]
    figure = Figure(figsize=(5.2, 3.6))
    upper, lower = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [2, 1]})
    for axes, name, force, colour in ((upper, "normal", normal, style.BLUE), (lower, "shear", shear, style.ORANGE)):
        axes.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
        axes.plot(x, force, "o", color=style.pale(colour, 0.6), markersize=2.6, markeredgewidth=0, label="base grain")
        if bins:
            label = f"mean over {units.length_value(bins.attributes['bin_width'])}; band: ± scatter of its grains / √n"
            draw_with_error_band(axes, bins["x"], bins[name], bins[f"{name}_error"], colour, label)
            if name == "normal":
                draw_force_range(axes, run.analysis["force_range"])
        else:
            mean = running_mean(force, SMOOTHING)
            axes.plot(x, mean, color=colour, linewidth=1.4, label=f"mean of {SMOOTHING} grains")
        axes.set_ylabel(units.force(f"{name} force"))
    lower.set_xlabel(units.length("x"))
    margin = 4.0 * run.attributes["grain_diameter"]
    lower.set_xlim(x[loaded[0]] - margin, x[loaded[-1]] + margin)
    figure.align_ylabels()
    handles, labels = upper.get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper left", bbox_to_anchor=(0.08 / 5.2, 1.0 - (0.37 if bins else 0.26) / 3.6), ncol=3)

    window = run.base.attributes
    begin, until = window["window_start"], window["window_end"]
    text = f"at t = {units.time_value(until)}"
    if begin < until:
        text = f"mean over t = {begin:.6g} to {units.time_value(until)}"
    dip = run.summary.get("base_dip")
    if dip:
        for side in (-1.0, 1.0):
            end = dip["centre"] + side * dip["half_width"]
            upper.axvline(end, ymax=0.7, color=style.GREY, linewidth=0.8, linestyle=":")
        text += f"; half width {units.length_value(dip['half_width'])} (dotted), dip index {dip['index']:.2f}"
    if bins:
        text += "\nthe band is no error of the profile, for which other heaps are needed (repose sweep)"
    style.fit(figure, (0.0, 0.0, 1.0, 0.86 if bins else 0.89))
    style.caption(figure, text)
    return figure


def draw_force_range(axes, allowed):
    """A light band of the means that equilibrium allows in each bin; it leaves the axes where there is no bound."""
    if allowed is None:
        return
    most = np.where(np.isnan(allowed["max"]), 1e6, allowed["max"])
    top = np.nanmax([axes.get_ylim()[1], 1.05 * np.nanmax(allowed["max"], initial=0.0)])
    drawing = dict(color=style.pale(style.GREY, 0.22), linewidth=0, zorder=0.5, label="equilibrium allows")
    axes.fill_between(allowed["x"], allowed["min"], most, **drawing)
    axes.set_ylim(axes.get_ylim()[0], top)


def running_mean(values, count):
    """Mean over `count` neighbours (odd), fewer at the ends; same shape as the values."""
    kernel = np.ones(count)
    reach = count // 2
    inside = slice(reach, reach + len(values))
    return np.convolve(values, kernel)[inside] / np.convolve(np.ones(len(values)), kernel)[inside]
