# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The part of the analysis that a picture shows."""

from repose.not_drawn import NotDrawn


def analysed(run, state, group, otherwise):
    """The Table of a group of analysis.h5; NotDrawn, with the text `otherwise` where the analysis left it out."""
    if state.frame:
        raise NotDrawn("belongs to the end of the run, not to a frame")
    if run.analysis is None:
        raise NotDrawn("no analysis.h5 of the last state (repose analyse DIR writes it)")
    table = run.analysis[group]
    if table is None:
        raise NotDrawn(otherwise)
    return table
