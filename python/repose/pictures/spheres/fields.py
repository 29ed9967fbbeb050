# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Fields about the axis of a heap or column of spheres, in (r, z): density, solid fraction and components of the stress."""

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import analysis_table

PANELS = (
    ("solid_fraction", "solid fraction"),
    ("density", "density"),
    ("stress_zz", "σzz"),
    ("stress_rr", "σrr"),
    ("stress_tt", "σφφ"),
    ("stress_rz", "σrz"),
)
WIDTH, PANEL, BAR = 6.3, 2.65, 0.55  # inch: of the figure and a panel, and the height of a colour bar with its words
LEAST = 0.05  # solid fraction below which nothing is drawn: a few grains about the surface or beyond the base
LARGEST = 99.0  # percentile of the magnitudes that the colours span


def draw(run, state):
    """Figure of the last state."""
    table = analysis_table(run, state, "axial_fields", "there is no heap")
    filled = np.nan_to_num(table["solid_fraction"]) >= LEAST
    if not filled.any():
        raise NotDrawn("there is no heap")
    units = style.units_of(run)
    r, z = edges(table["r"]), edges(table["z"])
    shape = (r[-1] - r[0]) / (z[-1] - z[0])
    high = min(max(PANEL / shape, 0.6), 3.2)
    figure = Figure(figsize=(WIDTH, 3.0 * (high + BAR) + 0.6))
    grid = figure.subplots(3, 2, sharex=True, sharey=True)
    for axes, (name, label) in zip(grid.flat, PANELS):
        values = np.ma.masked_where(~filled | ~np.isfinite(table[name]), table[name])
        title = label if name == "solid_fraction" else units.density(label) if name == "density" else units.stress(label)
        shown = axes.pcolormesh(r, z, values, rasterized=True, **_scale(name, values))
        axes.set_aspect("equal", adjustable="box")
        bar = figure.colorbar(shown, ax=axes, orientation="horizontal", location="top", **_bar_of(high))
        bar.outline.set_linewidth(0.4)
        bar.ax.tick_params(labelsize=6, length=2, pad=1.5)
        bar.ax.locator_params(axis="x", nbins=6)
        bar.set_label(title, fontsize=7, labelpad=3)
        axes.locator_params(nbins=5)
    for axes in grid[-1]:
        axes.set_xlabel(units.length("r"))
    for axes in grid[:, 0]:
        axes.set_ylabel(units.length("z"))
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - 0.2 / figure.get_figheight()), h_pad=0.5, w_pad=1.0)
    style.caption(figure, "means over the azimuth; compression positive")
    return figure


def _bar_of(high):
    """Place of a colour bar above a panel that is `high` [inch]."""
    whole = high + BAR
    return {"fraction": 0.1 / whole, "pad": 0.06 / whole, "aspect": PANEL / 0.1}


def edges(centres):
    """Edges of cells of one width about their centres."""
    half = 0.5 * (centres[1] - centres[0]) if len(centres) > 1 else centres[0]
    return np.append(centres - half, centres[-1] + half)


def _scale(name, values):
    """Colours and their ends: about zero where a field has both signs."""
    some = values.compressed()
    if len(some) == 0:
        return {}
    if name in ("solid_fraction", "density"):
        return {"cmap": style.PACKING, "norm": Normalize(0.0, max(some.max(), 1e-300))}
    largest = np.percentile(np.abs(some), LARGEST) or 1.0
    if name == "stress_rz" or np.percentile(some, 2.0) < -0.05 * largest:
        return {"cmap": "PuOr", "norm": Normalize(-largest, largest)}
    return {"cmap": style.LOAD, "norm": Normalize(0.0, largest)}
