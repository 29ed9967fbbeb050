# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Panels of claims: the interval of each statistic beside the bounds that the claim sets."""

import textwrap

import numpy as np

from repose import style

COLOURS = {"agrees": style.GREEN, "equivalent": style.GREEN, "disagrees": style.ORANGE, "different": style.ORANGE}
LONGEST = 46  # letters of a line


def draw(axes, study, panel):
    """Each claim has a row of its own scale, on which its bounds are -1 and 1, or 0 where it has one bound."""
    claims = study.claims
    for row, claim in enumerate(claims):
        _draw_claim(axes, row, claim)
    axes.set_ylim(len(claims) - 0.5, -0.5)
    axes.set_yticks(range(len(claims)), ["\n".join(textwrap.wrap(claim["claim"], LONGEST)[:3]) for claim in claims], fontsize=6)
    axes.set_xlim(-3.2, 3.2)
    axes.set_xticks([])
    axes.set_xlabel("interval of the statistic beside the bounds of the claim (grey)")


def _draw_claim(axes, row, claim):
    low, high = (np.nan if claim[key] is None else claim[key] for key in ("above", "below"))
    value, left, right = (np.nan if claim[key] is None else claim[key] for key in ("value", "low", "high"))
    colour = COLOURS.get(claim["verdict"], style.GREY)
    centre, scale = _scale(low, high, value, left, right)
    ends = [np.clip((end - centre) / scale, -3.1, 3.1) for end in (low, high)]
    start = ends[0] if np.isfinite(low) else -3.2
    stop = ends[1] if np.isfinite(high) else 3.2
    axes.barh(row, stop - start, left=start, height=0.8, color=style.pale(style.FAINT, 0.6), linewidth=0)
    if np.isfinite(value):
        at = np.clip((np.array([value, left, right]) - centre) / scale, -3.1, 3.1)
        axes.plot(at[1:], [row, row], color=colour, linewidth=1.4, solid_capstyle="butt")
        axes.plot(at[0], row, "o", color=colour, markersize=4)
    text = "" if not np.isfinite(value) else f"{value:.3g}"
    axes.annotate(f"{text} {claim['verdict']}".strip(), (1.01, row), xycoords=("axes fraction", "data"), va="center", fontsize=6)


def _scale(low, high, value, left, right):
    """The centre and the half-width of a row."""
    if np.isfinite(low) and np.isfinite(high):
        return 0.5 * (low + high), max(0.5 * (high - low), 1e-300)
    bound = low if np.isfinite(low) else high
    reach = np.nanmax(np.abs(np.array([value, left, right]) - bound), initial=0.0)
    return bound, max(reach / 2.0, 1e-300)
