# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Vertical stress and wall pressure of the columns of a sweep against depth, means over the members with their standard
errors, beside Janssen's law of the measured stress ratio and friction."""

import textwrap

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.error_band import draw_with_error_band
from repose.pictures.janssen import PRESSURE, STRESS, Janssen
from repose.pictures.sweep.panel import LETTERS_PER_INCH, in_lines

MOST = 12  # panels in a figure
COLUMNS = {1: 1, 2: 2, 3: 3, 4: 2}  # by number of panels; otherwise 3
LONGEST_LINE = 30  # letters of a name in one line
LEGEND, LINE = 0.3, 0.125  # inch of the legend with its space, and of a line of the caption
CAPTION = (
    "lines: mean over the members by slice ± standard error; dashed: Janssen's law of the mean K (wall pressure over "
    "vertical stress) and the mean friction of the walls (f, up on the grains > 0); nothing is fitted here"
)
LABEL = (0.22, 0.2)  # inch of the labels of all axes
POINTS = 200  # of a curve
HEADROOM = 1.25  # end of the axis over the largest value: space for the text
MEASURES = {"height": "height", "stress_ratio": "stress_ratio.mean", "friction": "friction"}


def draw(sweep):
    """Figures of up to twelve points each."""
    drawn = [k for k, column in enumerate(sweep.columns) if column is not None]
    if not drawn:
        raise NotDrawn("no point has columns between two upright walls with forces")
    return [_figure(sweep, drawn[start : start + MOST]) for start in range(0, len(drawn), MOST)]


def _figure(sweep, points):
    columns = COLUMNS.get(len(points), 3)
    rows = -(-len(points) // columns)
    width = 4.6 if columns == 1 else 2.35 * columns + 0.3
    lines = textwrap.wrap(CAPTION, int(LETTERS_PER_INCH * width))
    top = LEGEND + LINE * len(lines)
    size = (width, max(1.75 * rows + 0.3, 2.4) + top)
    figure = Figure(figsize=size)
    grid = figure.subplots(rows, columns, squeeze=False)
    for axes, k in zip(grid.flat, points):
        _panel(axes, sweep, k)
    for axes in grid.flat[len(points) :]:
        axes.remove()
    units = style.units_of(sweep)
    by_label = {}
    for axes in figure.axes:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            by_label.setdefault(label, handle)
    at = (0.08 / size[0], 1.0 - (top - LEGEND + 0.12) / size[1])
    figure.legend(by_label.values(), by_label, loc="upper left", bbox_to_anchor=at, ncol=len(by_label))
    edge = (LABEL[0] / size[0], LABEL[1] / size[1])
    style.fit(figure, (*edge, 1.0, 1.0 - top / size[1]), h_pad=0.6, w_pad=0.6)
    middle = (0.5 * (edge[0] + 1.0), 0.5 * (edge[1] + 1.0 - top / size[1]))
    drawing = dict(fontsize=8, color=style.INK, ha="center", va="center")
    figure.text(middle[0], 0.6 * edge[1], units.length("depth below the surface"), **drawing)
    figure.text(0.6 * edge[0], middle[1], units.stress("stress"), rotation=90, **drawing)
    style.caption(figure, "\n".join(lines))
    return figure


def _panel(axes, sweep, point):
    column = sweep.columns[point]
    order = np.argsort(column["depth"])
    for name, colour, label in (("stress", STRESS, "vertical stress"), ("pressure", PRESSURE, "wall pressure")):
        values = (column[each][order] for each in ("depth", name, f"{name}_error"))
        draw_with_error_band(axes, *values, colour, label)
    law = _law(sweep, point)
    members = int(column.attributes.get("members", 0))
    text = f"{members} {'member' if members == 1 else 'members'}"
    if law.known:
        depth = np.linspace(0.0, law.height, POINTS)
        drawing = dict(linewidth=1.0, linestyle="--")
        axes.plot(depth, law.stress(depth), color=STRESS, label="Janssen", **drawing)
        axes.plot(depth, law.pressure(depth), color=PRESSURE, label="K × Janssen", **drawing)
        text += f"\nK = {law.stress_ratio:.2f}, f = {law.friction:.2f}".replace("-", "−")
    axes.set_xlim(0.0, max(column["depth"].max(), law.height if law.known else 0.0))
    axes.set_ylim(0.0, HEADROOM * axes.get_ylim()[1])
    axes.locator_params(nbins=5)
    axes.set_title(in_lines(sweep.points[point], LONGEST_LINE), fontsize=7, pad=3)
    axes.text(0.04, 0.96, text, transform=axes.transAxes, ha="left", va="top", fontsize=6.5)


def _law(sweep, point):
    """Janssen's law of the means over the members of a point."""

    def mean(key):
        measure = sweep.measures.get(f"column.{key}")
        return np.nan if measure is None else measure["mean"][point]

    numbers = {name: mean(key) for name, key in MEASURES.items()}
    gravity = sweep.scene(sweep.points[point]).get("gravity", np.nan)
    numbers["weight"] = sweep.columns[point].attributes.get("mass", np.nan) * gravity
    if sweep.attributes.get("dimension", 2) == 3:
        return Janssen.in_cylinder(mean("radius"), **numbers)
    return Janssen(mean("width"), **numbers)
