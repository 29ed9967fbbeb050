# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The response to a point load by three kinds of theory."""

import textwrap

from matplotlib.figure import Figure

from repose import style

CURVES = (("elastic", style.BLUE, "elastic"), ("osl", style.ORANGE, "OSL"), ("diffusive", style.GREEN, "diffusive"))


def _settings(model):
    """Name and parameters in lines that fit."""
    short = ((p.name, p.value) for p in model.parameters)
    short = (f"{name} = {float(value):.4g}" if "." in value else f"{name} = {value}" for name, value in short)
    text = ", ".join(setting.replace(" ", "\N{NO-BREAK SPACE}") for setting in short)
    return "\n".join(textwrap.wrap(f"{model.name}: {text}", 84))


def draw(prediction):
    """Figure of the point-load model."""
    figure = Figure(figsize=(4.6, 3.3))
    axes = figure.subplots()
    for name, colour, label in CURVES:
        if name in prediction.columns:
            axes.plot(prediction["x_over_h"], prediction[name], color=colour, linewidth=1.3, label=label)
    x = prediction["x_over_h"]
    axes.set(xlabel="x / h", ylabel="vertical stress at depth h (F / h)", xlim=(x[0], x[-1]))
    axes.set_ylim(bottom=0.0)
    axes.legend(loc="upper right", borderaxespad=0.3)
    figure.tight_layout(pad=0.4, rect=(0.0, 0.0, 1.0, 0.86))
    style.caption(figure, _settings(prediction.model))
    return figure
