# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Small panels of the other measures of a sweep."""

from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.sweep.axis import axis_of
from repose.pictures.sweep.panel import CAPTION, TOP, add_legend, caption, draw_measure, has_measure, label_axes, panel_height

COLUMNS = 3


def draw(sweep):
    """One figure of the measures that exist."""
    units = style.units_of(sweep)
    panels = [(key, label) for key, label in _labels(units) if has_measure(sweep, key)]
    if not panels:
        raise NotDrawn("no member has any of the measures shown here")
    axis = axis_of(sweep)
    columns = min(COLUMNS, len(panels))
    rows = -(-len(panels) // columns)
    beside = 0.0 if axis.key else 1.2
    figure = Figure(figsize=(2.3 * columns + beside, rows * panel_height(axis, sweep, 1.65) + TOP))
    grid = figure.subplots(rows, columns, squeeze=False)
    for k, axes in enumerate(grid.flat):
        if k >= len(panels):
            axes.remove()
            continue
        key, label = panels[k]
        draw_measure(axes, axis, sweep, key)
        label_axes(axes, axis, sweep, label, names=k % columns == 0)
        axes.locator_params(axis="x" if axis.key is None else "y", nbins=4)
        if axis.key is not None and k + columns < len(panels):
            axes.set_xlabel("")
    height = figure.get_size_inches()[1]
    top = TOP + add_legend(figure, grid[0, 0], axis, TOP)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - top / height), h_pad=0.8, w_pad=0.8)
    caption(figure, axis, sweep, CAPTION)
    return [figure]


def _labels(units):
    """(key, label) in the order of the panels."""
    return (
        ("coordination", "coordination"),
        ("core.coordination", "coordination\nof the core"),
        ("core.solid_fraction", "solid fraction\nof the core"),
        ("heap_height", units.length("heap height")),
        ("max_overlap", "largest overlap\n/ diameter"),
        ("anisotropy", "anisotropy\nof contacts"),
        ("forces.mean", "mean normal force\n(grain weights)"),
        ("forces.sliding_fraction", "fraction of\nsliding contacts"),
        ("chains.largest_height", units.length("height of the highest\nstrong cluster")),
        ("base_scatter", "scatter of\nthe base force"),
        ("avalanches.mean_size", "grains per\navalanche"),
        ("avalanches.mean_depth", units.length("depth of the\nmoving layer")),
    )
