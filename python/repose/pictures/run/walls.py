# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Force of the grains on each wall, and displacements of the walls that move along a direction."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.shapes import turned

MOST = len(style.SERIES)  # walls, one for each colour


def draw(run, state):
    """Figure of the time series of the whole run, of the walls that moved and those that carried the largest forces."""
    if state.frame:
        raise NotDrawn("it shows the whole run, not a frame")
    force = run.series.get("wall_force_x")
    if force is None or len(force) < 2:
        raise NotDrawn("the run has no walls, or fewer than two rows in its time series")
    axes_of_space = "xyz"[: run.attributes["dimension"]]
    force = np.stack([run.series[f"wall_force_{axis}"] for axis in axes_of_space], axis=-1)  # (rows, walls, D)
    displacement = run.series["wall_displacement"]
    straight = np.any(run.walls["direction"] != 0.0, axis=1)  # others turn about a centre, or their surface runs
    moving = straight & (np.abs(displacement).max(axis=0) > 0.0)
    carried = np.abs(force).max(axis=(0, 2))
    chosen = np.lexsort((-carried, ~moving))[:MOST]
    if not moving.any() and not carried.any():
        raise NotDrawn("no wall moved or carried a force")

    units, time = style.units_of(run), run.series["time"]
    weight = run.attributes["grain_weight"] or 1.0
    figure = Figure(figsize=(5.2, 3.6 if moving.any() else 2.4))
    rows = figure.subplots(2 if moving.any() else 1, 1, sharex=True, squeeze=False)[:, 0]
    for colour, wall in zip(style.SERIES, chosen):
        # Positive: resistance to the motion of a wall that moves along a direction, pressure on any other.
        along = run.walls["direction"][wall] if moving[wall] else _normals(run, wall, displacement[:, wall])
        label = str(run.walls["name"][wall])
        pressed = -np.sum(force[:, wall] * along, axis=1) / weight
        rows[0].plot(time, pressed, color=colour, linewidth=0.8, label=label)
        if moving[wall]:
            rows[1].plot(time, displacement[:, wall], color=colour, linewidth=0.8)
    rows[0].set_ylabel(units.force("force of the grains"))
    rows[0].legend(loc="lower left", bbox_to_anchor=(0.0, 1.02), ncols=min(4, len(chosen)))
    if moving.any():
        rows[1].set_ylabel(units.length("displacement"))
    rows[-1].set_xlabel(units.time("t"))
    figure.align_ylabels(rows)
    style.fit(figure)
    return figure


def _normals(run, wall, angle):
    """The unit normal of a wall that moves along no direction, at each row (rows, 2); the file has that of the last."""
    normals = np.tile(run.walls["normal"][wall], (len(angle), 1))
    turns = run.walls["rotates"][wall] and run.attributes["dimension"] == 2
    return turned(normals, angle - angle[-1]) if turns else normals
