# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The part of the plane that a picture of grains shows, and axes of the same scale in x and y for it."""

from dataclasses import dataclass

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from repose import style
from repose.not_drawn import NotDrawn

# inches
AXES_WIDTH = 6.3
AXES_HEIGHT = 6.5
LEFT, RIGHT, BOTTOM, TOP = 0.58, 0.12, 0.42, 0.28
LEGEND_ROW = 0.18
BAR_ROW = 0.34  # a colour bar with its numbers
BAR_WIDTH, BAR_HEIGHT = 2.0, 0.08
LEAST_AXES_WIDTH = 3.9  # of which the keys of the force network take most
LARGEST_GRAIN = 0.17

MOST_VECTORS = 20000  # of more grains the marks become pixels in vector files, which would be slow to open

# grain diameters
WIDEST_GAP = 10.0  # a grain beyond a wider gap in x has left the heap
SIDE_MARGIN = 3.0
MARGIN = 1.0


@dataclass(frozen=True)
class Box:
    """x_min <= x <= x_max, y_min <= y <= y_max [L]."""

    x_min: float
    x_max: float
    y_min: float
    y_max: float

    def near(self, points, reach):
        """Which points (..., 2) lie inside or within `reach` [L] of the box; bool (...)."""
        x, y = points[..., 0], points[..., 1]
        return (
            (x >= self.x_min - reach)
            & (x <= self.x_max + reach)
            & (y >= self.y_min - reach)
            & (y <= self.y_max + reach)
        )


@dataclass(frozen=True)
class Field:
    """Axes that show a box."""

    figure: Figure
    axes: object
    box: Box
    points_per_length: float  # [1/72 inch per L]
    row: float  # [inch] from the top of the figure to the row of keys above the axes


def supported(state):
    """Moving grains (N, bool) that a chain of contacts links to the base or a plane; without those, all that touch."""
    held = state.grains.held
    first, second = state.contacts.grains.T
    with_plane = second < 0
    pair = state.rows(state.contacts.grains[~with_plane])
    linked = held.copy()
    linked[state.rows(first[with_plane])] = True
    if not linked.any():
        linked[pair] = True
    count = -1
    while count != np.count_nonzero(linked):
        count = np.count_nonzero(linked)
        linked[pair[linked[pair].any(axis=1)]] = True
    return linked & ~held


def wrapped(run, positions):
    """Positions (N, 2) [L] with x brought into the box where it is periodic."""
    if not run.attributes["periodic"]:
        return positions
    low, high = run.attributes["x_min"], run.attributes["x_max"]
    return np.column_stack([low + (positions[:, 0] - low) % (high - low), positions[:, 1]])


def crop(run, state):
    """Box around the heap and the base below it; grains in flight do not count while any are supported."""
    grains = state.grains
    diameter = run.attributes["grain_diameter"]
    centre, radius = wrapped(run, grains.position), grains.radius
    finite = np.isfinite(centre).all(axis=1)  # a run that failed may have lost its grains to infinity
    for shown in (supported(state) & finite, ~grains.held & finite, finite):
        if shown.any():
            break
    else:
        raise NotDrawn("no grains")
    shown = np.flatnonzero(shown)
    if run.attributes["periodic"]:
        x_min, x_max = run.attributes["x_min"], run.attributes["x_max"]
    else:
        shown = _without_strays(shown, centre[:, 0], WIDEST_GAP * diameter)
        x_min = (centre[shown, 0] - radius[shown]).min() - SIDE_MARGIN * diameter
        x_max = (centre[shown, 0] + radius[shown]).max() + SIDE_MARGIN * diameter
    below = grains.held & (centre[:, 0] >= x_min) & (centre[:, 0] <= x_max)
    below[shown] = True
    y_min = (centre[below, 1] - radius[below]).min() - MARGIN * diameter
    y_max = (centre[shown, 1] + radius[shown]).max() + MARGIN * diameter
    y_max = max(y_max, y_min + 5.0 * diameter, y_min + (x_max - x_min) / 12.0)
    return Box(x_min, x_max, y_min, y_max)


def _without_strays(shown, x, gap):
    """Of the rows `shown`, the most numerous that follow on each other in x without a wider gap."""
    ordered = shown[np.argsort(x[shown])]
    parts = np.split(ordered, np.flatnonzero(np.diff(x[ordered]) > gap) + 1)
    return max(parts, key=len)


def _at_least(low, high, width):
    missing = max(0.0, width - (high - low))
    return low - 0.5 * missing, high + 0.5 * missing


def make_field(run, state, with_legend):
    """Axes for a picture of grains, with a caption; `with_legend` leaves a row above them."""
    return make_fields(run, state, [LEGEND_ROW if with_legend else 0.0])[0]


