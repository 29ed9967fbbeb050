# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the models of theory: each is a function of a Prediction that returns a figure."""

from repose.theory_pictures import base, point_load, q_model

PICTURES = {
    "pile-continuum": base.draw,
    "point-load": point_load.draw,
    "q-model": q_model.draw,
}


def figure_of(prediction):
    """The figure of a model."""
    return PICTURES[prediction.model.name](prediction)
