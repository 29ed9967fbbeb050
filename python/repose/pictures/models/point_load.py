# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Response to a point load by three kinds of theory."""

from matplotlib.figure import Figure

from repose import style
from repose.pictures.models import captions

CURVES = (("elastic", style.BLUE, "elastic"), ("osl", style.ORANGE, "OSL"), ("diffusive", style.GREEN, "diffusive"))


def draw(prediction):
    """Figure of the stress over the base."""
    figure = Figure(figsize=(4.6, 3.3))
    axes = figure.subplots()
    for name, colour, label in CURVES:
        if name in prediction.columns:
            axes.plot(prediction["x_over_h"], prediction[name], color=colour, linewidth=1.3, label=label)
    x = prediction["x_over_h"]
    axes.set(xlabel="x / h", ylabel="vertical stress at depth h (F / h)", xlim=(x[0], x[-1]))
    axes.set_ylim(bottom=0.0)
    axes.legend(loc="upper right", borderaxespad=0.3)
    captions.fit_below(figure, captions.add(figure, prediction.model))
    return figure
