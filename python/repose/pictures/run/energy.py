# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Approach of a run to rest: kinetic energy per grain, number of grains, force residual."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullLocator

from repose import style
from repose.errors import NotDrawn


def draw(run, state):
    """Figure of the time series of the whole run."""
    if state.frame:
        raise NotDrawn("it shows the whole run, not a frame")
    series = run.series
    if len(series.get("time", ())) < 2:
        raise NotDrawn("the time series has fewer than two rows")
    energy, residual = (_positive(series[name]) for name in ("kinetic_energy_per_grain", "force_residual"))
    if not np.isfinite(energy).any():
        raise NotDrawn("nothing moved")
    panels = 2 if np.isfinite(residual).any() else 1
    figure = Figure(figsize=(5.2, 2.4 + 1.4 * (panels - 1)))
    rows = figure.subplots(panels, 1, sharex=True, squeeze=False)[:, 0]

    rows[0].semilogy(series["time"], energy, color=style.BLUE, linewidth=0.9)
    units = style.units_of(run)
    rows[0].set_ylabel(units.energy("kinetic energy\nper grain"), color=style.BLUE)
    grains = rows[0].twinx()
    grains.plot(series["time"], series["grains"], color=style.GREY, linewidth=1.0, linestyle="--")
    grains.set_ylim(0, 1.05 * max(1, series["grains"].max()))
    grains.set_ylabel("moving grains (dashed)", color=style.GREY)
    grains.spines["right"].set_visible(True)
    if panels == 2:
        rows[1].semilogy(series["time"], residual, color=style.ORANGE, linewidth=0.6)
        rows[1].set_ylabel("force residual\n(mean contact forces)" if units.weightless else "force residual\n(grain weights)", color=style.ORANGE)
    for axes in rows:
        axes.yaxis.set_major_locator(LogLocator(numticks=6))
        axes.yaxis.set_minor_locator(NullLocator())
    rows[-1].set_xlabel(units.time("t"))
    figure.align_ylabels(rows)
    style.fit(figure)
    return figure


def _positive(values):
    """Values that a logarithmic axis can show; NaN for the others."""
    return np.where(values > 0.0, values, np.nan)
