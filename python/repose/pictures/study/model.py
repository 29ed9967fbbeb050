# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Panels of stress models: columns of their predictions over each other."""

from repose import style
from repose.errors import NotDrawn

STYLES = ("-", "--", "-.", ":")


def draw(axes, study, panel):
    """A line for each curve; columns of words are refused."""
    from repose import theory  # here: pictures of runs need no compiled part of the package

    for k, curve in enumerate(panel["curves"]):
        try:
            prediction = theory.predict(curve["model"], **curve.get("set", {}))
            x, y = prediction[curve["x"]], prediction[curve["y"]]
        except (ValueError, KeyError) as error:
            raise NotDrawn(f"{curve['model']}: {' '.join(str(error).split())}") from error
        drawing = dict(color=style.SERIES[k % len(style.SERIES)], linestyle=STYLES[k // len(style.SERIES) % len(STYLES)])
        if len(x) < 2:
            axes.plot(x, y, "o", markersize=4, label=curve.get("label"), color=drawing["color"])
        else:
            axes.plot(x, y, linewidth=1.2, label=curve.get("label"), **drawing)
    axes.set_xlabel(panel.get("xlabel", ""))
    axes.set_ylabel(panel.get("ylabel", ""))
    if "xlim" in panel:
        axes.set_xlim(*panel["xlim"])
    if "ylim" in panel:
        axes.set_ylim(*panel["ylim"])
    if any("label" in curve for curve in panel["curves"]):
        axes.legend(loc="best")
