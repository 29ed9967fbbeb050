# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Ballistic deposition without restructuring, in the limit of wide beds. Half a minute; run by ./dev validate."""

import os

import numpy as np
import pytest
from conftest import summary

pytestmark = pytest.mark.skipif("REPOSE_SLOW" not in os.environ, reason="half a minute: for ./dev validate")

SCENE = """
[method]
kind = "deposition"
critical_angle = 90
[base]
count = %d
[source]
count = %d
[analysis]
slab = [0.4, 1.6]
"""


# The roughness grows up to a height of about W^(3/2) (Kardar, Parisi and Zhang 1986). Above it the solid fraction differs
# from that of a wide bed by a term in 1/W. The beds have the height 30 W^(3/2), and the slab lies well above the rough
# beginning. Meakin and Jullien give 0.3568 +- 0.0001, an independent code 0.3566 +- 0.0003; the bound of 0.001 is three
# standard errors of the fit. The coordination is 2: each disc touches one earlier disc and, on average, is touched by one
# later disc. Anisotropy and direction are 0.742 +- 0.001 and 30.3 deg, not the 2/3 and 31.7 deg of a disc without
# neighbours.
def test_wide_beds(lab):
    rows = []
    for width, seeds in ((16, 24), (32, 12), (64, 8), (128, 4)):
        lab.scene(SCENE % (width, int(0.45 * width * 30 * width**1.5)))
        found = []
        for seed in range(1, seeds + 1):
            result = lab("run", "scene.toml", "--out", "out", "--overwrite", "--quiet", "--seed", str(seed))
            assert result.returncode == 0, result.stderr
            run = summary(lab.path / "out")
            found.append([run[key] for key in ("solid_fraction", "coordination", "anisotropy", "fabric_direction_deg")])
        mean, error = np.mean(found, axis=0), np.std(found, axis=0, ddof=1) / np.sqrt(seeds)
        print(f"width {width}: solid fraction {mean[0]:.4f} +- {error[0]:.4f}, coordination {mean[1]:.5f} +- {error[1]:.5f},"
              f" anisotropy {mean[2]:.4f} +- {error[2]:.4f}, direction {mean[3]:.2f} +- {error[3]:.2f}")
        rows.append((1 / width, mean[0], error[0]))
    x, y, e = np.array(rows).T
    fit, covariance = np.polyfit(x, y, 1, w=1 / e, cov="unscaled")
    print(f"wide limit {fit[1]:.4f} +- {np.sqrt(covariance[1, 1]):.4f}")
    assert abs(fit[1] - 0.3566) < 0.001
    assert abs(mean[1] - 2) < 1e-4
    assert abs(mean[2] - 0.742) < 0.003
    assert abs(mean[3] - 30.34) < 0.05
