# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The part of the analysis that a picture shows."""

from repose.not_drawn import NotDrawn


def analysed(run, state, group, otherwise):
    """The Table of a group of analysis.h5; NotDrawn, with the text `otherwise` where the analysis left it out."""
    table = _analysis(run, state)[group]
    if table is None:
        raise NotDrawn(otherwise)
    return table


def packing_of(run, state, *parts):
    """The Packing of analysis.h5; NotDrawn without, or if it has none of the parts."""
    packing = _analysis(run, state).packing
    if packing is None:
        raise NotDrawn("no packing was measured (analysis.packing)")
    if parts and not any(part in packing.parts for part in parts):
        raise NotDrawn(f"the packing has no {' nor '.join(parts)}")
    return packing


def _analysis(run, state):
    if state.frame:
        raise NotDrawn("belongs to the end of the run, not to a frame")
    if run.analysis is None:
        raise NotDrawn("no analysis.h5 of the last state (repose analyse DIR writes it)")
    return run.analysis
