# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Panel of the pressure below conical heaps by rings: means of points over their heaps, and models of cones of the same
load and radius."""

import numpy as np

from repose import style
from repose.errors import NotDrawn
from repose.pictures.error_band import draw_with_error_band

LOADED = 0.9  # of the radius of a full cone: within it lies the load that ends a measured profile


def draw(axes, study, panel):
    """Mean pressure over the heaps of each point, in units of the mean pressure within the loaded radius R of a heap,
    against r/R; the band is the standard error between heaps."""
    points = panel["points"]
    for k, (point, label) in enumerate(zip(points, panel.get("labels", points))):
        at, pressures = _profiles(study, point)
        count = len(pressures)
        error = pressures.std(axis=0, ddof=1) / np.sqrt(count) if count > 1 else np.zeros(len(at))
        draw_with_error_band(axes, at, pressures.mean(axis=0), error, style.SERIES[k % len(style.SERIES)], label)
    for k, wanted in enumerate(panel.get("models", [])):
        from repose import theory  # here: pressures are drawn without the compiled part of the package too

        at, pressure = relative(theory.predict(wanted["model"], **wanted.get("set", {})))
        colour = style.SERIES[(len(points) + k) % len(style.SERIES)]
        axes.plot(at, pressure, "--", color=colour, linewidth=1.2, zorder=3, label=wanted.get("label", wanted["model"]))
    axes.set(xlim=(0.0, 1.2), xlabel="r / loaded radius", ylabel="pressure / mean pressure")
    axes.set_ylim(bottom=0.0)
    axes.legend(loc="best")


def relative(prediction):
    """r over the loaded radius, and the normal stress over its mean within that radius, of a model of a cone."""
    r, normal = prediction["r_over_R"], prediction["normal"]
    inside = np.linspace(0.0, LOADED, 2001)
    mean = np.trapz(np.interp(inside, r, normal) * inside, inside) * 2.0 / LOADED**2
    return r / LOADED, normal / mean


def _profiles(study, point):
    """A grid of r/R, and the relative pressures of each heap on it."""
    profiles = []
    for run in study.runs(point):
        rings = run.analysis["base_rings"] if run.analysis else None
        radius = (run.summary.get("base_dip") or {}).get("loaded_radius")
        if rings is None or not radius:
            continue
        load = np.interp(radius, np.append(0.0, rings["outer"]), np.append(0.0, rings["load"]))
        profiles.append((rings["r"] / radius, rings["pressure"] * np.pi * radius**2 / load))
    if not profiles:
        raise NotDrawn(f"{point}: the pressure on the base was not measured by rings")
    step = np.median([np.diff(at).mean() for at, _ in profiles if len(at) > 1])
    grid = np.arange(0.5 * step, 1.2, step)
    return grid, np.array([np.interp(grid, at, pressure, right=0.0) for at, pressure in profiles])
