# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The heap of Baxter et al. from rigid grains: examples/heap-cd.toml with 100 grains. Run by ./dev validate."""

import os
from pathlib import Path

import numpy as np
import pytest
from conftest import repose, summary

pytestmark = pytest.mark.skipif("REPOSE_SLOW" not in os.environ, reason="a minute: for ./dev validate")

SCENE = Path(__file__).parents[2] / "examples" / "heap-cd.toml"
SEEDS = range(1, 6)


@pytest.fixture(scope="module")
def heaps(tmp_path_factory):
    """The summaries by height of fall, in order of the seed."""
    folder = tmp_path_factory.mktemp("heaps")

    def heap(height, seed):
        out = folder / f"{height}-{seed}"
        result = repose("run", SCENE, "--out", out, "--quiet", "--seed", seed, "--set", "source.count=100", "--set",
                        f"source.height={height}", "--set", "output.window=1.0", "--set", "output.frames=0")
        assert result.returncode == 0, result.stderr
        return summary(out)

    return {height: [heap(height, seed) for seed in SEEDS] for height in (20, 100)}


def test_the_base_carries_the_weight(heaps):
    # The residual of a contact is at most 1e-3 g dt, so the force on a grain is out of balance by at most a few 1e-3 of its
    # weight, with either sign.
    for heap in heaps[20] + heaps[100]:
        assert abs(heap["weight_error"]) < 2e-3
        # Overlaps up to 1e-3 radii are not corrected; overlaps from residuals are corrected gradually.
        assert 0 <= heap["max_overlap"] < 1e-3
        assert heap["grains"] + heap["grains_lost"] == 100


def test_solver_converges_except_in_some_impacts(heaps):
    for heap in heaps[20] + heaps[100]:
        solver = heap["solver"]
        assert 0 <= solver["unconverged"] < 0.03 * solver["steps"]
        assert solver["worst_residual"] < 0.5  # in g dt; impacts have 1e3


def test_a_high_fall_flattens_the_heap(heaps):
    low, high = (np.array([heap["angle_of_repose_deg"]["moments"] for heap in heaps[height]]) for height in (20, 100))
    error = np.sqrt((low.var(ddof=1) + high.var(ddof=1)) / len(low))
    print(f"angle from moments: {low.mean():.1f} from height 20, {high.mean():.1f} from 100, difference +- {error:.1f}")
    assert low.mean() - high.mean() > 2 * error
