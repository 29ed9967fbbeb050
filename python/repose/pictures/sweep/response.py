# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Responses to a point load, simulated and predicted: response.csv and response.json of a sweep folder."""

import csv
import json

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.sweep.panel import in_lines

CURVES = (
    ("elastic", style.ORANGE, "-", "elastic layer, rough rigid floor"),
    ("elastic_fitted", style.INK, "-", "the same, Poisson's ratio fitted"),
    ("osl", style.GREEN, "--", "OSL, rays along the lattice"),
    ("diffusive", style.PURPLE, ":", "diffusive (q-model)"),
)
LABELS = {"elastic": "elastic", "elastic_fitted": "fitted", "osl": "OSL", "diffusive": "diffusive"}
COLUMNS = 2
LONGEST_LINE = 40  # letters of a name in one line
HEADROOM = 1.35  # end of the axis over the largest value


def draw(sweep):
    """One figure with a panel for each response."""
    table, fits = sweep.path / "response.csv", sweep.path / "response.json"
    if not (table.is_file() and fits.is_file()):
        raise NotDrawn("no two points of the sweep differ by one downward load alone")
    with table.open() as file:
        rows = list(csv.DictReader(file))
    responses = json.loads(fits.read_text())
    columns = min(COLUMNS, len(responses))
    lines = -(-len(responses) // columns)
    figure = Figure(figsize=(4.6 if columns == 1 else 6.6, 2.3 * lines + 0.75))
    grid = figure.subplots(lines, columns, squeeze=False, sharex=True)
    for axes, response in zip(grid.flat, responses):
        _panel(axes, response, _columns(rows, response["point"]))
    for axes in grid.flat[len(responses) :]:
        axes.remove()
    for axes in grid.flat[max(0, len(responses) - columns) : len(responses)]:
        axes.set_xlabel("x / h")
        axes.tick_params(labelbottom=True)
    for axes in grid[:, 0]:
        axes.set_ylabel("response of the base (F / h)")
    height = figure.get_size_inches()[1]
    handles, labels = grid[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper left", bbox_to_anchor=(0.02, 1.0 - 0.24 / height), ncol=3)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - 0.56 / height))
    style.caption(figure, "normal force on the base with the load minus that without it, same seeds; F: load, h: depth")
    return [figure]


def _columns(rows, point):
    names = ("x_over_h", "response", "response_error", *(name for name, *_ in CURVES))
    chosen = [row for row in rows if row["point"] == point]
    return {name: np.array([float(row[name]) if row[name] else np.nan for row in chosen]) for name in names}


def _panel(axes, response, columns):
    x, values, errors = columns["x_over_h"], columns["response"], columns["response_error"]
    axes.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
    for name, colour, dashes, label in CURVES:
        if name == "elastic_fitted" and not np.isfinite(columns[name]).any():
            continue
        stepped = {"drawstyle": "steps-mid"} if name == "osl" else {}
        axes.plot(x, columns[name], dashes, color=colour, linewidth=0.9, label=label, **stepped)
    bars = errors if np.isfinite(errors).any() else None
    axes.errorbar(x, values, bars, fmt="o", color=style.BLUE, markersize=2.8, linewidth=0.8, markeredgewidth=0,
                  label="simulation")  # fmt: skip
    axes.set_xlim(x[0], x[-1])
    low = min(0.0, np.nanmin(values))
    high = HEADROOM * max(np.nanmax(values), np.nanmax(columns["elastic"]))
    axes.set_ylim(1.2 * low - 0.03 * high, high)
    axes.set_title(in_lines(response["point"], LONGEST_LINE), fontsize=7, pad=3)
    for x_text, side, lines in ((0.02, "left", _seeds_and_load(response)), (0.98, "right", _chi_squares(response))):
        axes.text(x_text, 0.97, "\n".join(lines), transform=axes.transAxes, ha=side, va="top", fontsize=6.5)


def _seeds_and_load(response):
    seeds, places = response["seeds"], response["places"]
    return [
        f"{seeds} seed{'s' if seeds > 1 else ''}, {places} load position{'s' if places > 1 else ''}",
        f"F = {response['force']:.3g} grain weight{'s' if response['force'] != 1 else ''}",
        f"h = {response['depth']['mean']:.3g}",
    ]


def _chi_squares(response):
    known = {name: c for name, c in response["curves"].items() if c["chi_square"] is not None}
    if not known:
        return []
    lines = [f"{LABELS[name]} {c['chi_square'] / c['bins']:.2g}" for name, c in known.items()]
    return ["χ² per bin:", *lines, f"fitted ν = {response['fitted_poisson']:.2f}"]
