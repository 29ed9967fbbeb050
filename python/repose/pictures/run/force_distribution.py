# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Distribution of normal forces over their mean, P(f), beside the exponential of the same mean above the same threshold."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import NO_FORCES, analysis_table

FRACTIONS = (("strong_fraction", "above the mean"), ("sliding_fraction", "sliding"))  # keys of summary.json: forces


def draw(run, state):
    """Figure of the contacts of the last state above the force threshold."""
    forces = analysis_table(run, state, "forces", NO_FORCES)
    some = forces["density"] > 0.0
    if not some.any():
        raise NotDrawn(NO_FORCES)
    f, density, error = (forces[name][some] for name in ("f", "density", "error"))
    figure = Figure(figsize=(4.2, 3.2))
    axes = figure.subplots()
    axes.set_yscale("log", nonpositive="clip")
    half = 0.5 * forces.attributes["bin_width"]
    least = max(0.0, forces["f"][0] - half)  # the bins begin at the threshold
    guide = np.array([least, f[-1] + half])
    label = "exponential of the same mean" + (" above the threshold" if least > 0.0 else "")
    axes.plot(guide, exponential(guide, least), color=style.GREY, linewidth=0.9, linestyle="--", label=label)
    if least > 0.0:
        axes.axvline(least, color=style.GREY, linewidth=0.6, linestyle=":", label="force threshold")
    axes.errorbar(
        f, density, yerr=error, fmt="o", color=style.BLUE, markersize=3, elinewidth=0.8, label="normal forces"
    )
    axes.set_ylim(0.4 * density.min(), 2.5 * max(density.max(), 1.0))
    axes.set_xlim(0.0, guide[1])
    axes.set_xlabel("f = normal force / mean normal force")
    axes.set_ylabel("probability density P(f)")
    axes.legend(loc="upper right")
    style.fit(figure, (0.0, 0.0, 1.0, 0.94))
    style.caption(figure, "bars: √(count); " + _mean_and_fractions(forces, run))
    return figure


def exponential(f, least):
    """The density of mean 1 that falls exponentially from `least` on."""
    return np.exp(-(f - least) / (1.0 - least)) / (1.0 - least)


def _mean_and_fractions(forces, run):
    mean = forces.attributes["mean"]
    if run.attributes["dimension"] == 3:  # there it is in M L/T^2
        mean = mean / (run.attributes["grain_weight"] or 1.0)
    parts = [f"mean {mean:.3g} {style.units_of(run).force_word()}"] if np.isfinite(mean) else []
    known = run.summary.get("forces") or {}
    parts += [f"{100.0 * known[key]:.1f} % {name}" for key, name in FRACTIONS if known.get(key) is not None]
    return "; ".join(parts)
