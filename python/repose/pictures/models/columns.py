# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Columns between walls: Janssen's law, its discrete form, and fits of the law to measured columns."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from repose import style, theory
from repose.pictures.models import captions

MOST_MARKERS = 60  # cells; above it the force is a line


def draw_janssen(prediction):
    """Stress and apparent mass against depth, with the lines without friction and the values at saturation."""
    figure = Figure(figsize=(4.6, 3.4))
    axes, masses = figure.subplots(1, 2, sharey=True)
    depth = prediction["depth"]
    free = theory.predict("janssen", **{**prediction.model.settings, "friction": "0"})
    for panel, name, label in ((axes, "stress", "vertical stress"), (masses, "apparent_mass", "apparent mass")):
        saturation = prediction["saturation_stress" if name == "stress" else "saturation_mass"]
        panel.plot(free[name], depth, color=style.GREY, linewidth=0.9, dashes=(4, 2), label="no friction")
        panel.plot(prediction[name], depth, color=style.BLUE, linewidth=1.4, label="Janssen")
        if np.isfinite(saturation):
            panel.axvline(saturation, color=style.ORANGE, linewidth=0.9, dashes=(1, 1.5), label="saturation")
        bottom = free[name][-1]
        largest = max(prediction[name].max(), bottom if prediction["lambda"] > depth[-1] else 0.0)
        if np.isfinite(saturation):
            largest = max(largest, min(2.2 * saturation, bottom), 1.05 * saturation)
        panel.set_xlim(0.0, 1.03 * largest)
        panel.set_xlabel(f"{label} ({_power(prediction.unit(name))})")
    axes.set_ylim(depth[-1], 0.0)
    axes.set_ylabel("depth (L)")
    handles, labels = axes.get_legend_handles_labels()
    height = captions.add(figure, prediction.model, leave_out=("points",))
    inches = figure.get_size_inches()[1]
    figure.legend(handles, labels, ncols=3, loc="upper center", bbox_to_anchor=(0.5, 1.0 - height / inches))
    captions.fit_below(figure, height + 0.2)
    return figure


def draw_discrete(prediction):
    """Force against the number of cells, with the continuum of the same friction."""
    figure = Figure(figsize=(4.6, 3.2))
    axes = figure.subplots()
    layer, force = prediction["layer"], prediction["force"]
    settings = prediction.model.settings
    at_rest = settings["direction"] == "rest"
    k_mu = float(settings["k_mu"])
    height, continuum = _janssen(layer[-1], 3.0, k_mu, settings["direction"])  # three grains in a cell
    free = _janssen(layer[-1], 3.0, 0.0, "rest")
    axes.plot(*free, color=style.GREY, linewidth=0.9, dashes=(4, 2), label="no friction")
    axes.plot(height, continuum, color=style.ORANGE, linewidth=1.1, label="continuum, λ₁ = λ₂ = l / 2Kμ")
    few = len(layer) <= MOST_MARKERS
    axes.plot(layer, force, color=style.BLUE, linestyle="none" if few else "-", marker="o" if few else "",
              markersize=3.5, label=f"cells, λ₁/λ₂ = {prediction['ratio']:.5f}", zorder=3)
    axes.set_xlim(0.0, 1.02 * layer[-1])
    top = max(force.max(), continuum.max())
    axes.set_ylim(0.0, min(1.05 * max(top, 3.0 * layer[-1]), 1.6 * top))
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_xlabel("cells above, N (of height l)")
    axes.set_ylabel("force below (m g)")
    saturates = at_rest and 2.0 * k_mu * layer[-1] > 1.5
    axes.legend(loc="lower right" if saturates else "upper left", borderaxespad=0.8)
    captions.fit_below(figure, captions.add(figure, prediction.model))
    return figure


def draw_fit(prediction):
    """Measured masses with the fitted law, and the residuals."""
    figure = Figure(figsize=(4.6, 3.6))
    upper, lower = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [2.4, 1]})
    settings = prediction.model.settings
    at_rest = settings["direction"] == "rest"
    height, mass = prediction["height"], prediction["apparent_mass"]
    error = prediction["apparent_mass_error"] if "apparent_mass_error" in prediction.columns else None
    # Janssen's law of the screening length lambda_2, scaled to saturate as lambda_1 says.
    per_height = float(settings["mass_per_height"]) * prediction["lambda_1"] / prediction["lambda_2"]
    heights, law = _janssen(1.03 * height.max(), per_height, 0.5 / prediction["lambda_2"], settings["direction"])
    drawing = {"fmt": "o", "markersize": 3.5, "color": style.BLUE, "elinewidth": 0.8, "zorder": 3}
    upper.errorbar(height, mass, yerr=error, label="data", **drawing)
    upper.plot(heights, law, color=style.ORANGE, linewidth=1.2, label=_lengths(prediction))
    upper.set_ylim(min(0.0, 1.05 * mass.min()), 1.08 * max(mass.max(), law.max()))
    upper.set_ylabel("apparent mass (M)")
    upper.legend(loc="lower right" if at_rest else "upper left", borderaxespad=0.8)
    lower.axhline(0.0, color=style.ORANGE, linewidth=1.0)
    lower.errorbar(height, prediction["residual"], yerr=error, **drawing)
    lower.set_ylabel("residual (M)")
    lower.set_xlabel("height (L)")
    lower.set_xlim(0.0, heights[-1])
    figure.align_ylabels()
    captions.fit_below(figure, captions.add(figure, prediction.model))
    return figure


def _lengths(prediction):
    def with_error(name):
        error = prediction[f"{name}_error"]
        if not np.isfinite(error) or error <= 0.0:
            return f"{prediction[name]:.5g}"
        digits = max(0, 1 - int(np.floor(np.log10(error))))
        return f"{prediction[name]:.{min(digits, 12)}f} ± {error:.{min(digits, 12)}f}"

    if prediction.model.value("parameters") == "1":
        return f"λ = {with_error('lambda_1')} L"
    return f"λ₁ = {with_error('lambda_1')} L,  λ₂ = {with_error('lambda_2')} L"


def _janssen(height, mass_per_height, k_mu, direction):
    """Heights and apparent masses of a continuous column of width 1 and screening length 1/(2 k_mu)."""
    column = theory.predict("janssen", dimension=2, density=mass_per_height, solid_fraction=1, stress_ratio=k_mu,
                            friction=1, height=height, direction=direction, points=401)  # fmt: skip
    return column["depth"], column["apparent_mass"]


def _power(unit):
    return {"M/(L T^2)": "M L⁻¹ T⁻²", "M/L": "M L⁻¹"}.get(unit, unit)
