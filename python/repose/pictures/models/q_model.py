# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The q-model: distribution of weights in the last layer, or their variance against depth, with the exact results."""

from matplotlib.figure import Figure

from repose import style
from repose.pictures.models import captions


def draw(prediction):
    """Figure of either output of the q-model."""
    figure = Figure(figsize=(4.6, 3.3))
    axes = figure.subplots()
    by_layer = "layer" in prediction.columns
    (_variance if by_layer else _distribution)(axes, prediction)
    axes.legend(loc="lower right" if by_layer else "upper right", borderaxespad=0.6)
    captions.fit_below(figure, captions.add(figure, prediction.model))
    return figure


def _points(axes, x, y, error):
    drawing = dict(fmt="o", markersize=2.2, linewidth=0.7, color=style.BLUE, markeredgewidth=0)
    axes.errorbar(x, y, error, label="simulation ± standard error", **drawing)


def _distribution(axes, prediction):
    _points(axes, prediction["weight"], prediction["density"], prediction["density_error"])
    if "exact" in prediction.columns:
        axes.plot(prediction["weight"], prediction["exact"], color=style.ORANGE, label="Gamma distribution", zorder=0)
    axes.set(xlabel="weight / mean weight", ylabel="probability density")
    axes.set_ylim(bottom=0.0)
    axes.set_xlim(left=0.0)


def _variance(axes, prediction):
    layers = prediction["layer"]
    every = sorted({round(1.12**k) for k in range(200) if 1.12**k <= len(layers)})
    rows = [k - 1 for k in every]  # evenly spaced on the logarithmic axis
    variance, error = prediction["variance"][rows], prediction["variance_error"][rows]
    _points(axes, layers[rows], variance, error)
    axes.plot(layers, prediction["exact"], color=style.ORANGE, label="exact recursion", zorder=0)
    axes.set(xlabel="layer", ylabel="variance of a weight / mean²", xscale="log")
    axes.set_ylim(bottom=0.0)
