# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Surface of a packing, its roughness against the width of a window, and the growth of the roughness."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from repose import style
from repose.pictures.run.analysis_parts import measured_packing


def draw(run, state):
    """Figure of the last state."""
    parts = measured_packing(run, state, "surface").parts
    units = style.units_of(run)
    figure = Figure(figsize=(6.3, 4.0))
    profile, left, right = figure.subplot_mosaic([["profile", "profile"], ["roughness", "growth"]]).values()
    surface = parts["surface"]
    profile.plot(surface["x"], surface["height"], color=style.BLUE, linewidth=0.9, drawstyle="steps-mid")
    profile.set(xlabel=units.length("x"), ylabel=units.length("height of the surface"))
    roughness, growth = parts["roughness"], parts["growth"]
    _scaling(left, roughness, "window", "α")
    left.set(xlabel=units.length("window"), ylabel=units.length("rms height"))
    _scaling(right, growth, "deposited", "β")
    right.set(xlabel="grains deposited", ylabel=units.length("rms height"))
    style.fit(figure, (0.0, 0.0, 1.0, 0.97), h_pad=0.8, w_pad=1.0)
    style.caption(figure, "height: highest point of the grains in each column")
    return figure


def _scaling(axes, table, along, symbol):
    """The rms height against `along` on logarithmic axes, with the power law of the fitted exponent."""
    place, width = table[along], table["width"]
    some = (width > 0.0) & (place > 0)
    axes.set_xscale("log")
    axes.set_yscale("log")
    for side in (axes.xaxis, axes.yaxis):
        side.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        side.set_major_formatter("{x:g}")
        side.set_minor_formatter(NullFormatter())
    axes.plot(place[some], width[some], "o", color=style.BLUE, markersize=3)
    exponent, error = table.attributes["exponent"], table.attributes["exponent_error"]
    if not np.isfinite(exponent) or not some.any():
        return
    middle = np.exp(np.mean(np.log(place[some]))), np.exp(np.mean(np.log(width[some])))
    bounds = f" ± {error:.2f}" if np.isfinite(error) else ""
    line = middle[1] * (place[some] / middle[0]) ** exponent
    axes.plot(place[some], line, color=style.ORANGE, linewidth=0.9, label=f"{symbol} = {exponent:.2f}{bounds}")
    axes.legend(loc="upper left")