def make_fields(run, state, rows, below=0.0):
    """Fields of the same box one below the other, with a caption: one for each height in `rows` [inch] of the keys
    above it. `below` [inch] of the figure is left empty at the bottom."""
    if run.attributes["dimension"] != 2:
        raise NotDrawn("not a two-dimensional run")
    box = crop(run, state)
    scale = min(
        AXES_WIDTH / (box.x_max - box.x_min),
        AXES_HEIGHT / len(rows) / (box.y_max - box.y_min),
        LARGEST_GRAIN / run.attributes["grain_diameter"],
    )
    if not run.attributes["periodic"]:
        box = Box(*_at_least(box.x_min, box.x_max, LEAST_AXES_WIDTH / scale), box.y_min, box.y_max)
    axes_width, axes_height = (box.x_max - box.x_min) * scale, (box.y_max - box.y_min) * scale
    width = LEFT + max(axes_width, LEAST_AXES_WIDTH) + RIGHT
    height = TOP + sum(rows) + len(rows) * (axes_height + BOTTOM) + below
    figure = Figure(figsize=(width, height))
    fields, top = [], TOP
    for row in rows:
        low = height - top - row - axes_height
        axes = figure.add_axes([LEFT / width, low / height, axes_width / width, axes_height / height])
        _lay_out(axes, run, state, box, axes_width, axes_height)
        fields.append(Field(figure, axes, box, scale * 72.0, top))
        top += row + axes_height + BOTTOM
    style.caption(figure, _what_is_shown(run, state, box))
    return fields


def _lay_out(axes, run, state, box, width, height):
    if len(state.grains) > MOST_VECTORS:
        axes.set_rasterization_zorder(1.5)  # between the collections and the lines
    axes.set_xlim(box.x_min, box.x_max)
    axes.set_ylim(box.y_min, box.y_max)
    axes.locator_params(axis="y", nbins=max(2, min(8, int(height / 0.35))), steps=[1, 2, 5, 10])
    axes.locator_params(axis="x", nbins=max(2, min(10, int(width / 0.6))), steps=[1, 2, 5, 10])
    units = style.units_of(run)
    axes.set_xlabel(units.length("x"))
    axes.set_ylabel(units.length("y"))


def _what_is_shown(run, state, box):
    moving = ~state.grains.held
    outside = np.count_nonzero(moving & ~box.near(wrapped(run, state.grains.position), 0.0))
    count = np.count_nonzero(moving)
    text = f"{count} {'grain' if count == 1 else 'grains'}"
    if outside:
        text += f" ({outside} outside the picture)"
    if run.attributes.get("method") != "deposition":  # where time counts grains
        text += f", t = {style.units_of(run).time_value(state.time)}"
    return text if state.frame or run.attributes["status"] == "finished" else f"{text}, {run.attributes['status']}"


def legend_above(field, handles, title=None, down=0.0):
    """One row of keys above the axes, `down` [inch] from the top of what is left for keys."""
    at = _title_above(field, title, down)
    labels = [handle.get_label() for handle in handles]
    field.figure.legend(handles, labels, loc="upper left", bbox_to_anchor=at, ncol=len(handles))


def bar_above(field, mappable, title, handles=(), extend="neither"):
    """Title, colour bar and keys in one row above the axes."""
    width, height = field.figure.get_size_inches()
    left, top = _title_above(field, title)
    low = top - (BAR_HEIGHT + 0.02) / height
    axes = field.figure.add_axes([left, low, BAR_WIDTH / width, BAR_HEIGHT / height])
    bar = field.figure.colorbar(mappable, cax=axes, orientation="horizontal", extend=extend)
    bar.outline.set_linewidth(0.4)
    axes.tick_params(labelsize=6, length=2, pad=1.5)
    axes.locator_params(axis="x", nbins=6, steps=[1, 2, 5, 10])
    if handles:
        at = (left + (BAR_WIDTH + 0.25) / width, top)
        labels = [handle.get_label() for handle in handles]
        field.figure.legend(handles, labels, loc="upper left", bbox_to_anchor=at, ncol=len(handles))


def _title_above(field, title, down=0.0):
    """Where the row goes on after its title, in parts of the figure."""
    width, height = field.figure.get_size_inches()
    at = (0.08 / width, 1.0 - (field.row + down - 0.04) / height)
    if not title:
        return at
    text = field.figure.text(*at, title, ha="left", va="top", fontsize=7, color=style.INK)
    extent = text.get_window_extent(FigureCanvasAgg(field.figure).get_renderer())
    return ((extent.x1 / field.figure.dpi + 0.12) / width, at[1])
