# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The standard pictures of a run: each takes a RunFolder and a State and returns a figure, or says why there is none."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D

from repose import style
from repose.discs import centre_lines, draw_discs, draw_lines, draw_planes


class NotDefined(Exception):
    """This run has nothing that the picture could show."""


def heap(run, state):
    """The grains, the base, and the lines whose slopes are the angles of repose."""
    if len(state.id) == 0:
        raise NotDefined("there are no grains")
    window = style.heap_window(run, state)
    figure, axes = style.heap_axes(run, window)
    near = style.inside(state, window, float(run.attribute("grain_diameter")))
    draw_discs(axes, state, near & ~state.fixed, style.PALE, style.BLACK)
    draw_discs(axes, state, near & state.fixed, style.GREY, style.BLACK)
    draw_planes(axes, run, window)
    is_last = state.time == float(run.attribute("time"))
    if run.has("surface") and is_last:
        _surface_lines(axes, run)
    axes.set_title(style.time_text(run, state), fontsize=9, loc="left")
    return figure


def _surface_lines(axes, run):
    surface = run.file["surface"]
    base = float(surface.attrs["base_y"])
    used = surface["used"][()].astype(bool)
    x, height = surface["x"][()], surface["height"][()]
    apex = float(surface.attrs["apex_x"])
    for side, chosen in (("left", used & (x < apex)), ("right", used & (x > apex))):
        slope = float(surface.attrs[f"{side}_slope"])
        if not np.isfinite(slope) or not chosen.any():
            continue
        ends = np.array([x[chosen].min(), x[chosen].max()])
        angle = np.degrees(np.arctan(slope if side == "left" else -slope))
        axes.plot(
            ends,
            base + slope * ends + float(surface.attrs[f"{side}_intercept"]),
            color=style.ORANGE if side == "left" else style.BLUE,
            linewidth=1.6,
            label=f"{side} flank {angle:.1f}°",
        )
    if axes.get_legend_handles_labels()[0]:
        axes.plot(x[used], base + height[used], ".", color=style.BLACK, markersize=3, label="bins of the fit")
        axes.legend(loc="upper right")


def density(run, state):
    """Centre-to-centre vectors of all pairs in reach of each other: lighter regions are looser (Baxter et al., Fig. 2)."""
    lines, _ = centre_lines(run, state)
    if len(lines) == 0:
        raise NotDefined("no grains touch")
    window = style.heap_window(run, state)
    figure, axes = style.heap_axes(run, window)
    draw_lines(axes, lines, colors=style.BLACK, linewidths=_width_for(window, 0.12))
    draw_planes(axes, run, window)
    axes.set_title(style.time_text(run, state), fontsize=9, loc="left")
    return figure


def _width_for(window, diameters):
    """Line width in points of a length of so many units of the window."""
    return diameters * 72.0 * style.WIDTH / (window[1] - window[0])


def forces(run, state):
    """Force network: lines between centres, as wide as the normal force is large; sliding contacts in colour."""
    lines, number = centre_lines(run, state)
    if len(lines) == 0 or not (state.normal_force > 0).any():
        raise NotDefined("no contact carries a force")
    window = style.heap_window(run, state)
    diameter = float(run.attribute("grain_diameter"))
    figure, axes = style.heap_axes(run, window, extra_height=0.25)
    near = style.inside(state, window, diameter)
    draw_discs(axes, state, near & ~state.fixed, "#f3f4f6", "#d4d8dd", 0.25)
    draw_discs(axes, state, near & state.fixed, "#d4d8dd", "#b8bec6", 0.25)
    draw_planes(axes, run, window)
    weight = float(run.attribute("grain_weight"))
    unit = weight if weight > 0 else 1.0
    force = state.normal_force[number] / unit
    largest = np.percentile(force[force > 0], 99.5)
    full = _width_for(window, 0.8 * diameter)
    for chosen, colour in ((~state.sliding[number], style.BLACK), (state.sliding[number], style.ORANGE)):
        drawn = chosen & (force > 0.01 * largest)
        width = full * np.minimum(force[drawn] / largest, 1.0)
        draw_lines(axes, lines[drawn], colors=colour, linewidths=width)
    scale = _round(largest)
    name = "grain weights" if weight > 0 else "[M L/T²]"
    keys = [
        Line2D([], [], color=style.BLACK, linewidth=full * part * scale / largest, label=f"{part * scale:g} {name}")
        for part in (1.0, 0.5, 0.25)
    ]
    keys.append(Line2D([], [], color=style.ORANGE, linewidth=full * 0.5 * scale / largest, label="sliding"))
    axes.legend(handles=keys, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=4, handlelength=1.5)
    return figure


