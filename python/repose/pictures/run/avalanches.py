# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Motion of a heap: grains that moved per interval, avalanches, angles of the surface, depth of the moving layer."""

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from repose import style
from repose.errors import NotDrawn

FLANKS = (("left", style.ORANGE), ("right", style.PURPLE))


def draw(run, state):
    """Figure of the whole run."""
    if state.frame:
        raise NotDrawn("it shows the whole run, not a frame")
    if run.analysis is None:
        raise NotDrawn("the last state has no analysis.h5 (repose analyse DIR writes it)")
    motion, avalanches = run.analysis["motion"], run.analysis["avalanches"]
    if motion is None or len(motion["end"]) == 0:
        raise NotDrawn("the run recorded no track (output.track = 0)")
    units = style.units_of(run)
    figure = Figure(figsize=(6.3, 4.6))
    rows = figure.subplots(3, 1, sharex=True, gridspec_kw={"height_ratios": [1.5, 1, 1]})
    _moved(rows[0], motion, avalanches)
    _angles(rows[1], motion)
    middle = 0.5 * (motion["start"] + motion["end"])
    rows[2].plot(middle, motion["depth"], "o", color=style.BLUE, markersize=2, markeredgewidth=0)
    rows[2].set_ylim(bottom=min(0.0, np.nanmin(motion["depth"], initial=0.0)))
    rows[2].set_ylabel(units.length("depth of the\nmoving layer"))
    rows[2].set_xlabel(units.time("t"))
    rows[2].set_xlim(motion["start"][0], motion["end"][-1])
    figure.align_ylabels(rows)
    style.fit(figure, (0.0, 0.0, 1.0, 0.95))
    style.caption(figure, _sizes(avalanches, units))
    return figure


def _moved(axes, motion, avalanches):
    edges = np.append(motion["start"], motion["end"][-1])
    axes.stairs(motion["moved"], edges, color=style.BLUE, fill=True, label="moved in one interval")
    axes.set_ylim(0.0, 1.08 * max(1, motion["moved"].max(), *(avalanches["size"] if avalanches else ())))
    axes.yaxis.set_major_locator(MaxNLocator(5, integer=True))
    axes.set_ylabel("grains that moved")
    if avalanches and len(avalanches["size"]):
        size = avalanches["size"]
        spans = [[(start, n), (end, n)] for start, end, n in zip(avalanches["start"], avalanches["end"], size)]
        middle = 0.5 * (avalanches["start"] + avalanches["end"])
        axes.add_collection(LineCollection(spans, colors=style.ORANGE, linewidths=1.6), autolim=False)
        axes.plot(middle, size, "o", color=style.ORANGE, markersize=2.6)
        name = "avalanche, start to end: grains that moved in it"
        axes.plot([], [], "o-", color=style.ORANGE, markersize=2.6, label=name)
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=2)


def _angles(axes, motion):
    shown = [(f"angle_{side}", f"{side} flank", colour) for side, colour in FLANKS]
    shown = [each for each in shown if each[0] in motion] or [("angle", "cone", style.ORANGE)]
    for name, label, colour in shown:
        axes.plot(motion["end"], motion[name], color=colour, linewidth=0.8, label=label)
    axes.set_ylabel("surface angle\n(deg)")
    angles = np.array([motion[name] for name, _, _ in shown])
    angles = angles[np.isfinite(angles)]
    if len(angles):
        low, high = min(0.0, angles.min()), max(1.0, angles.max())
        axes.set_ylim(low - 0.3 * (high - low), high + 0.05 * (high - low))  # space for the legend
        axes.legend(loc="lower right", ncol=2)


def _sizes(avalanches, units):
    if avalanches is None:
        return ""
    least, interval = avalanches.attributes["least"], units.time_value(avalanches.attributes["interval"])
    count = len(avalanches["size"])
    text = f"{count or 'no'} {'avalanche' if count == 1 else 'avalanches'} of {least} grains or more in {interval}"
    return text + (f", the largest of {avalanches['size'].max()} grains" if count else "")
