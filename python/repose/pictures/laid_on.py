# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Models of theory over measured base forces, as `repose plot DIR --theory` put them into summary.json."""

import textwrap
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.not_drawn import NotDrawn

NONE = "no theory was laid on it (repose plot DIR --theory MODEL)"
DATA = ("base disc", "mean ± standard error")  # in the legend, before the models
COLUMN = 4.0  # inch
LETTERS_PER_INCH = 18  # of a caption
ROW = 0.15  # inch of a line of a legend
CAPTION_LINE = 0.13  # inch
BEYOND = 1.25  # widths of the widest model that are shown


@dataclass(frozen=True)
class Measured:
    """Forces on a base [grain weights] over x [L], and the models that were laid on it."""

    name: str  # of the point of a sweep; "" of a run
    discs: dict  # x, normal, shear of each base disc
    bins: dict  # the same in bins, with normal_error and shear_error
    entries: "list[dict]"  # of the key "theory"


def curve(entry, name):
    """x [L] and force on a base disc [grain weights], by an entry of the summary alone; InputError as predict."""
    from repose import theory

    given = {key: value for key, value in entry["parameters"].items() if value is not None}
    prediction = theory.predict(entry["model"], **given)
    return entry["base"]["left"] + entry["base"]["width"] * prediction["x_over_b"], entry["scale"] * prediction[name]


def label(entry):
    """The model, which of its kind, and parameters that are neither defaults nor of the run."""
    from repose import theory

    defaults = {parameter.name: parameter.value for parameter in theory.models()[entry["model"]].parameters}
    words, numbers = [entry["model"]], []
    for name, value in entry["parameters"].items():
        if name == "model":
            words.append(value)
        elif value is not None and name not in (*entry["from_run"], "points") and not _same(value, defaults[name]):
            numbers.append(f"{name} = {value if isinstance(value, str) else format(value, 'g')}")
    return " ".join([*words, ", ".join(numbers)]).rstrip()


def _same(value, written):
    return value == written if isinstance(value, str) else value == _number(written)


def _number(text):
    try:
        return float(text)
    except ValueError:
        return None


def per_degree(agreement):
    """Chi-square per degree of freedom, as text."""
    if agreement["chi_square"] is None:
        return "–"
    value = agreement["chi_square"] / agreement["degrees"]
    return f"{value:.3g}" if value < 1000.0 else f"{value:.0f}"


def figure_of(measured, units, text):
    """A column for each Measured: normal force, shear force, and residuals of the normal force over their errors."""
    lines = max(len(each.entries) for each in measured) + 2
    width = COLUMN * len(measured) + 0.5
    caption = textwrap.wrap(f"{text}; residuals: of the normal force", int(LETTERS_PER_INCH * width))
    top = 0.11 + CAPTION_LINE * len(caption)
    size = (width, 4.5 + ROW * lines + top)
    figure = Figure(figsize=size)
    heights = {"height_ratios": [2.2, 1.3, 1.1]}
    grid = figure.subplots(3, len(measured), sharex="col", squeeze=False, gridspec_kw=heights)
    for row in grid[:2]:
        for axes in row[1:]:
            axes.sharey(row[0])
    try:
        for column, each in zip(grid.T, measured):
            _column(column, each)
            column[2].set_xlabel(units.length("x"))
    except ImportError as error:
        raise NotDrawn(f"theory needs the compiled part of the package: {error}") from error
    except ValueError as error:  # InputError: a file that a model reads has gone, say
        raise NotDrawn(" ".join(str(error).split())) from error
    for axes, words in zip(grid[:, 0], ("normal force\n(grain weights)", "shear force\n(grain weights)")):
        axes.set_ylabel(words)
    grid[2, 0].set_ylabel("residual\n/ error")
    figure.align_ylabels()
    figure.tight_layout(pad=0.4, w_pad=1.0, rect=(0.0, 0.0, 1.0, 1.0 - top / size[1]))
    style.caption(figure, "\n".join(caption))
    return figure


def _column(column, measured):
    for axes, name in zip(column, ("normal", "shear")):
        axes.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
        look = dict(color=style.GREY, markersize=2.2, alpha=0.35, markeredgewidth=0, zorder=1)
        axes.plot(measured.discs["x"], measured.discs[name], "o", label=DATA[0], **look)
        error = np.nan_to_num(measured.bins[f"{name}_error"])
        look = dict(fmt="s", color=style.INK, markersize=3.2, elinewidth=1.0, capsize=2, zorder=4)
        axes.errorbar(measured.bins["x"], measured.bins[name], error, label=DATA[1], **look)
        for k, entry in enumerate(measured.entries):
            axes.plot(*curve(entry, name), color=_colour(k), linewidth=1.4, label=_with_numbers(entry), zorder=3)
    residuals = column[2]
    residuals.axhspan(-2.0, 2.0, color=style.FAINT, alpha=0.4, linewidth=0, zorder=0)
    for k, entry in enumerate(measured.entries):
        part = {key: _array(values) for key, values in entry["residuals"].items()}
        with np.errstate(divide="ignore", invalid="ignore"):
            over = np.where(part["normal_error"] > 0.0, part["normal"] / part["normal_error"], np.nan)
        marker = style.MARKERS[k % len(style.MARKERS)]
        residuals.plot(part["x"], over, marker, color=_colour(k), markersize=3.4, linestyle="-", linewidth=0.6)
    bases = [entry["base"] for entry in measured.entries]
    middle = np.mean([base["centre"] for base in bases])
    reach = 0.5 * BEYOND * max(base["width"] for base in bases)
    column[2].set_xlim(middle - reach, middle + reach)
    handles, labels = column[0].get_legend_handles_labels()
    order = sorted(range(len(labels)), key=lambda k: DATA.index(labels[k]) if labels[k] in DATA else len(DATA))
    column[0].legend(
        [handles[k] for k in order], [labels[k] for k in order], loc="lower left", bbox_to_anchor=(0.0, 1.02),
        title=f"{measured.name}\n".lstrip() + "χ² per degree: normal, shear", title_fontsize=7, alignment="left",
    )  # fmt: skip


def _with_numbers(entry):
    return f"{label(entry)}: {per_degree(entry['normal'])}, {per_degree(entry['shear'])}"


def _colour(k):
    return style.SERIES[k % len(style.SERIES)]


def _array(values):
    return np.array([np.nan if value is None else value for value in values], dtype=float)
