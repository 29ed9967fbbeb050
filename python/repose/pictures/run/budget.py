# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Energy budget of a run: input, stored and dissipated energy, and the error of their sum."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn

STORED = ("gravitational", "kinetic", "elastic")
SPENT = ("damping", "friction", "walls", "drag", "lost")
LABELS = {"walls": "at walls", "drag": "global damping", "lost": "lost grains"}


def draw(run, state):
    """Figure of the budget over the whole run, in units of the largest input."""
    if state.frame:
        raise NotDrawn("it shows the whole run, not a frame")
    if run.energy is None or len(run.energy["time"]) < 2:
        raise NotDrawn("the run kept no energy budget (output.energy)")
    budget, time = run.energy, run.energy["time"]
    added = budget["sources"] + budget["walls_work"] + budget["loads_work"]
    scale = np.abs(added).max()
    if not scale > 0.0:
        raise NotDrawn("no energy was added")
    figure = Figure(figsize=(5.2, 3.8))
    top, bottom = figure.subplots(2, 1, sharex=True, height_ratios=(3, 1))
    top.plot(time, added / scale, color=style.INK, linewidth=1.2, linestyle="--", label="input")
    for colour, name in zip(style.SERIES, STORED):
        top.plot(time, budget[name] / scale, color=colour, label=name)
    for colour, name in zip((*style.SERIES[len(STORED) :], style.GREY, style.BROWN), SPENT):
        if np.abs(budget[name]).max() > 0.0:
            top.plot(time, budget[name] / scale, color=colour, linestyle="-.", label=LABELS.get(name, name))
    units = style.units_of(run)
    top.set_ylabel(f"energy / ({units.energy_value(scale)})")
    top.legend(loc="lower left", bbox_to_anchor=(0.0, 1.02), ncols=4)
    bottom.plot(time, budget["error"] / scale, color=style.ORANGE, linewidth=0.7)
    bottom.set_ylabel("error")
    bottom.set_xlabel(units.time("t"))
    figure.align_ylabels([top, bottom])
    style.fit(figure)
    return figure
