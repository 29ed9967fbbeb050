# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Panels of the force on the base: mean profiles of points, and models of base forces of the same weight and width."""

import numpy as np

from repose import style
from repose.errors import NotDrawn
from repose.pictures.error_band import draw_with_error_band


def draw(axes, study, panel):
    """Mean profiles over the members; dots are single base grains."""
    component = panel.get("component", "normal")
    to_largest = panel.get("scale") == "largest"
    by_fraction = panel.get("x") == "fraction"
    points = panel["points"]
    labels = panel.get("labels", points)
    axes.axhline(0.0, color=style.FAINT, linewidth=0.6, zorder=0)
    for k, (point, label) in enumerate(zip(points, labels)):
        profile = study.sweep.profiles[study.row(point)]
        if profile is None:
            raise NotDrawn(f"{point}: has no base profile")
        colour = style.SERIES[k % len(style.SERIES)]
        centre, half = profile.attributes["centre"], profile.attributes["half_width"]
        place = (lambda x, c=centre, h=half: 0.5 + 0.5 * (x - c) / h) if by_fraction else (lambda x: x)
        scale = np.nanmax(np.abs(profile.binned[component])) if to_largest else 1.0
        if panel.get("dots", True):
            drawing = dict(color=style.pale(colour, 0.5), markersize=1.8, markeredgewidth=0, zorder=1.5)
            axes.plot(place(profile["x"]), profile[component] / scale, "o", **drawing)
        bins = profile.binned
        error = np.nan_to_num(bins[f"{component}_error"]) / scale
        draw_with_error_band(axes, place(bins["x"]), bins[component] / scale, error, colour, label)
        if k == 0:
            _draw_models(axes, panel, profile, component, scale, place, len(points))
    profiles = [study.sweep.profiles[study.row(point)].attributes for point in points]
    if by_fraction:
        axes.set_xlim(-0.05, 1.05)
        axes.set_xlabel("x / base")
    else:
        ends = [each["centre"] + side * 1.2 * each["half_width"] for each in profiles for side in (-1.0, 1.0)]
        axes.set_xlim(min(ends), max(ends))
        axes.set_xlabel(style.units_of(study.sweep).length("x"))
    axes.set_ylabel(f"{component} force / largest" if to_largest else f"{component} force on a base grain\n(grain weights)")
    if "ylim" in panel:
        axes.set_ylim(*panel["ylim"])
    if len(points) > 1 or panel.get("models"):
        axes.legend(loc="best")


def _draw_models(axes, panel, profile, component, scale, place, first_colour):
    """Each model over the loaded base of the profile, with the same weight."""
    for k, wanted in enumerate(panel.get("models", [])):
        from repose import theory  # here: profiles are drawn without the compiled part of the package too

        prediction = theory.predict(wanted["model"], **wanted.get("set", {}))
        x, normal = prediction["x_over_b"], prediction["normal"]
        drawing = dict(color=style.SERIES[(first_colour + k) % len(style.SERIES)], linewidth=1.2, linestyle="--", zorder=3)
        discs = profile["x"][np.abs(profile["x"] - profile.attributes["centre"]) <= profile.attributes["half_width"] * (1.0 + 1e-9)]
        if len(discs) == len(x):  # a row for each disc, in grain weights
            at, weight = discs, 1.0
        else:
            left, width, weight = _matched(profile, x, normal)
            at = left + width * x
        axes.plot(place(at), weight * prediction[component] / scale, label=wanted.get("label", wanted["model"]), **drawing)


def _matched(profile, x, normal):
    """Left end and width of the base of a model, and its factor, for the weight and the loaded interval of a profile: the
    interval ends where the force has a tenth of its maximum."""
    above = np.flatnonzero(normal > 0.1 * normal.max())
    low, high = x[above[0]], x[above[-1]]
    width = 2.0 * profile.attributes["half_width"] / (high - low)
    left = profile.attributes["centre"] - profile.attributes["half_width"] - low * width
    spacing = np.median(np.diff(profile["x"]))
    return left, width, profile["normal"].sum() * spacing / (np.trapz(normal, x) * width)
