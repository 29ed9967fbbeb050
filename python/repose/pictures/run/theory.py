# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Models of theory over the forces of a heap on its base."""

from repose import style
from repose.errors import NotDrawn
from repose.pictures.run.analysis_parts import analysis_table
from repose.pictures.theory_overlay import NO_MODEL, Comparison, draw_comparisons


def draw(run, state):
    """Figure of the time window at the end of the run."""
    bins = analysis_table(run, state, "base", "the run has no base profile")
    entries = run.summary.get("theory")
    if not entries:
        raise NotDrawn(NO_MODEL)
    units = style.units_of(run)
    slope = (run.summary.get("angle_of_repose_deg") or {}).get("mean")
    text = "one heap" if slope is None else f"one heap of slope {slope:.1f}°"
    text += f"; bins of {units.length_value(bins.attributes['bin_width'])}; bars are no errors of the profile, for which other heaps are needed"
    return draw_comparisons([Comparison("", run.base, bins, entries, "mean ± scatter of its discs / √n")], units, text)
