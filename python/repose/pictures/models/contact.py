# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Laws of a single contact: the spring that does the work of another law, and the graphs of contact dynamics."""

from matplotlib.figure import Figure

from repose import style
from repose.pictures.models import captions


def draw_spring(prediction):
    """Both forces over the distance."""
    figure = Figure(figsize=(4.2, 3.0))
    axes = figure.subplots()
    axes.plot(prediction["distance"], prediction["continuous"], color=style.BLUE, linewidth=1.4, label="continuous interaction")
    label = f"spring, k = {prediction['stiffness']:.4g} mg/σ"
    axes.plot(prediction["distance"], prediction["spring"], color=style.ORANGE, linewidth=1.2, label=label)
    axes.set_xlabel("r / σ")
    axes.set_ylabel("force / mg")
    axes.legend(loc="upper right")
    captions.fit_below(figure, captions.add(figure, prediction.model))
    return figure


def draw_law(prediction):
    """The graph of the law, the line of the impulse, and where they cross."""
    figure = Figure(figsize=(4.2, 3.0))
    axes = figure.subplots()
    axes.axhline(0.0, color=style.FAINT, linewidth=0.6)
    axes.axvline(0.0, color=style.FAINT, linewidth=0.6)
    axes.plot(prediction["velocity"], prediction["law"], color=style.INK, linewidth=1.6, label="law")
    axes.plot(prediction["velocity"], prediction["line"], color=style.BLUE, linewidth=1.0, label="impulse for this velocity")
    answer = prediction["answer_velocity"], prediction["answer_impulse"]
    axes.plot(*answer, "o", color=style.ORANGE, markersize=5, label="answer")
    axes.set_xlabel("formal velocity")
    axes.set_ylabel("impulse")
    axes.legend(loc="best")
    captions.fit_below(figure, captions.add(figure, prediction.model))
    return figure
