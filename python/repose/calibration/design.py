# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The points of a calibration: the first ones spread over the prior, later ones where the posterior is uncertain."""

import numpy as np
from scipy.stats import qmc

CANDIDATES = 512  # draws of the posterior among which the next points are chosen


def first_points(plan):
    """Values (start, d): a scrambled Sobol or Halton sequence, even in the prior."""
    design, d = plan.design, len(plan.parameters)
    if design.sequence == "halton":
        return plan.values(qmc.Halton(d, scramble=True, seed=design.seed).random(design.start))
    sobol = qmc.Sobol(d, scramble=True, seed=design.seed)
    return plan.values(sobol.random_base2(int(np.ceil(np.log2(design.start))))[: design.start])


def next_points(plan, surrogates, posterior, deviations, count):
    """Values (count at most, d): draws of the posterior, one after the other, each the one that lowers the variance of
    the surrogates most, in units of the targets' errors and averaged over the posterior. This counts the points chosen
    before, so that a round spreads. `deviations` (T) between seeds give the errors of the points to come."""
    rows, times = np.unique(posterior.resampled(CANDIDATES, plan.design.seed), return_counts=True)
    weight, places = times / CANDIDATES, posterior.places[rows]
    updates = [s.update(places, deviation / np.sqrt(plan.seeds)) for s, deviation in zip(surrogates, deviations)]
    chosen = []
    for _ in range(min(count, len(rows))):
        gain = sum(update.gain(weight) / target.error**2 for update, target in zip(updates, plan.targets))
        gain[chosen] = -1.0
        chosen.append(int(np.argmax(gain)))
        for update in updates:
            update.add(chosen[-1])
    return posterior.values[rows[chosen]]
