# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The posterior of the parameters: draws of the prior, weighted by the likelihood of the targets."""

from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2, qmc

POWERS = (14, 16, 18)  # of two: numbers of draws, more where few have a weight
ENOUGH = 400.0  # effective draws
FEW = 100.0  # effective draws, below which a warning says so
UNLIKELY = 0.95  # of chi-square: the best point beyond it does not reach the targets
END_WIDTH = 0.05  # of the range
LEVEL = 0.90  # of intervals


@dataclass(frozen=True)
class Posterior:
    """n weighted draws of d parameters, with T surrogates at each."""

    places: np.ndarray  # (n, d) 0 to 1 in the ranges
    values: np.ndarray  # (n, d) in the units of the keys
    weight: np.ndarray  # (n), the sum is 1
    mean: np.ndarray  # (T, n) of the surrogates
    variance: np.ndarray  # (T, n)
    chi_square: np.ndarray  # (n)

    @property
    def effective(self):
        """Effective number of draws (Kish 1965): that of equal weights with the same variance of a mean."""
        return float(1.0 / np.sum(self.weight**2))

    def quantiles(self, probabilities):
        """Values (d, len(probabilities)) below which the posterior has these probabilities."""
        return np.array([weighted_quantiles(column, self.weight, probabilities) for column in self.values.T])

    def moments(self):
        """Means (d), standard deviations (d) and correlations (d, d) of the values."""
        mean = self.weight @ self.values
        off = self.values - mean
        covariance = (off * self.weight[:, None]).T @ off
        deviation = np.sqrt(np.diag(covariance))
        safe = np.where(deviation > 0.0, deviation, 1.0)
        return mean, deviation, covariance / np.outer(safe, safe)

    def surrogate_deviation(self):
        """Standard deviations (T) of the surrogates: root of the mean variance over the posterior."""
        return np.sqrt(self.variance @ self.weight)

    def predicted(self):
        """Mean (T) and standard deviation (T) of the targets over the posterior, with the surrogates' uncertainty."""
        mean = self.mean @ self.weight
        return mean, np.sqrt(((self.mean - mean[:, None]) ** 2 + self.variance) @ self.weight)

    def resampled(self, count, seed):
        """Rows (count) of draws with equal weights, in order (systematic resampling)."""
        start = np.random.default_rng(seed).random()
        rows = np.searchsorted(np.cumsum(self.weight), (start + np.arange(count)) / count)
        return np.minimum(rows, len(self.weight) - 1)


def weighted_quantiles(values, weight, probabilities):
    """Quantiles of values (n) with weights (n) that add up to 1, linear between the middles of the steps."""
    order = np.argsort(values, kind="stable")
    sums = np.cumsum(weight[order])
    return np.interp(probabilities, sums - 0.5 * weight[order], values[order])


def posterior_of(plan, surrogates, powers=POWERS):
    """The Posterior: prior times normal densities of the targets, whose variance is that of the target and that of the
    surrogate. Draws are scrambled Sobol points of the prior. Validated by python/tests/test_calibration.py."""
    for power in powers:
        found = _weighted(plan, surrogates, power)
        if found.effective >= ENOUGH:
            break
    return found


def _weighted(plan, surrogates, power):
    sobol = qmc.Sobol(len(plan.parameters), scramble=True, seed=plan.design.seed + 1)
    values = plan.values(sobol.random_base2(power))
    places = plan.scaled(values)
    predictions = [surrogate.predict(places) for surrogate in surrogates]
    mean, variance = (np.array(part) for part in zip(*predictions))
    wanted = np.array([[target.value] for target in plan.targets])
    total = np.array([[target.error**2] for target in plan.targets]) + variance
    chi_square = ((mean - wanted) ** 2 / total).sum(axis=0)
    logarithm = -0.5 * (chi_square + np.log(total).sum(axis=0))
    weight = np.exp(logarithm - logarithm.max())
    return Posterior(places, values, weight / weight.sum(), mean, variance, chi_square)


def warnings_of(plan, posterior):
    """What a reader must know: one line each."""
    lines = []
    best, likely = posterior.chi_square.min(), chi2.ppf(UNLIKELY, len(plan.targets))
    if best > likely:
        found = f"chi-square of the best is {best:.3g}, above {likely:.3g}"
        lines.append(f"no point in the ranges reaches the targets: {found}")
    if posterior.effective < FEW:
        advice = "the ranges are wide beside the posterior; narrow them"
        lines.append(f"only {posterior.effective:.0f} effective draws: {advice}")
    for k, parameter in enumerate(plan.parameters):
        place = posterior.places[:, k]
        for end, inside in (("low", place < END_WIDTH), ("high", place > 1.0 - END_WIDTH)):
            if posterior.weight[inside].sum() > END_WIDTH:
                value = f"{getattr(parameter, end):g}"
                lines.append(f"{parameter.key}: the posterior touches the {end} end of the range, {value}")
    return lines
