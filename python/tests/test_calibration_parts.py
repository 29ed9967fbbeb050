# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of a calibration against closed forms: priors, scatter between seeds, variances of the surrogate, sampling."""

import numpy as np
import pytest

pytest.importorskip("scipy")
pytest.importorskip("sklearn")

from repose.calibration import design  # noqa: E402
from repose.calibration.loop import Fit  # noqa: E402
from repose.calibration.plan import Design, Parameter, Plan, Target  # noqa: E402
from repose.calibration.posterior import Posterior, posterior_of, warnings_of, weighted_quantiles  # noqa: E402
from repose.calibration.scatter import POOL_WEIGHT, means_of  # noqa: E402
from repose.calibration.surrogate import Surrogate  # noqa: E402
from scipy.stats import truncnorm  # noqa: E402

PROBABILITIES = np.linspace(0.001, 0.999, 37)


def test_a_uniform_prior_is_a_straight_line():
    parameter = Parameter("k", -2.0, 6.0)
    assert parameter.value(PROBABILITIES) == pytest.approx(-2.0 + 8.0 * PROBABILITIES, rel=1e-14)
    assert parameter.scaled(parameter.value(PROBABILITIES)) == pytest.approx(PROBABILITIES, rel=1e-12)


def test_a_log_uniform_prior_has_equal_probability_in_each_decade():
    parameter = Parameter("k", 1e-3, 1.0, "log-uniform")
    assert parameter.value([1 / 3, 2 / 3]) == pytest.approx([1e-2, 1e-1], rel=1e-12)
    assert parameter.scaled(parameter.value(PROBABILITIES)) == pytest.approx(PROBABILITIES, rel=1e-12)


def test_a_normal_prior_is_cut_at_the_range():
    parameter = Parameter("k", 0.2, 1.5, "normal", 0.5, 0.4)
    exact = truncnorm((0.2 - 0.5) / 0.4, (1.5 - 0.5) / 0.4, 0.5, 0.4)
    assert parameter.value(PROBABILITIES) == pytest.approx(exact.ppf(PROBABILITIES), rel=1e-10)
    at = np.linspace(0.01, 0.99, 25)
    assert parameter.density(at) == pytest.approx(1.3 * exact.pdf(0.2 + 1.3 * at), rel=1e-10)


class Nothing:
    """A surrogate that knows nothing of the parameters: every draw has the weight of the prior."""

    def predict(self, places):
        return np.zeros(len(places)), np.zeros(len(places))


# 2^14 Sobol points: quantiles within 0.2 % of the range.
def test_the_posterior_without_information_is_the_prior():
    parameters = [Parameter("a", 1e-3, 1.0, "log-uniform"), Parameter("b", 0.2, 1.5, "normal", 0.5, 0.4)]
    posterior = posterior_of(Plan(parameters, [Target("y", 0.0, 1.0)]), [Nothing()])
    assert posterior.effective == pytest.approx(1 << 14)
    wanted = [0.05, 0.5, 0.95]
    found = posterior.quantiles(wanted)
    assert parameters[0].scaled(found[0]) == pytest.approx(wanted, abs=0.002)
    exact = truncnorm((0.2 - 0.5) / 0.4, (1.5 - 0.5) / 0.4, 0.5, 0.4)
    assert found[1] == pytest.approx(exact.ppf(wanted), abs=0.0026)


def test_errors_of_points_pool_the_scatter():
    nan = np.nan
    values = np.array([[1.0, 2.0, 3.0], [5.0, 5.0, nan], [7.0, nan, nan], [nan, nan, nan]])
    means = means_of(values)
    assert list(means.rows) == [0, 1] and list(means.count) == [3, 2, 1, 0]
    assert means.mean == pytest.approx([2.0, 5.0])
    pooled = (2.0 + 0.0) / (2 + 1)
    assert means.deviation == pytest.approx(pooled**0.5)
    own = np.array([(2.0 + POOL_WEIGHT * pooled) / (2 + POOL_WEIGHT), POOL_WEIGHT * pooled / (1 + POOL_WEIGHT)])
    assert means.error == pytest.approx(np.sqrt(own / [3, 2]))


