# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a sweep: each is a function of a SweepFolder that returns figures or raises NotDrawn."""

from repose.pictures.sweep import angle, columns, dip, heights, measures, packing, phase, profiles, response, theory

SWEEP_PICTURES = {
    "profiles": profiles.draw,
    "angle": angle.draw,
    "dip": dip.draw,
    "measures": measures.draw,
    "packing": packing.draw,
    "response": response.draw,
    "heights": heights.draw,
    "columns": columns.draw,
    "phase": phase.draw,
    "theory": theory.draw,
}
