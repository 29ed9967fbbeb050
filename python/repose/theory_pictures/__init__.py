# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the models of theory: each is a function of a Prediction that returns a figure."""

from repose.theory_pictures import base, osl

PICTURES = {
    "pile-continuum": base.draw,
    "pile-lattice": base.draw,
    "pile-tent": base.draw,
    "osl": osl.draw,
}


def figure_of(prediction):
    """The figure of a model."""
    return PICTURES[prediction.model.name](prediction)