# Any hyperparameters: n measurements of one place with errors e and a prior variance c leave 1 / (1/c + sum 1/e^2).
# Without the nugget it would be nothing.
def test_repeated_measurements_leave_the_variance_of_theory():
    error = np.array([0.3, 0.5, 0.4, 0.6])
    surrogate = Surrogate(np.full((4, 1), 0.5), np.array([1.0, 1.4, 0.7, 1.9]), error, seed=1)
    expected = 1.0 / (surrogate.amplitude**-2 + np.sum(error**-2.0))
    mean, variance = surrogate.predict(np.array([[0.5]]))
    assert variance[0] == pytest.approx(expected, rel=1e-9)
    update = surrogate.update(np.array([[0.5], [0.9]]), 0.2)
    gain = update.gain(np.array([1.0, 0.0]))[0]
    update.add(0)
    after = 1.0 / (1.0 / expected + 0.2**-2)
    assert update.variance[0] == pytest.approx(after, rel=1e-9)
    assert gain == pytest.approx(expected - after, rel=1e-9)


def test_predictions_are_those_of_the_library():
    random = np.random.default_rng(5)
    places, values = random.random((15, 2)), random.standard_normal(15)
    surrogate = Surrogate(places, values, np.full(15, 0.2), seed=1)
    at = random.random((40, 2))
    mean, deviation = surrogate.process.predict(at, return_std=True)
    found, variance = surrogate.predict(at)
    assert found == pytest.approx(surrogate.centre + surrogate.scale * mean, rel=1e-9, abs=1e-9)
    assert np.sqrt(variance) == pytest.approx(surrogate.scale * deviation, rel=1e-6, abs=1e-9)
    assert surrogate.update(at, 0.1).variance == pytest.approx(variance, rel=1e-6, abs=1e-12)


@pytest.mark.parametrize("sequence", ["sobol", "halton"])
def test_first_points_are_even_in_the_prior(sequence):
    parameters = [Parameter("a", 1e-3, 1.0, "log-uniform"), Parameter("b", 0.0, 2.0)]
    plan = Plan(parameters, [], Design(start=24, sequence=sequence))
    places = plan.scaled(design.first_points(plan))
    assert places.shape == (24, 2)
    counts = np.histogram2d(*places.T, 2, [(0, 1), (0, 1)])[0]
    assert counts.min() >= 4  # 6 each on average
    assert np.array_equal(design.first_points(plan), design.first_points(plan))


def test_quantiles_of_equal_weights():
    values = np.random.default_rng(2).random(1001)
    found = weighted_quantiles(values, np.full(1001, 1 / 1001), [0.05, 0.5, 0.95])
    assert found == pytest.approx(np.quantile(values, [0.05, 0.5, 0.95]), abs=1e-3)


def weighted(weight, chi_square):
    places = np.linspace(0.0005, 0.9995, 1000)[:, None]
    weight = weight(places[:, 0])
    none = np.zeros((1, 1000))
    return Posterior(places, 2.0 * places, weight / weight.sum(), none, none, np.full(1000, chi_square))


@pytest.mark.parametrize("weight, chi_square, words", [
    (lambda x: np.exp(-(((x - 0.5) / 0.1) ** 2)), 0.1, []),
    (lambda x: np.exp(-x / 0.1), 0.1, ["touches the low end of the range, 0"]),
    (lambda x: np.exp((x - 1.0) / 0.1), 0.1, ["touches the high end of the range, 2"]),
    (lambda x: np.exp(-(((x - 0.5) / 0.1) ** 2)), 9.0, ["no point in the ranges reaches the targets"]),
    (lambda x: np.exp(-(((x - 0.5) / 0.01) ** 2)), 0.1, ["effective draws"]),
])  # fmt: skip
def test_warnings(weight, chi_square, words):
    plan = Plan([Parameter("a", 0.0, 2.0)], [Target("y", 0.0, 1.0)])
    lines = warnings_of(plan, weighted(weight, chi_square))
    assert len(lines) == len(words) and all(word in line for word, line in zip(words, lines)), lines


def test_ratios_are_in_errors_of_the_targets():
    posterior = weighted(lambda x: np.ones_like(x), 0.0)
    posterior.variance[:] = 4.0
    assert Fit([], [], posterior).ratios(Plan([], [Target("y", 0.0, 0.5)])) == pytest.approx([4.0])
