# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Outflow from a flat silo against Beverloo's law in 2D, W = C (D - k d)^(3/2). Takes minutes; run by ./dev validate."""

import os

import numpy as np
import pytest
from conftest import datasets

SILO = """[contact]
friction = 0.5
normal = {{ law = "hooke", stiffness = 1e4, damping = 0.5 }}
tangential = {{ law = "linear", stiffness = 5e3, damping = 0.1 }}
[grains]
polydispersity = 0.2
[[plane]]
point = [-20, 0]
normal = [1, 0]
[[plane]]
point = [20, 0]
normal = [-1, 0]
[[wall]]
from = [-20, 0]
to = [-{half}, 0]
[[wall]]
from = [{half}, 0]
to = [20, 0]
[[wall]]
from = [-{half}, 0]
to = [{half}, 0]
opens_at = 100
[source]
kind = "pour"
count = 2500
rate = 60
height = 100
half_width = 18
[box]
half_width = 30
floor = -10
[stop]
time = {end}
[output]
series = 0.5
frames = 0
"""


@pytest.mark.skipif("REPOSE_SLOW" not in os.environ, reason="takes minutes: ./dev validate")
def test_beverloo(lab):
    """W^(2/3) is linear in the opening, to 4 % of W, with k between 1 and 3 diameters. With that k, the exponent between
    the smallest and the widest opening is 3/2 within 0.15. One seed per opening; W is measured over 1200 grains."""
    openings = np.array([8.0, 10.0, 12.0, 16.0])
    rates = []
    for opening in openings:
        end = 100 + 3000 / (opening - 1.3) ** 1.5
        out = lab.run(SILO.format(half=opening / 2, end=end), out=f"o{opening}")
        found = datasets(out / "run.h5")
        time, lost = found["/series/time"], found["/series/lost"]
        steady = (lost > 200) & (lost < 1400)
        assert steady.sum() > 20
        rates.append(np.polyfit(time[steady], lost[steady], 1)[0])
    rates = np.array(rates)
    slope, offset = np.polyfit(openings, rates ** (2 / 3), 1)
    nothing = -offset / slope
    line = (slope * (openings - nothing)) ** 1.5
    exponent = np.log(rates[-1] / rates[0]) / np.log((openings[-1] - nothing) / (openings[0] - nothing))
    print(f"rates {rates.round(2)}, C = {slope**1.5:.3f}, k d = {nothing:.2f}, exponent {exponent:.3f}")
    assert (abs(rates / line - 1.0) < 0.04).all()
    assert 0.9 < nothing < 2.7
    assert abs(exponent - 1.5) < 0.15
