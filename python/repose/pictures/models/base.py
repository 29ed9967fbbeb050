# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Normal and shear force of a pile on its base."""

from matplotlib.figure import Figure

from repose import style
from repose.pictures.models import captions

MOST_MARKERS = 200  # discs; above it the force is a line


def draw(prediction):
    """Figure of a prediction with the columns x_over_b, normal and shear; a dip is marked with its depth."""
    figure = Figure(figsize=(4.6, 3.4))
    upper, lower = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [2, 1]})
    discrete = prediction.unit("normal") == "m g"  # forces on single discs, not stresses of a continuum
    few = discrete and len(prediction["normal"]) <= MOST_MARKERS
    for axes, name, colour in ((upper, "normal", style.BLUE), (lower, "shear", style.ORANGE)):
        axes.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
        line = {"marker": "o", "markersize": 2.5, "linewidth": 0.6, "clip_on": False} if few else {"linewidth": 1.4}
        axes.plot(prediction["x_over_b"], prediction[name], color=colour, **line)
        axes.set_ylabel(f"{name}\n({prediction.unit(name)})")
    upper.set_ylim(bottom=0.0)
    mark_dip(upper, prediction)
    lower.set_xlabel("x / B")
    lower.set_xlim(0.0, 1.0)
    figure.align_ylabels()
    captions.fit_below(figure, captions.add(figure, prediction.model, leave_out=("points",)))
    return figure


def mark_dip(axes, prediction):
    """A line from the normal stress at the centre up to the largest one, where a prediction has a dip."""
    if "dip" not in prediction.numbers or prediction["dip"] != 1.0:
        return
    centre, peak, depth = (prediction[name] for name in ("centre_normal", "peak_normal", "dip_depth"))
    axes.axhline(peak, color=style.GREY, linewidth=0.6, linestyle=(0, (4, 3)), zorder=0)
    axes.set_ylim(top=1.18 * peak)
    axes.annotate("", (0.5, peak), (0.5, centre), arrowprops={"arrowstyle": "-", "color": style.GREY, "linewidth": 0.8})
    axes.text(0.5, 1.02 * peak, f"dip {100.0 * depth:.3g} %", ha="center", va="bottom", fontsize=7, color=style.GREY)
