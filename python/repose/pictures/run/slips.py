# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Stick and slip of a driven wall: its force against time with the slips marked, the distribution of the drops with the
power law that was fitted, and by how much a column grows in slips and shrinks between them."""

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from repose import style
from repose.pictures.run.analysis_parts import analysis_table

MOST_ROWS = 20000  # of the force in a line; of more the least and the largest of every few are drawn
MOST_SHAPES = 2000  # slips; more are pixels in vector files


def draw(run, state):
    """Figure of the time that the analysis looked at."""
    drive = analysis_table(run, state, "drive", "its slips were not looked for (repose analyse DIR --slips)")
    slips = run.analysis["slips"]
    units = style.units_of(run)
    weight = run.attributes["grain_weight"] or 1.0  # the unit of forces; 1 where grains have none
    with_volume = slips is not None and np.isfinite(slips.get("dilation", np.nan)).any()
    figure = Figure(figsize=(6.3 if with_volume else 5.2, 4.6 if slips is not None else 2.6))
    layout = [["force", "force"], ["drops", "volume"]] if with_volume else [["force"], ["drops"]]
    panels = figure.subplot_mosaic(layout if slips is not None else layout[:1])
    text = draw_force(panels["force"], drive, slips, weight, units)
    if slips is not None:
        draw_drops(panels["drops"], slips, weight, units)
        text = f"{len(slips['drop'])} slips of wall {slips.attributes['wall']}; drops: {slips.attributes['verdict']}{text}"
    else:
        text = f"0 slips{text}"
    if with_volume:
        draw_volume(panels["volume"], slips, weight, units)
    panels["force"].legend(loc="upper left", bbox_to_anchor=(0.0, 1.16), ncol=2)
    style.fit(figure, (0.0, 0.0, 1.0, 0.93))
    style.caption(figure, text)
    return figure


def draw_force(axes, drive, slips, weight, units):
    """The force on the wall and the slips in it; a remark for the caption, "" where every row is drawn."""
    time, force = drive["time"], drive["force"] / weight
    shown_time, shown_force, every = thinned(time, force, MOST_ROWS)
    axes.plot(shown_time, shown_force, color=style.BLUE, linewidth=0.7, label="force on the wall")
    axes.set_xlabel(units.time("t"))
    axes.set_ylabel(units.force("force"))
    if slips is not None:
        many = every > 1 or len(slips["drop"]) > MOST_SHAPES
        lines = _chords(slips, weight) if many else _parts(time, force, slips)
        drawing = dict(colors=style.ORANGE, linewidths=1.2, label="slip", rasterized=many)
        axes.add_collection(LineCollection(lines, **drawing))
    return f"\nof every {every} rows of the force the least and the largest" if every > 1 else ""


def thinned(x, y, most):
    """(x, y, rows) with the least and the largest y of every `rows` rows, in their order: at most about `most` in all.
    Unchanged, and rows = 1, where there are no more."""
    rows = -(-2 * len(y) // most)
    if len(y) <= most:
        return x, y, 1
    starts = np.arange(0, len(y), rows)
    pairs = [np.sort([start + np.argmin(part), start + np.argmax(part)]) for start in starts for part in [y[start : start + rows]]]
    chosen = np.concatenate(pairs)
    return x[chosen], y[chosen], rows


def _parts(time, force, slips):
    """The line of the force within each slip."""
    begin = np.searchsorted(time, slips["begin"], side="left")
    end = np.searchsorted(time, slips["end"], side="right")
    return [np.column_stack([time[a:b], force[a:b]]) for a, b in zip(begin, end)]


def _chords(slips, weight):
    """A straight line from begin to end of each slip."""
    ends = [(slips["begin"], slips["force"]), (slips["end"], slips["force"] - slips["drop"])]
    return np.stack([np.column_stack([time, force / weight]) for time, force in ends], axis=1)


def draw_drops(axes, slips, weight, units):
    """The fraction of slips with at least a drop, and the fitted law through its beginning."""
    drops = np.sort(slips["drop"]) / weight
    above = 1.0 - np.arange(len(drops)) / len(drops)
    _dots(axes, drops, above, style.BLUE, "slips with at least this drop")
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


def draw_volume(axes, slips, weight, units):
    """The growth of the column in each slip, and its shrinkage since the slip before, over the drop."""
    drops = slips["drop"] / weight
    axes.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
    _dots(axes, drops, slips["compaction"], style.AMBER, "shrinks since the slip before")
    _dots(axes, drops, slips["dilation"], style.BLUE, "grows in the slip")
    axes.set_xscale("log")
    axes.set_xlabel(units.force("drop"))
    axes.set_ylabel("relative change of volume")
    axes.ticklabel_format(axis="y", style="sci", scilimits=(-2, 3))
    axes.yaxis.get_offset_text().set(ha="right", fontsize=7)
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0))


def _dots(axes, x, y, colour, label):
    drawing = dict(markersize=2.4, markeredgewidth=0, rasterized=len(x) > MOST_SHAPES)
    axes.plot(x, y, "o", color=colour, label=label, **drawing)
