# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the stress models: each is a function of a Prediction that returns a figure."""

from repose.pictures.models import (
    base,
    columns,
    contact,
    mohr,
    osl,
    osl_cone,
    packing,
    point_load,
    point_load_3d,
    q_model,
    quasi_elastic,
)

MODEL_PICTURES = {
    "pile-lattice": base.draw,
    "pile-continuum": base.draw,
    "pile-tent": base.draw,
    "osl": osl.draw,
    "osl-cone": osl_cone.draw,
    "janssen": columns.draw_janssen,
    "janssen-discrete": columns.draw_discrete,
    "janssen-fit": columns.draw_fit,
    "mohr": mohr.draw,
    "quasi-elastic": quasi_elastic.draw,
    "q-model": q_model.draw,
    "packing": packing.draw,
    "point-load": point_load.draw,
    "point-load-3d": point_load_3d.draw,
    "equivalent-spring": contact.draw_spring,
    "contact-law": contact.draw_law,
}


def draw_model(prediction):
    """The figure of a prediction."""
    return MODEL_PICTURES[prediction.model.name](prediction)
