# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Rounds of points, one after the other, until the surrogates are good enough over the posterior."""

from dataclasses import dataclass, field

import numpy as np
from threadpoolctl import threadpool_limits

from repose.calibration.design import first_points, next_points
from repose.calibration.errors import NotCalibrated
from repose.calibration.posterior import POWERS, Posterior, posterior_of
from repose.calibration.scatter import Means, means_of
from repose.calibration.surrogate import Surrogate


@dataclass
class Measured:
    """All points so far: P points of S members each, d parameters, T targets."""

    values: np.ndarray  # (P, d)
    round: np.ndarray  # (P) from 1
    results: np.ndarray  # (P, S, T), NaN where a member has no value
    failed: np.ndarray  # (P) members that failed

    @classmethod
    def none(cls, plan):
        d, members = len(plan.parameters), (0, plan.seeds, len(plan.targets))
        return cls(np.zeros((0, d)), np.zeros(0, dtype=int), np.zeros(members), np.zeros(0, dtype=int))

    def with_round(self, number, values, results, failed):
        return Measured(
            np.vstack([self.values, values]),
            np.append(self.round, np.full(len(values), number)),
            np.concatenate([self.results, results]),
            np.append(self.failed, failed),
        )


@dataclass
class Fit:
    """What the measurements say."""

    means: "list[Means]"  # (T)
    surrogates: "list[Surrogate]"  # (T)
    posterior: Posterior

    def ratios(self, plan):
        """Standard deviation of each surrogate over the posterior, in errors of its target (T)."""
        return self.posterior.surrogate_deviation() / np.array([target.error for target in plan.targets])


@dataclass
class Options:
    """Costs of a fit; tests of many cases take less."""

    restarts: int = 4
    powers: tuple = field(default=POWERS)


def fit(plan, measured, options=Options()):
    """The Fit of all measurements. NotCalibrated where a target has too few points."""
    means, surrogates = [], []
    places = plan.scaled(measured.values)
    least = len(plan.parameters) + 2
    with threadpool_limits(limits=1):  # sums of several threads would not be the same to the bit everywhere
        for k, target in enumerate(plan.targets):
            found = means_of(measured.results[:, :, k])
            rows = found.rows
            if len(rows) < least:
                raise NotCalibrated(f"{target.measure}: only {len(rows)} points have two values: {least} are needed")
            means.append(found)
            surrogates.append(Surrogate(places[rows], found.mean, found.error, plan.design.seed, options.restarts))
        return Fit(means, surrogates, posterior_of(plan, surrogates, options.powers))


def calibrate(plan, rounds, report=lambda *_: None, options=Options()):
    """Measures rounds of points until each surrogate's deviation is below `stop` errors of its target, or there are
    `most` points. Returns (Measured, Fit, stopped), where stopped is "certain" or "most".

    `rounds.planned(number)` gives the values (n, d) of a round that this or another program has begun, or None;
    `rounds.run(number, values)` measures it: the values as planned, results (n, S, T) and the number of failed members
    (n). `report` hears of every fit. A run that continues an earlier one makes the same points."""
    measured = Measured.none(plan)
    number, values = 1, rounds.planned(1)
    if values is None:
        values = first_points(plan)
    while True:
        measured = measured.with_round(number, *rounds.run(number, values))
        number += 1
        values = rounds.planned(number)
        if values is not None:
            continue
        found = fit(plan, measured, options)
        report(number - 1, measured, found)
        if np.all(found.ratios(plan) < plan.design.stop):
            return measured, found, "certain"
        room = plan.design.most - len(measured.values)
        if room <= 0:
            return measured, found, "most"
        deviations = [means.deviation for means in found.means]
        with threadpool_limits(limits=1):
            values = next_points(plan, found.surrogates, found.posterior, deviations, min(plan.design.batch, room))
