# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The q-model: distribution of weights in the last layer, or their variance by depth, beside what is exact."""

import textwrap

from matplotlib.figure import Figure

from repose import style


def _settings(model):
    """Name and parameters in lines that fit."""
    short = ((p.name, p.value) for p in model.parameters)
    short = (f"{name} = {float(value):.4g}" if "." in value else f"{name} = {value}" for name, value in short)
    text = ", ".join(setting.replace(" ", "\N{NO-BREAK SPACE}") for setting in short)
    return "\n".join(textwrap.wrap(f"{model.name}: {text}", 84))


def draw(prediction):
    """Figure of either output of the q-model."""
    figure = Figure(figsize=(4.6, 3.3))
    axes = figure.subplots()
    by_layer = "layer" in prediction.columns
    (_variance if by_layer else _distribution)(axes, prediction)
    axes.legend(loc="lower right" if by_layer else "upper right", borderaxespad=0.6)
    figure.tight_layout(pad=0.4, rect=(0.0, 0.0, 1.0, 0.86))
    style.caption(figure, _settings(prediction.model))
    return figure


def _points(axes, x, y, error, label):
    axes.errorbar(
        x, y, error, fmt="o", markersize=2.2, linewidth=0.7, color=style.BLUE, markeredgewidth=0, label=label
    )


def _distribution(axes, prediction):
    _points(axes, prediction["weight"], prediction["density"], prediction["density_error"], "runs ± standard error")
    if "exact" in prediction.columns:
        axes.plot(prediction["weight"], prediction["exact"], color=style.ORANGE, label="Gamma distribution", zorder=0)
    axes.set(xlabel="weight / mean weight", ylabel="probability density")
    axes.set_ylim(bottom=0.0)
    axes.set_xlim(left=0.0)


def _variance(axes, prediction):
    layers = prediction["layer"]
    every = sorted({round(1.12**k) for k in range(200) if 1.12**k <= len(layers)})
    rows = [k - 1 for k in every]  # evenly on the logarithm
    _points(
        axes, layers[rows], prediction["variance"][rows], prediction["variance_error"][rows], "runs ± standard error"
    )
    axes.plot(layers, prediction["exact"], color=style.ORANGE, label="exact recursion", zorder=0)
    axes.set(xlabel="layer", ylabel="variance of a weight / mean²", xscale="log")
    axes.set_ylim(bottom=0.0)
