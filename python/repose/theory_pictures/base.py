# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Normal and shear force of a pile on its base, by a model."""

from matplotlib.figure import Figure

from repose import style


def draw(prediction):
    """Figure of a prediction with columns x_over_b, normal and shear."""
    figure = Figure(figsize=(4.6, 3.4))
    upper, lower = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [2, 1]})
    for axes, name, colour in ((upper, "normal", style.BLUE), (lower, "shear", style.ORANGE)):
        axes.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
        axes.plot(prediction["x_over_b"], prediction[name], color=colour, linewidth=1.4)
        axes.set_ylabel(f"{name}\n({prediction.unit(name)})")
    lower.set_xlabel("x / B")
    lower.set_xlim(0.0, 1.0)
    figure.align_ylabels()
    figure.tight_layout(pad=0.4, rect=(0.0, 0.0, 1.0, 0.94))
    style.caption(figure, style.settings(prediction.model))
    return figure
