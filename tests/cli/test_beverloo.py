# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Outflow from a silo against Beverloo's law, W = C (D - k d)^(3/2) in 2D and C (D - k d)^(5/2) in 3D. Takes minutes; run
by ./dev validate."""

import os
from pathlib import Path

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


HOPPER = Path(__file__).resolve().parents[2] / "examples" / "hopper-3d.toml"
slow = pytest.mark.skipif("REPOSE_SLOW" not in os.environ, reason="takes minutes: ./dev validate")


def outflow(out, least, most):
    """Grains per time, while so many have left."""
    found = datasets(out / "run.h5")
    time, lost = found["/series/time"], found["/series/lost"]
    steady = (lost > least) & (lost < most)
    assert steady.sum() > 20
    return np.polyfit(time[steady], lost[steady], 1)[0]


@slow
def test_beverloo(lab):
    """W^(2/3) is linear in the opening, to 4 % of W, with k between 1 and 3 diameters. With that k, the exponent between
    the smallest and the widest opening is 3/2 within 0.15. One seed per opening; W is measured over 1200 grains."""
    openings = np.array([8.0, 10.0, 12.0, 16.0])
    rates = []
    for opening in openings:
        end = 100 + 3000 / (opening - 1.3) ** 1.5
        out = lab.run(SILO.format(half=opening / 2, end=end), out=f"o{opening}")
        rates.append(outflow(out, 200, 1400))
    rates = np.array(rates)
    slope, offset = np.polyfit(openings, rates ** (2 / 3), 1)
    nothing = -offset / slope
    line = (slope * (openings - nothing)) ** 1.5
    exponent = np.log(rates[-1] / rates[0]) / np.log((openings[-1] - nothing) / (openings[0] - nothing))
    print(f"rates {rates.round(2)}, C = {slope**1.5:.3f}, k d = {nothing:.2f}, exponent {exponent:.3f}")
    assert (abs(rates / line - 1.0) < 0.04).all()
    assert 0.9 < nothing < 2.7
    assert abs(exponent - 1.5) < 0.15


@slow
def test_beverloo_of_spheres(lab):
    """The exponent is 5/2 within 0.1, with the k = 1.4 of Beverloo, Leniger and van de Velde (1961) and the mean diameter
    of 0.9. Two seeds per opening of the example; W is measured over 1000 spheres of 3000."""
    radii = np.array([2.5, 3.0, 4.0, 5.0])
    free = 2 * radii - 1.4 * 0.9
    rates = np.zeros((len(radii), 2))
    for k, radius in enumerate(radii):
        end = 80 + 2000 / free[k] ** 2.5  # some 1800 leave, at 0.9 (D - k d)^(5/2) a time
        changed = {"wall.cone.radius_from": radius, "wall.gate.radius": radius, "stop.time": end, "output.frames": 0}
        changed["output.series"] = (end - 80) / 100
        for seed in (1, 2):
            settings = [f"--set={key}={value}" for key, value in (changed | {"seed": seed}).items()]
            assert lab("run", HOPPER, "--out", f"r{radius}-{seed}", *settings, timeout=1800).returncode == 0
            rates[k, seed - 1] = outflow(lab.path / f"r{radius}-{seed}", 150, 1150)
    line, errors = np.polyfit(np.log(free), np.log(rates.mean(axis=1)), 1, cov=True)
    print(f"rates {rates.round(1).tolist()}, C = {np.exp(line[1]):.3f}, exponent {line[0]:.3f} +- {errors[0, 0] ** 0.5:.3f}")
    assert abs(line[0] - 2.5) < 0.1
