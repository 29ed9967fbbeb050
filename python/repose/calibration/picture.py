# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a calibration: the posterior in a triangle, and each target over each parameter."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from scipy.ndimage import gaussian_filter

from repose import style

CELL = 1.75  # inches, of a panel
BINS = 60
SMOOTHING = 1.2  # bins
SLICE = 80  # points of a line


def draw(plan, measured, fit):
    """A figure for d parameters and T targets: d rows of the triangle above T rows of fits."""
    d, t = len(plan.parameters), len(plan.targets)
    figure = Figure(figsize=(CELL * max(d, 2) + 0.5, CELL * (d + t) + 0.3))
    grid = figure.add_gridspec(d + t, d)
    for row in range(d):
        for column in range(row + 1):
            axes = figure.add_subplot(grid[row, column])
            if row == column:
                _draw_marginal(axes, plan, fit, row)
            else:
                _draw_pair(axes, plan, measured, fit, column, row)
            _label(axes, plan, column, last=row == d - 1)
            if row != column and column == 0:
                axes.set_ylabel(_short(plan.parameters[row].key))
    median = fit.posterior.quantiles([0.5])[:, 0]
    for row in range(t):
        for column in range(d):
            axes = figure.add_subplot(grid[d + row, column])
            _draw_fit(axes, plan, measured, fit, row, column, median)
            _label(axes, plan, column, last=row == t - 1)
            if column == 0:
                axes.set_ylabel(_short(plan.targets[row].measure))
    style.fit(figure)
    return figure


def _short(name):
    """A dotted name without the end that all targets have, in lines that fit a panel."""
    return name.removesuffix(".mean").replace(".", ".\n", 1) if len(name) > 18 else name


def _label(axes, plan, column, last):
    parameter = plan.parameters[column]
    if parameter.prior == "log-uniform":
        axes.set_xscale("log")
    else:
        axes.xaxis.set_major_locator(MaxNLocator(4))
    axes.set_xlim(parameter.low, parameter.high)
    if last:
        axes.set_xlabel(_short(parameter.key))
    else:
        axes.tick_params(labelbottom=False)


def _edges(parameter, bins):
    return parameter.from_scaled(np.linspace(0.0, 1.0, bins + 1))


def _draw_marginal(axes, plan, fit, k):
    """Densities over the scaled range: the posterior filled, the prior grey; median and 90 % interval."""
    parameter, posterior = plan.parameters[k], fit.posterior
    middles = (np.arange(BINS) + 0.5) / BINS
    density = np.histogram(posterior.places[:, k], BINS, (0.0, 1.0), weights=posterior.weight)[0] * BINS
    density = gaussian_filter(density, SMOOTHING, mode="reflect")
    at = parameter.from_scaled(middles)
    axes.fill_between(at, density, color=style.pale(style.BLUE, 0.3), linewidth=0)
    axes.plot(at, density, color=style.BLUE, label="posterior")
    axes.plot(at, parameter.density(middles), color=style.GREY, linestyle="--", label="prior")
    low, median, high = posterior.quantiles([0.05, 0.5, 0.95])[k]
    axes.axvline(median, color=style.INK, linewidth=0.8)
    for end in (low, high):
        axes.axvline(end, color=style.INK, linewidth=0.6, linestyle=":")
    axes.set_ylim(0.0, 1.15 * max(density.max(), parameter.density(middles).max()))
    axes.set_yticks([])
    if k == 0:
        axes.legend(loc="best", fontsize=6)


def _draw_pair(axes, plan, measured, fit, first, second):
    """The density of a pair, the contour that holds 90 % of it, and the points."""
    posterior = fit.posterior
    pair = [posterior.places[:, k] for k in (first, second)]
    density = np.histogram2d(*pair, BINS, [(0.0, 1.0), (0.0, 1.0)], weights=posterior.weight)[0].T
    density = gaussian_filter(density, SMOOTHING, mode="reflect")
    horizontal, vertical = (plan.parameters[k] for k in (first, second))
    edges = _edges(horizontal, BINS), _edges(vertical, BINS)
    axes.pcolormesh(*edges, density, cmap=style.LOAD, rasterized=True)
    middles = (np.arange(BINS) + 0.5) / BINS
    level = _level(density, 0.9)
    if density.min() < level < density.max():
        axes.contour(horizontal.from_scaled(middles), vertical.from_scaled(middles), density, [level],
                     colors=[style.BLUE], linewidths=0.8)  # fmt: skip
    axes.plot(measured.values[:, first], measured.values[:, second], ".", color=style.INK, markersize=2.0)
    if vertical.prior == "log-uniform":
        axes.set_yscale("log")
    axes.set_ylim(vertical.low, vertical.high)


def _level(density, fraction):
    """The density above which this fraction lies."""
    falling = np.sort(density.ravel())[::-1]
    return falling[np.searchsorted(np.cumsum(falling), fraction * falling.sum())]


def _draw_fit(axes, plan, measured, fit, row, column, median):
    """A target over a parameter: all points, the surrogate where the other parameters have their medians."""
    target, means, parameter = plan.targets[row], fit.means[row], plan.parameters[column]
    line = np.tile(plan.scaled(median[None, :]), (SLICE, 1))
    line[:, column] = np.linspace(0.0, 1.0, SLICE)
    mean, variance = fit.surrogates[row].predict(line)
    at, deviation = parameter.from_scaled(line[:, column]), np.sqrt(variance)
    wanted, band = style.pale(style.ORANGE, 0.25), style.pale(style.BLUE, 0.25)
    axes.axhspan(target.value - target.error, target.value + target.error, color=wanted, linewidth=0)
    axes.axhline(target.value, color=style.ORANGE, linewidth=0.8)
    axes.fill_between(at, mean - 2.0 * deviation, mean + 2.0 * deviation, color=band, linewidth=0)
    axes.plot(at, mean, color=style.BLUE)
    drawing = dict(fmt=".", color=style.GREY, markersize=2.5, elinewidth=0.5, zorder=1.5)
    axes.errorbar(measured.values[means.rows, column], means.mean, means.error, **drawing)
    axes.yaxis.set_major_locator(MaxNLocator(4))
