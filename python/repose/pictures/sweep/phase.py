# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Stick-slip or steady motion of a driven wall: fraction of the time stuck and deviation of the force, over the speed of
the drive."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.sweep.axis import Axis, Line, lines_along
from repose.pictures.sweep.panel import CAPTION, add_legend, caption, draw_measure, has_measure

SPEED = "slips.relative_speed"
PANELS = (
    ("slips.stuck", "fraction of the time stuck"),
    ("slips.deviation", "deviation of the force / mean"),
)
LEAST_SPEEDS = 3
TOP = 0.39  # inch of the caption


def draw(sweep):
    """One figure with a panel for each measure."""
    axis = _axis(sweep)
    panels = [(key, label) for key, label in PANELS if has_measure(sweep, key)]
    if not panels:
        raise NotDrawn(f"no member has {' or '.join(key for key, _ in PANELS)}")
    figure = Figure(figsize=(1.2 + 2.6 * len(panels), 2.8 + TOP))
    for axes, (key, label) in zip(figure.subplots(1, len(panels), squeeze=False)[0], panels):
        draw_measure(axes, axis, sweep, key)
        axes.set_xscale("log")
        axes.axvline(1.0, color=style.GREY, linewidth=0.8, linestyle="--", zorder=0.5)
        axes.set_ylim(bottom=0.0)
        axes.set_xlabel("speed of the drive $v/v_t$")
        axes.set_ylabel(label)
    height = figure.get_size_inches()[1]
    top = TOP + add_legend(figure, figure.axes[0], axis, TOP)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - top / height), w_pad=1.2)
    caption(figure, axis, sweep, f"{CAPTION}\ndashed: $v = v_t = (m/k)^{{1/2}} g$, m the mass of the column and its piston")
    return [figure]


def _axis(sweep):
    """The measured speed, with a line for each combination of what varies beside the key that changes it most."""
    speed = sweep.measures[SPEED]["mean"] if has_measure(sweep, SPEED) else np.full(len(sweep.points), np.nan)
    some = np.isfinite(speed) & (speed > 0.0)
    if len(np.unique(speed[some])) < LEAST_SPEEDS:
        raise NotDrawn(f"fewer than {LEAST_SPEEDS} speeds of a wall driven by a spring whose slips were looked for")
    choices = [lines_along(sweep, key) for key in sorted(sweep.parameter_text)] or [[Line("", np.arange(len(speed)))]]
    best = max(choices, key=lambda lines: max(_range(speed[line.rows]) for line in lines))
    lines = [Line(line.name, line.rows[some[line.rows]]) for line in best]
    lines = [Line(line.name, line.rows[np.argsort(speed[line.rows])]) for line in lines if len(line.rows)]
    return Axis(SPEED, speed, lines)


def _range(speed):
    """The largest of the speeds above 0 over the least, at least 1."""
    known = speed[np.isfinite(speed) & (speed > 0.0)]
    return known.max() / known.min() if len(known) else 1.0
