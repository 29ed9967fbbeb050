# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The panel of pressures by rings: what it draws of heaps and of models is relative to the same means."""

from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.figure import Figure

from repose.errors import NotDrawn
from repose.pictures.study import rings


def heap(radius, height):
    """A run with the hydrostatic pressure of a cone in rings one wide."""
    outer = np.arange(1.0, radius + 1.0)
    inner = outer - 1.0
    load = np.pi * height * (outer**2 - 2.0 * outer**3 / (3.0 * radius))  # of height (1 - r/radius) within outer
    pressure = np.diff(load, prepend=0.0) / (np.pi * (outer**2 - inner**2))
    table = {"r": 0.5 * (inner + outer), "inner": inner, "outer": outer, "load": load, "pressure": pressure}
    dip = {"base_dip": {"loaded_radius": rings.LOADED * radius}}
    return SimpleNamespace(analysis={"base_rings": table}, summary=dip)


def drawn(runs, **panel):
    axes = Figure().add_subplot()
    rings.draw(axes, SimpleNamespace(runs=lambda point: iter(runs)), {"points": ["point"], **panel})
    return axes


def cone(r):
    """Hydrostatic pressure of a full cone over its mean within the loaded radius."""
    return (1.0 - rings.LOADED * r) / (1.0 - 2.0 / 3.0 * rings.LOADED)


def test_heaps_of_any_size_fall_together():
    """Rings are as wide as 1/18 of the loaded radius: the mean over a ring is that at its middle to 3e-3, but for the
    innermost two."""
    line = drawn([heap(20, 8.0), heap(20, 16.0)]).get_lines()[0]
    r, pressure = line.get_data()
    inside = (r > 0.15) & (r < 1.0)
    assert inside.sum() > 10
    assert pressure[inside] == pytest.approx(cone(r[inside]), abs=3e-3)


def test_model_has_the_same_means():
    r = np.linspace(0.0, 1.0, 101)
    at, pressure = rings.relative({"r_over_R": r, "normal": 7.0 * (1.0 - r)})
    assert at == pytest.approx(r / rings.LOADED)
    assert pressure == pytest.approx(cone(at), abs=1e-6)


def test_nothing_measured():
    with pytest.raises(NotDrawn, match="point: the pressure on the base was not measured"):
        drawn([SimpleNamespace(analysis=None, summary={})])
