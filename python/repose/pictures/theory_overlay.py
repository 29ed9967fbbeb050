# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Models of theory over measured base forces, as `repose plot DIR --theory` recorded them in summary.json."""

import textwrap
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn

NO_MODEL = "no model was compared with it (repose plot DIR --theory MODEL)"
DISC, ERROR = "base disc", "mean ± standard error"  # in the legend, before the models
COLUMN = 4.0  # inch
LETTERS_PER_INCH = 18  # of a caption
LEGEND_LINE = 0.15  # inch
CAPTION_LINE = 0.13  # inch
SHOWN = 1.25  # widths of the widest model


@dataclass(frozen=True)
class Comparison:
    """Forces on a base [grain weights] over x [L], and the models compared with them."""

    name: str  # of the point of a sweep; "" of a run
    discs: dict  # x, normal, shear of each base disc
    bins: dict  # the same in bins, with normal_error and shear_error
    entries: "list[dict]"  # of the key "theory", one for each model
    errors: str = ERROR  # what the bars of the bins are


def curve(entry, name):
    """x [L] and force on a base disc [grain weights] of an entry of the summary; InputError as predict."""
    from repose import theory  # here, because runs are drawn without the compiled part of the package too

    given = {key: value for key, value in entry["parameters"].items() if value is not None}
    prediction = theory.predict(entry["model"], **given)
    return entry["base"]["left"] + entry["base"]["width"] * prediction["x_over_b"], entry["scale"] * prediction[name]


def label(entry):
    """Name and kind of the model, and the parameters that are neither defaults nor taken from the run."""
    from repose import theory

    defaults = {parameter.name: parameter.value for parameter in theory.models()[entry["model"]].parameters}
    words, numbers = [entry["model"]], []
    for name, value in entry["parameters"].items():
        if name == "model":
            words.append(value)
        elif value is not None and name not in (*entry["from_run"], "points") and not _equal(value, defaults[name]):
            numbers.append(f"{name} = {value if isinstance(value, str) else format(value, 'g')}")
    return " ".join([*words, ", ".join(numbers)]).rstrip()


def _equal(value, written):
    """Whether a value is the one that is written as text."""
    if isinstance(value, str):
        return value == written
    try:
        return value == float(written)
    except ValueError:
        return False


def per_degree(agreement):
    """Chi-square per degree of freedom, as text."""
    if agreement["chi_square"] is None:
        return "–"
    value = agreement["chi_square"] / agreement["degrees"]
    return f"{value:.3g}" if value < 1000.0 else f"{value:.0f}"


def draw_comparisons(comparisons, units, text):
    """A column for each Comparison: normal force, shear force, and residuals of the normal force over their errors."""
    lines = max(len(each.entries) for each in comparisons) + 2
    width = COLUMN * len(comparisons) + 0.5
    caption = textwrap.wrap(f"{text}; residuals of the normal force", int(LETTERS_PER_INCH * width))
    top = 0.11 + CAPTION_LINE * len(caption)
    size = (width, 4.5 + LEGEND_LINE * lines + top)
    figure = Figure(figsize=size)
    heights = {"height_ratios": [2.2, 1.3, 1.1]}
    grid = figure.subplots(3, len(comparisons), sharex="col", squeeze=False, gridspec_kw=heights)
    for row in grid[:2]:
        for axes in row[1:]:
            axes.sharey(row[0])
    try:
        for column, each in zip(grid.T, comparisons):
            _draw_forces(column[:2], each)
            _draw_residuals(column[2], each)
            column[2].set_xlabel(units.length("x"))
    except ImportError as error:
        raise NotDrawn(f"theory needs the compiled part of the package: {error}") from error
    except ValueError as error:  # InputError, for instance where a file of the model no longer exists
        raise NotDrawn(" ".join(str(error).split())) from error
    for axes, words in zip(grid[:, 0], ("normal force\n(grain weights)", "shear force\n(grain weights)")):
        axes.set_ylabel(words)
    grid[2, 0].set_ylabel("residual\n/ error")
    figure.align_ylabels()
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - top / size[1]), w_pad=1.0)
    style.caption(figure, "\n".join(caption))
    return figure


def _draw_forces(column, comparison):
    """Normal force above shear force, with the legend above both."""
    for axes, name in zip(column, ("normal", "shear")):
        axes.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
        drawing = dict(color=style.pale(style.GREY, 0.45), markersize=2.2, markeredgewidth=0, zorder=1)
        axes.plot(comparison.discs["x"], comparison.discs[name], "o", label=DISC, **drawing)
        error = np.nan_to_num(comparison.bins[f"{name}_error"])
        drawing = dict(fmt="s", color=style.INK, markersize=3.2, elinewidth=1.0, capsize=2, zorder=4)
        axes.errorbar(comparison.bins["x"], comparison.bins[name], error, label=comparison.errors, **drawing)
        for k, entry in enumerate(comparison.entries):
            axes.plot(*curve(entry, name), color=_colour(k), linewidth=1.4, label=_label_with_numbers(entry), zorder=3)
    known = (DISC, comparison.errors)
    handles, labels = column[0].get_legend_handles_labels()
    order = sorted(range(len(labels)), key=lambda k: known.index(labels[k]) if labels[k] in known else len(known))
    column[0].legend(
        [handles[k] for k in order], [labels[k] for k in order], loc="lower left", bbox_to_anchor=(0.0, 1.02),
        title=f"{comparison.name}\n".lstrip() + "χ² per degree of freedom: normal, shear", title_fontsize=7,
        alignment="left",
    )  # fmt: skip


def _draw_residuals(axes, comparison):
    """Residuals of the normal force over their errors, in the interval of x that the widest model loads."""
    axes.axhspan(-2.0, 2.0, color=style.pale(style.FAINT, 0.4), linewidth=0, zorder=0)
    for k, entry in enumerate(comparison.entries):
        part = {key: _array(values) for key, values in entry["residuals"].items()}
        with np.errstate(divide="ignore", invalid="ignore"):
            over = np.where(part["normal_error"] > 0.0, part["normal"] / part["normal_error"], np.nan)
        marker = style.MARKERS[k % len(style.MARKERS)]
        axes.plot(part["x"], over, marker, color=_colour(k), markersize=3.4, linestyle="-", linewidth=0.6)
    bases = [entry["base"] for entry in comparison.entries]
    middle = np.mean([base["centre"] for base in bases])
    reach = 0.5 * SHOWN * max(base["width"] for base in bases)
    axes.set_xlim(middle - reach, middle + reach)


def _label_with_numbers(entry):
    return f"{label(entry)}: {per_degree(entry['normal'])}, {per_degree(entry['shear'])}"


def _colour(k):
    return style.SERIES[k % len(style.SERIES)]


def _array(values):
    return np.array([np.nan if value is None else value for value in values], dtype=float)
