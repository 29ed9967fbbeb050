# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The account of the energy: where it is, where it went, and how well the account closes."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.not_drawn import NotDrawn

THERE = ("gravitational", "kinetic", "elastic")
GONE = ("damping", "friction", "walls", "lost")
LABELS = {"walls": "at walls"}


def draw(run, state):
    """Figure of the account over the whole run, in units of what was put in by its end."""
    if state.frame:
        raise NotDrawn("belongs to the whole run, not to a frame")
    if run.energy is None or len(run.energy["time"]) < 2:
        raise NotDrawn("no account of the energy (output.energy)")
    account, time = run.energy, run.energy["time"]
    put_in = account["sources"] + account["walls_work"] + account["loads_work"]
    scale = np.abs(put_in).max()
    if not scale > 0.0:
        raise NotDrawn("no energy was put in")
    figure = Figure(figsize=(5.2, 3.8))
    top, bottom = figure.subplots(2, 1, sharex=True, height_ratios=(3, 1))
    top.plot(time, put_in / scale, color=style.INK, linewidth=1.2, linestyle="--", label="put in")
    for colour, name in zip(style.SERIES, THERE):
        top.plot(time, account[name] / scale, color=colour, label=name)
    for colour, name in zip((*style.SERIES[len(THERE) :], style.GREY), GONE):
        if np.abs(account[name]).max() > 0.0:
            top.plot(time, account[name] / scale, color=colour, linestyle="-.", label=LABELS.get(name, name))
    units = style.units_of(run)
    top.set_ylabel(f"energy over {units.energy(f'{scale:.4g}')}")
    top.legend(loc="lower left", bbox_to_anchor=(0.0, 1.02), ncols=4)
    bottom.plot(time, account["error"] / scale, color=style.ORANGE, linewidth=0.7)
    bottom.set_ylabel("error")
    bottom.set_xlabel(units.time("t"))
    figure.align_ylabels([top, bottom])
    figure.tight_layout(pad=0.4)
    return figure
