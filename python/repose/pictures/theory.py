# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Models of theory over the forces of a heap on its base."""

from repose import style
from repose.not_drawn import NotDrawn
from repose.pictures.laid_on import NONE, Measured, figure_of
from repose.pictures.needed import analysed


def draw(run, state):
    """Figure of the settled window at the end of the run."""
    bins = analysed(run, state, "base", "no row of base grains")
    entries = run.summary.get("theory")
    if not entries:
        raise NotDrawn(NONE)
    units = style.units_of(run)
    slope = (run.summary.get("angle_of_repose_deg") or {}).get("mean")
    text = "one heap" if slope is None else f"one heap of slope {slope:.1f}°"
    text += f"; mean over {units.length_value(bins.attributes['bin_width'])}, errors from the scatter between discs"
    return figure_of([Measured("", run.base, bins, entries)], units, text)
