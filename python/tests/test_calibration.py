# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Calibrations of formulas: nominal intervals hold the truth, a linear model has its closed form."""

import numpy as np
import pytest
from cheap_model import CheapRounds

pytest.importorskip("scipy")
pytest.importorskip("sklearn")

from repose.calibration import loop  # noqa: E402
from repose.calibration.plan import Design, Parameter, Plan, Target  # noqa: E402

CASES = 100
QUICK = loop.Options(restarts=1, powers=(12,))
NOISE = np.array([1.0, 0.01])  # between seeds
ERROR = np.array([0.8, 0.008])  # of the targets
RANGES = [Parameter("friction", 0.1, 0.9), Parameter("rolling", 0.01, 0.5, "log-uniform")]


def heap(values):
    """An angle in degrees that saturates with both frictions, and a solid fraction that falls with them."""
    friction, rolling = values.T
    angle = 10.0 + 22.0 * np.tanh(2.0 * friction) + 12.0 * rolling**0.5 * friction
    solid = 0.86 - 0.08 * friction**1.5 - 0.10 * np.log1p(8.0 * rolling) / np.log(5.0)
    return np.column_stack([angle, solid])


def held(case):
    """Which of the two nominal 90 % intervals hold the truth of a planted case, and the number of points."""
    random = np.random.default_rng([7, case])
    truth = np.array([[p.value(random.random()) for p in RANGES]])
    found = heap(truth)[0] + ERROR * random.standard_normal(2)
    targets = [Target(name, value, error) for name, value, error in zip(("angle", "solid"), found, ERROR)]
    plan = Plan(RANGES, targets, Design(start=12, most=20, stop=0.4, seed=case), seeds=3)
    measured, fit, _ = loop.calibrate(plan, CheapRounds(plan, heap, NOISE, [8, case]), options=QUICK)
    low, high = fit.posterior.quantiles([0.05, 0.95]).T
    return (low <= truth[0]) & (truth[0] <= high), len(measured.values)


def coverage(cases):
    """Fractions of cases whose intervals hold each parameter, and the mean number of points."""
    inside, points = zip(*(held(case) for case in range(cases)))
    return np.mean(inside, axis=0), np.mean(points)


# 100 cases of a true 90 % have a standard deviation of 3 %, so 80 to 97 % is +- 3 of them, less some skew.
def test_intervals_of_90_percent_hold_planted_parameters():
    fractions, points = coverage(CASES)
    print(f"coverage {fractions}, {points:.1f} points")
    assert np.all((fractions >= 0.80) & (fractions <= 0.97)), fractions
    assert 12 <= points <= 20


# The bands count the uncertainty of the surrogates: noise is large here beside the errors of the targets.
def test_a_posterior_without_the_variance_of_the_surrogates_is_too_narrow(monkeypatch):
    monkeypatch.setitem(globals(), "NOISE", 4.0 * NOISE)
    monkeypatch.setitem(globals(), "ERROR", 0.5 * ERROR)
    cases = 15
    right = coverage(cases)[0].mean()
    predict = loop.Surrogate.predict
    certain = lambda self, places: (predict(self, places)[0], np.zeros(len(places)))  # noqa: E731
    monkeypatch.setattr(loop.Surrogate, "predict", certain)
    wrong = coverage(cases)[0].mean()
    print(f"coverage {right:.2f}, without the variance {wrong:.2f}")
    assert right >= 0.80 and wrong < 0.70


LINEAR = np.array([[2.0, -1.0], [1.0, 3.0]])
OFFSET = np.array([1.0, -2.0])


def linear(values):
    return OFFSET + values @ LINEAR.T


# Means, deviations and quantiles within 1 % of the exact deviations: some thousand effective draws of a sequence that is
# more even than random leave less, and so do the cut of the priors at five deviations and surrogates of straight lines.
def test_a_linear_model_has_the_posterior_of_its_closed_form():
    parameters = [Parameter("a", -5.0, 5.0, "normal", 0.0, 1.0), Parameter("b", -5.0, 5.0, "normal", 0.5, 1.0)]
    value, error = np.array([2.5, 1.0]), np.array([0.5, 0.7])
    targets = [Target(f"y{k}", value[k], error[k]) for k in range(2)]
    plan = Plan(parameters, targets, Design(start=20, most=32, stop=0.02), seeds=2)
    _, fit, stopped = loop.calibrate(plan, CheapRounds(plan, linear, [0.0, 0.0], 1), options=loop.Options(restarts=2))
    precision = np.eye(2) + LINEAR.T @ np.diag(error**-2) @ LINEAR
    covariance = np.linalg.inv(precision)
    exact = covariance @ (np.array([0.0, 0.5]) + LINEAR.T @ ((value - OFFSET) / error**2))
    deviations = np.sqrt(np.diag(covariance))
    mean, deviation, correlation = fit.posterior.moments()
    print(stopped, (mean - exact) / deviations, deviation / deviations, correlation[0, 1])
    assert stopped == "certain"
    assert np.abs((mean - exact) / deviations).max() < 0.01
    assert deviation == pytest.approx(deviations, rel=0.01)
    assert correlation[0, 1] == pytest.approx(covariance[0, 1] / np.prod(deviations), abs=0.01)
    low, median, high = fit.posterior.quantiles([0.05, 0.5, 0.95]).T
    assert median == pytest.approx(exact, abs=0.01 * deviations.max())
    assert high - low == pytest.approx(2 * 1.6449 * deviations, rel=0.01)


def test_a_target_without_values_is_refused():
    plan = Plan(RANGES, [Target("angle", 30.0, 1.0)], Design(start=8, most=8), seeds=2)
    rounds = CheapRounds(plan, lambda values: np.where(values[:, :1] > 0.8, 30.0, np.nan), [0.1], 1)
    with pytest.raises(loop.NotCalibrated, match="angle: only . points have two values: 4 are needed"):
        loop.calibrate(plan, rounds)


def test_points_of_a_round_spread():
    plan = Plan(RANGES, [Target("angle", 30.0, 1.0)], Design(start=16, most=24, batch=8, stop=1e-9), seeds=3)
    rounds = CheapRounds(plan, lambda values: heap(values)[:, :1], [1.0], 3)
    _, fit, stopped = loop.calibrate(plan, rounds, options=QUICK)
    assert stopped == "most" and [len(values) for values in rounds.rounds] == [16, 8]
    places = plan.scaled(rounds.rounds[1])
    apart = np.linalg.norm(places[:, None] - places[None], axis=2) + 9.0 * np.eye(8)
    assert apart.min(axis=1).mean() > 0.05
    angle = heap(rounds.rounds[1])[:, 0]
    assert np.abs(angle - 30.0).max() < 6.0  # all near the valley that the target leaves
