# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Means with their standard errors as a band."""

from repose import style


def draw_with_error_band(axes, x, mean, error, colour, label):
    """A line through the means and a band of their standard errors, with gaps where an error is not defined."""
    axes.plot(x, mean, color=colour, linewidth=1.4, label=label)
    axes.fill_between(x, mean - error, mean + error, color=style.pale(colour, 0.25), linewidth=0, zorder=0.8)
