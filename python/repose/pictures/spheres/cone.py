# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Surface of a conical heap: its mean height by rings with the fitted line, and the angle of repose of each sector."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import analysis_table

NO_CONE = "there is no conical heap"
WIDTH = 5.4  # inch
HIGHEST = 4.0  # inch of the profile


def draw(run, state):
    """Figure of the last state."""
    surface = analysis_table(run, state, "cone_surface", NO_CONE)
    if not surface["used"].any():
        raise NotDrawn(NO_CONE)
    sectors = run.analysis["cone_sectors"]
    units = style.units_of(run)
    reach, top = surface["r"].max() * 1.08, np.nanmax(surface["height"]) * 1.25
    tall = min(HIGHEST, (WIDTH - 0.7) * top / reach)
    figure = Figure(figsize=(WIDTH, tall + 0.75 + (1.55 if sectors is not None else 0.0)))
    heights = [tall, 1.0] if sectors is not None else [tall]
    rows = figure.subplots(len(heights), 1, squeeze=False, height_ratios=heights)
    _draw_profile(rows[0, 0], surface, units, reach, top)
    if sectors is not None:
        _draw_sectors(rows[1, 0], sectors)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - 0.2 / figure.get_figheight()), h_pad=0.8)
    style.caption(figure, "mean height over the azimuth above the base; bars: ± scatter of sectors / √n")
    return figure


def scatter_of_sectors(heights):
    """Standard error (rings) of the mean over sectors (rings, sectors) with values; 0 for fewer than two."""
    count = np.isfinite(heights).sum(axis=1)
    mean = np.nansum(heights, axis=1) / np.maximum(count, 1)
    squares = np.nansum((heights - mean[:, None]) ** 2, axis=1)
    return np.sqrt(squares / np.maximum(count - 1, 1) / np.maximum(count, 1))


def surface_line(surface):
    """Slope and intercept [L] of the line through the surface, h = slope r + intercept; None where none was fitted."""
    slope, intercept = (surface.attributes.get(name, np.nan) for name in ("slope", "intercept"))
    return (slope, intercept) if np.isfinite([slope, intercept]).all() else None


def _draw_profile(axes, surface, units, reach, top):
    used = surface["used"].astype(bool)
    error = scatter_of_sectors(surface["sector_height"])
    for chosen, fill, name in ((used, style.BLUE, "ring, used for the line"), (~used, "white", "other ring")):
        if chosen.any():
            drawing = dict(fmt="o", color=style.BLUE, markersize=3.2, elinewidth=0.8, capsize=1.5, markerfacecolor=fill)
            at = surface["r"][chosen], surface["height"][chosen], error[chosen]
            axes.errorbar(*at, label=name, markeredgewidth=0.7, **drawing)
    line = surface_line(surface)
    if line and line[0] < 0.0:
        slope, intercept = line
        r = np.array([0.0, -intercept / slope])
        angle = surface.attributes.get("angle_deg", np.degrees(np.arctan(-slope)))
        axes.plot(r, intercept + slope * r, color=style.ORANGE, linewidth=1.2, zorder=1.5, label=f"angle of repose {angle:.1f}°")
    axes.set_aspect("equal", adjustable="box")
    axes.set_xlim(0.0, reach)
    axes.set_ylim(0.0, top)
    axes.locator_params(axis="y", nbins=5)
    axes.set(xlabel=units.length("r"), ylabel=units.length("height"))
    axes.legend(loc="upper right")


def _draw_sectors(axes, sectors):
    azimuth, angle = sectors["azimuth_deg"], sectors["angle_deg"]
    some = np.isfinite(angle)
    axes.plot(azimuth[some], angle[some], "o", color=style.BLUE, markersize=3.5)
    if some.any():
        mean = angle[some].mean()
        axes.axhline(mean, color=style.ORANGE, linewidth=1.0, zorder=0.5, label=_mean_with_error(angle[some]))
        half = max(2.0, 1.6 * np.abs(angle[some] - mean).max())
        axes.set_ylim(mean - half, mean + half * 1.3)
        axes.legend(loc="upper right")
    axes.set_xlim(0.0, 360.0)
    axes.set_xticks(range(0, 361, 45))
    axes.locator_params(axis="y", nbins=5)
    axes.set(xlabel="azimuth of the sector (deg)", ylabel="angle (deg)")


def _mean_with_error(angle):
    text = f"mean of {len(angle)} sectors {angle.mean():.1f}°"
    return text + (f" ± {angle.std(ddof=1) / np.sqrt(len(angle)):.1f}°" if len(angle) > 1 else "")
