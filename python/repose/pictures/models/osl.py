# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Stresses of a wedge under oriented stress linearity: on the base, or in the pile."""

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from matplotlib.tri import Triangulation

from repose import style
from repose.pictures.models import base

STRESSES = (("normal", "σzz"), ("shear", "σxz"), ("horizontal", "σxx"))
LEVELS = 16  # colours
CROSSES = 10  # depths at which principal axes are drawn


def draw(prediction):
    """Figure of a prediction of `osl`: of the field, or of the base."""
    return _field(prediction) if "x_over_h" in prediction.columns else _base(prediction)


def _title(prediction):
    """Closure and angles; a slope that is the friction angle is left out."""
    model = prediction.model
    closure = model.value("model")
    words = [closure if closure == "custom" else closure.upper(), f"friction angle {float(model.value('angle_deg')):g}°"]
    if model.value("slope_deg") != "angle_deg":
        words.append(f"slope {float(model.value('slope_deg')):g}°")
    if closure == "custom":
        words.append(f"μ = {prediction['mu']:.4g}, η = {prediction['eta']:.4g}".replace("-", "−"))
    return f"{model.name}: {', '.join(words)}"


def _lay_out(figure, caption):
    figure.get_layout_engine().set(rect=(0.0, 0.0, 1.0, 1.0 - 0.25 / figure.get_size_inches()[1]))
    style.caption(figure, caption)


def _base(prediction):
    figure = Figure(figsize=(4.6, 4.4), layout="constrained")
    stresses, margin = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [3, 1]})
    stresses.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
    for (name, symbol), colour in zip(STRESSES, (style.BLUE, style.ORANGE, style.GREEN)):
        stresses.plot(prediction["x_over_b"], prediction[name], color=colour, linewidth=1.4, label=f"{name} {symbol}")
    base.mark_dip(stresses, prediction)
    stresses.set_ylabel("stress / ρgh")
    stresses.legend(loc="lower center", bbox_to_anchor=(0.5, 1.01), ncols=3)
    margin.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
    margin.plot(prediction["x_over_b"], prediction["yield_margin"], color=style.GREY, linewidth=1.2)
    lowest = prediction["yield_margin"].min()
    if lowest < -1e-9:
        below = np.minimum(prediction["yield_margin"], 0.0)
        margin.fill_between(prediction["x_over_b"], below, color=style.pale(style.ORANGE, 0.25), linewidth=0, zorder=0.8)
    margin.set_ylim(min(1.1 * lowest, -0.08), 1.05)
    margin.set_ylabel("yield margin")
    margin.set_xlabel("x / B")
    margin.set_xlim(0.0, 1.0)
    figure.align_ylabels()
    _lay_out(figure, _title(prediction))
    return figure


def _field(prediction):
    x, z = prediction["x_over_h"], prediction["z_over_h"]
    foot = x.max()
    panel = min(max(1.65 / foot, 0.7), 2.0)  # inch, the height at which the pile fills the width of the figure
    figure = Figure(figsize=(4.4, 3 * panel + 0.9), layout="constrained")
    panels = figure.subplots(3, 1, sharex=True)
    triangles = Triangulation(x, -z, _triangles(int(round(1.0 / z.min()))))
    for axes, (name, symbol) in zip(panels, STRESSES):
        signed = name == "shear"
        most = np.abs(prediction[name]).max()
        colours = axes.tricontourf(
            triangles,
            prediction[name],
            levels=np.linspace(-most if signed else 0.0, most, LEVELS + 1),
            cmap="PuOr_r" if signed else style.LOAD,
        )
        axes.plot([-foot, 0.0, foot, -foot], [-1.0, 0.0, -1.0, -1.0], color=style.INK, linewidth=0.7)
        axes.set_aspect("equal")
        axes.set_ylabel("z / h")
        axes.set_yticks([0.0, -0.5, -1.0], ["0", "0.5", "1"])
        bar = figure.colorbar(colours, ax=axes, fraction=0.03, pad=0.02)
        bar.ax.yaxis.set_major_locator(MaxNLocator(4))
        bar.set_label(f"{symbol} / ρgh")
        bar.outline.set_linewidth(0.4)
        kink = prediction["s_inner"]
        if np.isfinite(kink):
            drawing = dict(color=style.GREY, linewidth=0.6, linestyle=(0, (4, 3)))
            for side in (-1.0, 1.0):
                axes.plot([0.0, side * kink * foot], [0.0, -1.0], **drawing)
    _crosses(panels[0], prediction)
    panels[-1].set_xlabel("x / h")
    dashed = "; dashed: the kink" if np.isfinite(prediction["s_inner"]) else ""
    _lay_out(figure, f"{_title(prediction)}; crosses: principal axes{dashed}")
    return figure


def _triangles(grid):
    """Triangles (n, 3) between the points of a field whose row i has 2 i + 1 points."""
    first = np.arange(1, grid + 2) ** 2 - 1  # point of each row
    triangles = []
    for i in range(1, grid):
        above = first[i - 1] + np.arange(2 * i + 1)
        below = first[i] + np.arange(2 * i + 3)
        triangles.append([[above[0], below[0], below[1]]])  # at the left surface
        triangles.append(np.stack([above, below[1:-1], below[2:]], axis=1))
        triangles.append(np.stack([above[:-1], above[1:], below[2:-1]], axis=1))
    return np.concatenate(triangles)


def _crosses(axes, prediction):
    """Principal axes at some points of the field; their lengths are the square roots of the stresses along them."""
    grid = int(round(1.0 / prediction["z_over_h"].min()))
    stride = max(1, grid // CROSSES)
    row = np.round(prediction["z_over_h"] * grid).astype(int)
    foot = prediction["x_over_h"].max()
    place = np.round(prediction["x_over_h"] / foot * grid).astype(int)
    chosen = (row % stride == stride // 2) & (place % stride == 0) & (np.abs(place) < row)
    normal, shear, across = (prediction[name][chosen] for name, _ in STRESSES)
    centre = np.stack([prediction["x_over_h"][chosen], -prediction["z_over_h"][chosen]], axis=1)
    angle = 0.5 * np.arctan2(2.0 * shear, normal - across)  # from the downward vertical to the major axis
    mean, radius = 0.5 * (normal + across), np.hypot(0.5 * (normal - across), shear)
    major = np.stack([np.sin(angle), -np.cos(angle)], axis=1)
    minor = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    length = 0.55 * stride / grid
    for direction, stress, width in ((major, mean + radius, 0.9), (minor, mean - radius, 0.5)):
        half = direction * (length * np.sqrt(np.maximum(stress, 0.0)))[:, None]
        axes.add_collection(
            LineCollection(np.stack([centre - half, centre + half], axis=1), colors=style.INK, linewidths=width)
        )
