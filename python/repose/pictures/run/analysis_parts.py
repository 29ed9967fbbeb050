# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of analysis.h5 that pictures show, or the reason why there are none."""

from repose.errors import NotDrawn

NO_FORCES = "no contact force exceeds analysis.force_threshold"


def analysis_table(run, state, group, reason):
    """The Table of a group of analysis.h5; NotDrawn with `reason` where the analysis has no such group."""
    table = _analysis(run, state)[group]
    if table is None:
        raise NotDrawn(reason)
    return table


def measured_packing(run, state, *parts):
    """The Packing of analysis.h5; NotDrawn without one, or where it has none of the parts."""
    packing = _analysis(run, state).packing
    if packing is None:
        raise NotDrawn("no packing was measured (analysis.packing)")
    if parts and not any(part in packing.parts for part in parts):
        raise NotDrawn(f"the packing has no {' or '.join(parts)}")
    return packing


def _analysis(run, state):
    if state.frame:
        raise NotDrawn("it shows the end of the run, not a frame")
    if run.analysis is None:
        raise NotDrawn("the last state has no analysis.h5 (repose analyse DIR writes it)")
    return run.analysis
