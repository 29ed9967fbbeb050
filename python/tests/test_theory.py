# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The Python side of theory: names, units, errors, and the examples of its documentation."""

import doctest

import numpy as np
import pytest

from repose import theory
from repose.theory_pictures import PICTURES


def test_examples_of_the_documentation():
    assert doctest.testmod(theory) == (0, 3)


def test_arrays_units_and_parameters():
    pile = theory.predict("pile-continuum", slope_deg=45, points=11)
    assert pile["normal"].shape == (11,) and pile["normal"].dtype == np.float64
    assert pile.unit("normal") == "chi g B" and pile.unit("x_over_b") == "1"
    assert pile.model.value("slope_deg") == "45"
    with pytest.raises(KeyError):
        pile["horizontal"]


def test_a_number_keeps_its_bits():
    slope = 30.0 + 2.0**-45
    assert float(theory.predict("pile-continuum", slope_deg=slope).model.value("slope_deg")) == slope
    assert theory.predict("pile-continuum", points=np.int64(5))["normal"].shape == (5,)


def test_errors_are_value_errors():
    with pytest.raises(ValueError, match="slope_deg = 60.0: must be > 0 and < 60"):
        theory.predict("pile-continuum", slope_deg=60.0)
    with pytest.raises(theory.InputError, match="no such model of theory"):
        theory.predict("pyramid")


def test_every_model_has_a_picture():
    assert set(PICTURES) == set(theory.models())
