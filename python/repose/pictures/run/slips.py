# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Stick and slip of a driven wall: its force against time with the slips marked, and the distribution of the drops with the
power law that was fitted."""

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from repose import style
from repose.pictures.run.analysis_parts import analysis_table


def draw(run, state):
    """Figure of the time that the analysis looked at."""
    drive = analysis_table(run, state, "drive", "its slips were not looked for (repose analyse DIR --slips)")
    slips = run.analysis["slips"]
    units = style.units_of(run)
    weight = run.attributes["grain_weight"] or 1.0  # the unit of forces; 1 where grains have none
    figure = Figure(figsize=(5.2, 4.6) if slips is not None else (5.2, 2.6))
    panels = figure.subplots(2 if slips is not None else 1, 1, squeeze=False)[:, 0]
    time, force = drive["time"], drive["force"] / weight
    panels[0].plot(time, force, color=style.BLUE, linewidth=0.7, label="force on the wall")
    panels[0].set_xlabel(units.time("t"))
    panels[0].set_ylabel(units.force("force"))
    count = 0
    if slips is not None:
        count = len(slips["drop"])
        lines = [
            np.column_stack([time[inside], force[inside]])
            for begin, end in zip(slips["begin"], slips["end"])
            for inside in [(time >= begin) & (time <= end)]
        ]
        panels[0].add_collection(LineCollection(lines, colors=style.ORANGE, linewidths=1.2, label="slip"))
        draw_drops(panels[1], slips, weight, units)
    panels[0].legend(loc="upper left", bbox_to_anchor=(0.0, 1.16), ncol=2)
    style.fit(figure, (0.0, 0.0, 1.0, 0.93))
    wall = slips.attributes["wall"] if slips is not None else ""
    verdict = f"; drops: {slips.attributes['verdict']}" if slips is not None else ""
    style.caption(figure, f"{count} slips{f' of wall {wall}' if wall else ''}{verdict}")
    return figure


def draw_drops(axes, slips, weight, units):
    """The fraction of slips with at least a drop, and the fitted law through its beginning."""
    drops = np.sort(slips["drop"]) / weight
    above = 1.0 - np.arange(len(drops)) / len(drops)
    axes.plot(drops, above, "o", color=style.BLUE, markersize=2.4, markeredgewidth=0, label="slips with at least this drop")
    x_min, exponent = slips.attributes["x_min"] / weight, slips.attributes["exponent"]
    if np.isfinite(exponent):
        x = np.geomspace(x_min, drops[-1], 50)
        begin = np.mean(drops >= x_min)
        axes.plot(x, begin * (x / x_min) ** (1.0 - exponent), color=style.ORANGE, linewidth=1.2, label=f"power law, {exponent:.2f}")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(units.force("drop"))
    axes.set_ylabel("fraction")
    axes.legend(loc="lower left", bbox_to_anchor=(0.02, 0.04))
