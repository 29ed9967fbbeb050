# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Mean base profiles of the points of a sweep, with their standard errors between members."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.error_band import draw_with_error_band
from repose.pictures.sweep.panel import in_lines

MOST = 12  # panels in a figure
COLUMNS = {1: 1, 2: 2, 3: 3, 4: 2}  # by number of panels; otherwise 3
LONGEST_LINE = 30  # letters of a name in one line
TOP = 0.42  # inch of caption and legend
LABEL = (0.36, 0.2)  # inch of the labels of all axes
SHOWN = 1.3  # half widths of the loaded part of the base


def draw(sweep):
    """Figures of up to twelve points each."""
    drawn = [k for k, profile in enumerate(sweep.profiles) if profile is not None and _is_loaded(profile)]
    if not drawn:
        raise NotDrawn("no point has a base that carries a force")
    limits = _limits([sweep.profiles[k] for k in drawn])
    return [_figure(sweep, drawn[start : start + MOST], limits) for start in range(0, len(drawn), MOST)]


def _is_loaded(profile):
    return any(np.abs(np.nan_to_num(profile[name])).max(initial=0.0) > 0.0 for name in ("normal", "shear"))


def _figure(sweep, points, limits):
    columns = COLUMNS.get(len(points), 3)
    rows = -(-len(points) // columns)
    size = (4.6 if columns == 1 else 2.35 * columns + 0.3, max(1.75 * rows + 0.3, 2.4) + TOP)
    figure = Figure(figsize=size)
    grid = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes, k in zip(grid.flat, points):
        _panel(axes, sweep.points[k], sweep.profiles[k])
    for axes in grid.flat[len(points) :]:
        axes.remove()
    for axes in grid.flat[max(0, len(points) - columns) : len(points)]:
        axes.tick_params(labelbottom=True)
    grid[0, 0].set_xlim(*limits[0])
    grid[0, 0].set_ylim(*limits[1])
    handles, labels = grid[0, 0].get_legend_handles_labels()
    at = (0.08 / size[0], 1.0 - 0.24 / size[1])
    figure.legend(handles, labels, loc="upper left", bbox_to_anchor=at, ncol=len(handles))
    edge = (LABEL[0] / size[0], LABEL[1] / size[1])
    style.fit(figure, (*edge, 1.0, 1.0 - TOP / size[1]), h_pad=0.6, w_pad=0.6)
    middle = (0.5 * (edge[0] + 1.0), 0.5 * (edge[1] + 1.0 - TOP / size[1]))
    drawing = dict(fontsize=8, color=style.INK, ha="center", va="center")
    figure.text(middle[0], 0.7 * edge[1], style.units_of(sweep).length("x"), **drawing)
    figure.text(0.5 * edge[0], middle[1], "force on a base grain\n(grain weights)", rotation=90, **drawing)
    widths = {profile.binned.attributes["bin_width"] for profile in (sweep.profiles[k] for k in points)}
    width = f" in bins of {style.units_of(sweep).length_value(widths.pop())}" if len(widths) == 1 else ""
    style.caption(figure, f"lines: mean over the members{width} ± standard error; dots: single base grains")
    return figure


def _panel(axes, name, profile):
    axes.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
    bins = profile.binned
    for force, colour in (("normal", style.BLUE), ("shear", style.ORANGE)):
        axes.plot(profile["x"], profile[force], "o", color=style.pale(colour, 0.5), markersize=1.8, markeredgewidth=0, zorder=1.5)
        draw_with_error_band(axes, bins["x"], bins[force], bins[f"{force}_error"], colour, f"{force} force")
    axes.set_title(in_lines(name, LONGEST_LINE), fontsize=7, pad=3)
    text = _members_and_dip(profile.attributes)
    axes.text(0.97, 0.96, text, transform=axes.transAxes, ha="right", va="top", fontsize=6.5)


def _members_and_dip(values):
    members = values["members"]
    lines = [f"{members} {'member' if members == 1 else 'members'}"]
    if np.isfinite(values["dip_index"]):
        error = values["dip_index_error"]
        lines.append(f"dip index {values['dip_index']:.2f}" + (f" ± {error:.2f}" if np.isfinite(error) else ""))
        low, high = (values.get(f"dip_index_{end}", np.nan) for end in ("low", "high"))  # older sweeps have none
        if np.isfinite(low) and np.isfinite(high):
            lines.append(f"95 %: {low:.2f} to {high:.2f}")
    return "\n".join(lines)


def _limits(profiles):
    """((x_min, x_max), (y_min, y_max)) of the loaded parts of all profiles, with space for the text above."""
    ends = [
        profile.attributes["centre"] + side * SHOWN * profile.attributes["half_width"]
        for profile in profiles
        for side in (-1.0, 1.0)
    ]
    ends = [end for end in ends if np.isfinite(end)] or [profile["x"][k] for profile in profiles for k in (0, -1)]
    values = [profile[name] for profile in profiles for name in ("normal", "shear")]
    low, high = (edge([edge(part[np.isfinite(part)], initial=0.0) for part in values]) for edge in (np.min, np.max))
    high = max(high, low + 1.0)
    return (min(ends), max(ends)), (low - 0.05 * (high - low), high + 0.3 * (high - low))
