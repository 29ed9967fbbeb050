# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Apparent mass of columns against their height, with Janssen's law of one and of two screening lengths: heights.csv and
heights.json of a sweep folder."""

import csv
import json

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn

POINTS = 200  # of a curve
DECADE = 10.0  # ratio of masses from which the axis is logarithmic
BEGIN = 0.7  # of a curve on a logarithmic axis, over the least height
LEGEND_ROW = 0.15  # inch
TOP = 0.42  # inch of the caption
SYMBOLS = {"lambda": "λ", "lambda_1": "λ₁", "lambda_2": "λ₂"}


def draw(sweep):
    """One figure with all fits."""
    table, results = sweep.path / "heights.csv", sweep.path / "heights.json"
    if not (table.is_file() and results.is_file()):
        raise NotDrawn("the sweep file asks for no fit over heights ([[fit]])")
    with table.open() as file:
        rows = list(csv.DictReader(file))
    fits = [(fit, _columns(rows, fit["fit"])) for fit in json.loads(results.read_text())]
    fits = [(fit, data) for fit, data in fits if len(data["height"])]
    if not fits:
        raise NotDrawn("no fit over heights has points")
    mass = np.concatenate([data["mass"] for _, data in fits])
    height = np.concatenate([data["height"] for _, data in fits])
    logarithmic = mass.min() > 0.0 and mass.max() > DECADE * mass.min()
    along = np.linspace(BEGIN * height.min() if logarithmic else 0.0, 1.03 * height.max(), POINTS)
    legend = LEGEND_ROW * (2 * len(fits) + 1) + 0.1
    units = style.units_of(sweep)
    figure = Figure(figsize=(5.2, 3.2 + TOP + legend))
    axes = figure.subplots()
    for k, (fit, data) in enumerate(fits):
        _draw_fit(axes, fit, data, along, k, units)
    whole = np.nanmean([np.mean(data["column_mass"] / data["height"]) for _, data in fits])
    axes.plot(along, whole * along, color=style.GREY, linewidth=0.9, linestyle=":", label="mass of the whole column")
    if logarithmic:
        axes.set_yscale("log")
        axes.set_ylim(mass.min() / 1.6, 1.6 * mass.max())
    else:
        axes.set_ylim(0.0, 1.15 * mass.max())
    axes.set_xlim(0.0, along[-1])
    axes.set_xlabel(units.length("height of the column"))
    axes.set_ylabel(units.mass("apparent mass"))
    size = figure.get_size_inches()
    handles, labels = axes.get_legend_handles_labels()
    order = sorted(range(len(labels)), key=lambda j: labels[j].startswith("mass of"))
    at = (0.08 / size[0], 1.0 - TOP / size[1])
    chosen = ([handles[j] for j in order], [labels[j] for j in order])
    figure.legend(*chosen, loc="upper left", bbox_to_anchor=at, handlelength=2.4)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - (TOP + legend) / size[1]))
    style.caption(
        figure,
        "points: mean ± standard error over the members; dashed: fit of one length λ, solid: of two\n"
        "(λ₁ sets the size, λ₂ the growth with height); p: probability of data as far from the fit",
    )
    return [figure]


def apparent_mass(height, mass_per_height, length_1, length_2, pushed_up):
    """Bratberg (2003), Eqs. (25) and (38), for one length and for two: m' l1 (1 - exp(-h/l2)) where the walls carry, and
    m' l1 (exp(h/l2) - 1) where they push down."""
    sense = -1.0 if pushed_up else 1.0
    return -sense * mass_per_height * length_1 * np.expm1(-sense * height / length_2)


def _columns(rows, fit):
    chosen = [row for row in rows if row["fit"] == fit]
    names = ("height", "mass", "mass_error", "column_mass")
    return {name: np.array([float(row[name] or "nan") for row in chosen]) for name in names}


def _draw_fit(axes, fit, data, along, k, units):
    """The points of a fit and its two laws; without these where the fit has a problem."""
    colour, marker = style.SERIES[k % len(style.SERIES)], style.MARKERS[k % len(style.MARKERS)]
    drawing = dict(fmt=marker, color=colour, markersize=4, elinewidth=1.0, capsize=2)
    label = f"{fit['fit']}: {fit['problem']}" if fit["problem"] else None
    axes.errorbar(data["height"], data["mass"], np.nan_to_num(data["mass_error"]), label=label, **drawing)
    if fit["problem"]:
        return
    for names, line, chance in ((("lambda",), "--", "chance_one"), (("lambda_1", "lambda_2"), f"{marker}-", "chance_two")):
        lengths = [fit[name]["mean"] for name in names]
        if None in lengths:
            continue
        law = apparent_mass(along, fit["mass_per_height"], lengths[0], lengths[-1], fit["direction"] == "pushed-up")
        words = [f"{SYMBOLS[name]} = {_number(fit[name], units)}" for name in names]
        if len(names) == 2:
            words.append(f"λ₁/λ₂ = {_number(fit['ratio'])}")
        label = f"{fit['fit']}: {', '.join(words)}" + ("" if fit[chance] is None else f"; p = {fit[chance]:.2g}")
        axes.plot(along, law, line, color=colour, linewidth=1.1, markevery=[], markersize=4, label=label)


def _number(entry, units=None):
    """Mean and standard error, to two digits of the error; `units` of a length."""
    mean, error = entry["mean"], entry["error"]
    if mean is None:
        return "unknown"
    digits = max(0, 1 - int(np.floor(np.log10(error)))) if error else 3
    text = f"{mean:.{digits}f}" + (f" ± {error:.{digits}f}" if error else "")
    return text if units is None else f"({text}) {'σ' if units.reduced else 'm'}"
