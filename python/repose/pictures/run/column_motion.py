# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""How a column between two walls, or in a cylinder, follows its moving floor: surface, length, front of the motion, and
load of the floor."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.pictures.run.analysis_parts import analysis_table
from repose.pictures.run.pipe import floor_wall

NO_MOTION = "there is no column between two upright walls whose floor moves"
ROUNDING = 1e-9  # of a time


def draw(run, state):
    """Figure from when the floor sets out."""
    motion = analysis_table(run, state, "column_motion", NO_MOTION)
    units, load = style.units_of(run), _load(run, motion)
    panels = [
        (units.length("displacement\nupwards"), (("floor", style.GREY), ("top", style.BLUE))),
        (units.length("shortening"), (("shortening", style.BLUE),)),
        (units.length("front"), (("front", style.BLUE),)),
    ]
    figure = Figure(figsize=(5.2, 0.7 + 1.15 * (len(panels) + (load is not None))))
    rows = figure.subplots(len(panels) + (load is not None), 1, sharex=True)
    for axes, (label, lines) in zip(rows, panels):
        for name, colour in lines:
            axes.plot(motion["time"], motion[name], color=colour, label="surface" if name == "top" else name)
        axes.set_ylabel(label)
    rows[0].legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=2)
    rows[1].axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
    rows[2].set_ylim(bottom=0.0)
    if load is not None:
        rows[3].plot(motion["time"], load, color=style.BLUE, linewidth=0.8)
        rows[3].set_ylim(bottom=min(0.0, np.nanmin(load)))
        rows[3].set_ylabel(units.force("load of the floor"))
    for axes in rows:
        axes.locator_params(axis="y", nbins=5)
    rows[-1].set_xlabel(units.time("t"))
    rows[-1].set_xlim(motion["time"][0], motion["time"][-1])
    figure.align_ylabels(rows)
    lines = ["front: height up to which all slices have moved at least half as far as the floor"]
    lines += _mark_top(run, rows, motion, units)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - 0.38 / figure.get_figheight()))
    style.caption(figure, "\n".join(lines))
    return figure


def _load(run, motion):
    """Downward force of the grains on the floor [grain weights] at the rows of the motion; None where no wall is it."""
    vertical = "z" if run.attributes["dimension"] == 3 else "y"
    wall, force = floor_wall(run), run.series.get(f"wall_force_{vertical}")
    if wall is None or force is None:
        return None
    row = np.searchsorted(run.series["time"], motion["time"] * (1.0 - ROUNDING))
    return -force[row, wall] / (run.attributes["grain_weight"] or 1.0) if row[-1] < len(force) else None


def _mark_top(run, rows, motion, units):
    """A dotted line where the front reaches the top, and a line of the caption that explains it."""
    follows = (run.summary.get("column") or {}).get("top_follows")
    if follows is None:
        return []
    time = motion["time"][np.argmin(np.abs(np.abs(motion["floor"]) - abs(follows)))]
    for axes in rows:
        axes.axvline(time, color=style.GREY, linewidth=0.8, linestyle=":", zorder=0.5)
    return [f"dotted: the front reaches the top, the floor having moved by {units.length_value(abs(follows))}"]
