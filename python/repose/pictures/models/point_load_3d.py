# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Elastic response to a point load in three dimensions."""

from matplotlib.figure import Figure

from repose import style
from repose.pictures.models import captions

STRESSES = (
    ("vertical", "σzz", style.BLUE),
    ("shear", "σrz", style.ORANGE),
    ("radial", "σrr", style.GREEN),
    ("hoop", "σφφ", style.INK),
)


def draw(prediction):
    """Stresses at the depth h; below, the vertical one over its peak beside that of a line load."""
    figure = Figure(figsize=(4.6, 4.6))
    stresses, shape = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [3, 2]})
    r = prediction["r_over_h"]
    for name, symbol, colour in STRESSES:
        if name in prediction.columns:
            stresses.plot(r, prediction[name], color=colour, linewidth=1.3, label=f"{name} {symbol}")
    stresses.set_ylabel("stress at depth h (F / h²)")
    stresses.legend(loc="upper right", borderaxespad=0.3)
    for name, width, colour, label in (
        ("vertical", "half_width", style.BLUE, "point load"),
        ("plane", "plane_half_width", style.GREY, "line load"),
    ):
        shape.plot(r, prediction[name] / prediction[name][0], color=colour, linewidth=1.3, label=label)
        shape.plot([prediction[width]], [0.5], "o", color=colour, markersize=3.5)
    for axes in (stresses, shape):
        axes.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
    shape.set(xlabel="r / h", ylabel="σzz / peak", xlim=(0.0, r[-1]))
    shape.legend(loc="upper right", borderaxespad=0.3)
    figure.align_ylabels()
    captions.fit_below(figure, captions.add(figure, prediction.model, leave_out=("points",)))
    return figure
