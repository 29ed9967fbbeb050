# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Panels that show the grains of one run: discs, the lines between their centres, forces, lines of force."""

import numpy as np
from matplotlib.collections import LineCollection

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.grain_panel import GrainPanel
from repose.pictures.run.shapes import add_discs, add_lines, add_walls, centre_lines
from repose.pictures.run.visible_box import visible_box

WIDEST = 1.8  # points, the line of the largest force
THINNEST = 0.15
WEAKEST = 0.01  # of the largest force: weaker contacts of a network are not drawn


def draw_grains(axes, study, panel):
    """The discs; with `filled` dark, which shows vacancies and dislocations."""
    run, state, shown = _shown(axes, study, panel)
    filled = panel.get("filled", False)
    drawing = dict(facecolor=style.INK, edgecolor="white") if filled else dict(facecolor="white", edgecolor=style.INK)
    add_walls(shown, run, state)
    add_discs(shown, run, state, ~state.grains.held, linewidth=0.1 if filled else 0.35, **drawing)
    add_discs(shown, run, state, state.grains.held, facecolor=style.GREY, edgecolor="white", linewidth=0.2)


def draw_network(axes, study, panel):
    """A line between the centres of each pair within reach of the force: light where the packing is loose."""
    run, state, shown = _shown(axes, study, panel)
    add_walls(shown, run, state)
    add_lines(shown, centre_lines(run, state)[0], 0.4, style.INK)


def draw_forces(axes, study, panel):
    """The normal forces as lines between centres, their width proportional to the force."""
    run, state, shown = _shown(axes, study, panel)
    force = np.nan_to_num(state.contacts.normal_force)
    add_discs(shown, run, state, state.grains.held, facecolor=style.FAINT, edgecolor="white", linewidth=0.2)
    add_walls(shown, run, state)
    lines, contact = centre_lines(run, state)
    seen = force[contact] > WEAKEST * force.max(initial=0.0)
    _add_widths(axes, lines[seen], force[contact][seen])


def draw_lines(axes, study, panel):
    """The strongest or the weakest contact of each grain."""
    run, state, shown = _shown(axes, study, panel)
    table = run.analysis and run.analysis["force_lines"]
    if table is None:
        raise NotDrawn("the run has no lines of force")
    chosen = np.zeros(len(state.contacts), dtype=bool)
    chosen[np.unique(table[panel.get("which", "strongest")])] = True
    add_discs(shown, run, state, ~state.grains.held, facecolor="#eff1f4", edgecolor="#d3d8df", linewidth=0.2)
    add_discs(shown, run, state, state.grains.held, facecolor=style.FAINT, edgecolor="white", linewidth=0.2)
    add_walls(shown, run, state)
    lines, contact = centre_lines(run, state)
    kept = chosen[contact]
    _add_widths(axes, lines[kept], np.nan_to_num(state.contacts.normal_force)[contact][kept])


def _add_widths(axes, lines, force):
    largest = force.max(initial=0.0)
    if not largest > 0.0:
        raise NotDrawn("no contact carries a force")
    widths = np.maximum(THINNEST, WIDEST * force / largest)
    axes.add_collection(LineCollection(lines, linewidths=widths, colors=style.INK, capstyle="round"), autolim=False)


def _shown(axes, study, panel):
    """The run, its state nearest to the wanted time, and the axes as a panel of grains."""
    run = study.run(panel["point"], panel.get("seed"))
    state = _state(run, panel.get("time"))
    box = visible_box(run, state)
    axes.set_xlim(box.x_min, box.x_max)
    axes.set_ylim(box.y_min, box.y_max)
    axes.set_aspect("equal", adjustable="box")
    axes.locator_params(nbins=6, steps=[1, 2, 5, 10])
    units = style.units_of(run)
    axes.set_xlabel(units.length("x"))
    axes.set_ylabel(units.length("y"))
    return run, state, GrainPanel(axes.figure, axes, box, 1.0, 0.0)


def _state(run, time):
    if time is None:
        return run.state
    if not run.frames:
        raise NotDrawn("no frame was saved")
    states = [run.frame(name) for name in run.frames]
    return min(states, key=lambda state: abs(state.time - time))
