# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Rounds of a calibration whose members are a formula with noise, in place of a sweep."""

import numpy as np


class CheapRounds:
    """Members are model(values) (n, T) plus normal noise with deviations `noise` (T)."""

    def __init__(self, plan, model, noise, seed):
        self.plan, self.model, self.noise = plan, model, np.asarray(noise, dtype=float)
        self.random = np.random.default_rng(seed)
        self.rounds = []

    def planned(self, number):
        return None

    def run(self, number, values):
        self.rounds.append(values)
        exact = self.model(values)
        scatter = self.noise * self.random.standard_normal((len(values), self.plan.seeds, exact.shape[1]))
        return values, exact[:, None, :] + scatter, np.zeros(len(values), dtype=int)