def _round(value):
    """The largest of 1, 2, 4 times a power of ten that is not above the value."""
    power = 10.0 ** np.floor(np.log10(value))
    return max(step * power for step in (1.0, 2.0, 4.0) if step * power <= value)


def base(run, _state):
    """Normal and shear force on each base grain, averaged over the settled window."""
    if not run.has("base"):
        raise NotDefined("the scene has no row of base grains")
    x, normal, shear = (run.values(f"base/{name}") for name in ("x", "normal", "shear"))
    dip = run.summary().get("base_dip") or {}
    figure, axes = plt.subplots(figsize=(style.WIDTH, 3.2))
    for values, colour, name in ((normal, style.BLUE, "normal"), (shear, style.ORANGE, "shear")):
        axes.plot(x, values, "o", color=colour, markersize=2.5, markerfacecolor="none", markeredgewidth=0.6)
        axes.plot(x, _running_mean(values, 5), "-", color=colour, linewidth=1.4, label=f"{name}, mean of 5 discs")
    axes.axhline(0.0, color=style.GREY, linewidth=0.6)
    if dip:
        reach = 1.4 * dip["half_width"]
        axes.set_xlim(dip["centre"] - reach, dip["centre"] + reach)
    axes.set_xlabel(run.length_label("x"))
    axes.set_ylabel("force / grain weight")
    start, end = run.attribute("window_start", "base"), run.attribute("window_end", "base")
    index = f", dip index {dip['index']:.2f}" if dip else ""
    axes.set_title(f"base force, mean over t = {start:.6g} to {end:.6g}{index}", fontsize=9, loc="left")
    axes.legend(loc="upper right")
    return figure


def _running_mean(values, count):
    """Mean over `count` neighbours, shorter at the ends."""
    kernel = np.ones(count)
    return np.convolve(values, kernel, "same") / np.convolve(np.ones_like(values), kernel, "same")


def energy(run, _state):
    """Kinetic energy per grain and number of grains over time; below, how far the forces are from balance."""
    time = run.values("series/time")
    if len(time) == 0:
        raise NotDefined("nothing was recorded yet")
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(style.WIDTH, 4.2), sharex=True)
    kinetic = run.values("series/kinetic_energy_per_grain")
    upper.plot(time, np.where(kinetic > 0, kinetic, np.nan), color=style.BLUE, linewidth=0.8)
    upper.set_yscale("log")
    reduced = run.attribute("units") == "reduced"
    upper.set_ylabel("kinetic energy\nper grain / mgσ" if reduced else "kinetic energy\nper grain [J]", color=style.BLUE)
    count = upper.twinx()
    count.spines["right"].set_visible(True)
    count.plot(time, run.values("series/grains"), color=style.ORANGE, linewidth=1.2)
    count.set_ylabel("grains", color=style.ORANGE)
    count.set_ylim(bottom=0)
    residual = run.values("series/force_residual")
    lower.plot(time, np.where(residual > 0, residual, np.nan), color=style.GREEN, linewidth=0.8)
    lower.set_yscale("log")
    lower.set_ylabel("net force on a grain\n/ grain weight")
    lower.set_xlabel(run.time_label())
    return figure


PICTURES = {"heap": heap, "density": density, "forces": forces, "base": base, "energy": energy}
