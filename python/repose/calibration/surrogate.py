# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""A Gaussian process for the mean of a measure over the parameters; its nugget is the scatter between seeds."""

import warnings

import numpy as np
from scipy.linalg import solve_triangular
from sklearn.exceptions import ConvergenceWarning
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import ConstantKernel, Matern

AMPLITUDE = (1e-2, 1e4)  # bounds of the variance, in that of the means
LENGTH = (0.05, 30.0)  # bounds of length scales, in ranges of the parameters
RESTARTS = 4
SMALLEST_NUGGET = 1e-8  # in the variance of the means: keeps the matrix sound where seeds do not scatter
BLOCK = 1 << 14  # points predicted at a time


class Surrogate:
    """A Gaussian process with kernel constant times Matern 5/2, a length for each parameter (Rasmussen & Williams 2006,
    eqs. 2.25, 2.26 and 4.17). Hyperparameters have the largest likelihood of a search with restarts.

    Validated by python/tests/test_calibration_parts.py."""

    def __init__(self, places, mean, error, seed, restarts=RESTARTS):
        """Places (P, d) from 0 to 1, means (P) and their standard errors (P) in the unit of the measure."""
        self.centre = float(np.mean(mean))
        self.scale = float(np.std(mean)) or 1.0
        d = places.shape[1]
        kernel = ConstantKernel(1.0, AMPLITUDE) * Matern(np.full(d, 0.5), [LENGTH] * d, nu=2.5)
        nugget = np.maximum((error / self.scale) ** 2, SMALLEST_NUGGET)
        self.process = GaussianProcessRegressor(kernel, alpha=nugget, n_restarts_optimizer=restarts, random_state=seed)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ConvergenceWarning)  # a length at its bound: the parameter does not matter
            self.process.fit(places, (mean - self.centre) / self.scale)
        self.kernel = self.process.kernel_

    @property
    def amplitude(self):
        """Standard deviation of the process, in the unit of the measure."""
        return float(np.sqrt(self.kernel.k1.constant_value)) * self.scale

    @property
    def lengths(self):
        """Length scales (d), in ranges of the parameters."""
        return np.atleast_1d(self.kernel.k2.length_scale)

    def predict(self, places):
        """Mean (n) and variance (n) of the measure's mean at places (n, d)."""
        parts = [self._block(places[k : k + BLOCK]) for k in range(0, len(places), BLOCK)]
        return tuple(np.concatenate(part) for part in zip(*parts))

    def _block(self, places):
        covariance = self.kernel(places, self.process.X_train_)
        mean = self.centre + self.scale * (covariance @ self.process.alpha_)
        whitened = solve_triangular(self.process.L_, covariance.T, lower=True, check_finite=False)
        variance = self.kernel.diag(places) - np.einsum("ij,ij->j", whitened, whitened)
        return mean, self.scale**2 * np.maximum(variance, 0.0)

    def update(self, places, error):
        """An Update for points to come whose means have this standard error, among places (n, d)."""
        return Update(self, places, error)


class Update:
    """The covariance of a surrogate at n places after more measurements. It does not depend on their values."""

    def __init__(self, surrogate, places, error):
        covariance = surrogate.kernel(places, surrogate.process.X_train_)
        whitened = solve_triangular(surrogate.process.L_, covariance.T, lower=True, check_finite=False)
        self.unit = surrogate.scale**2
        self.nugget = max((error / surrogate.scale) ** 2, SMALLEST_NUGGET)
        self.covariance = surrogate.kernel(places) - whitened.T @ whitened  # (n, n) in the variance of the means

    @property
    def variance(self):
        """Variances (n), in the square of the unit of the measure."""
        return self.unit * np.maximum(np.diag(self.covariance), 0.0)

    def gain(self, weight):
        """By how much a measurement at each place (n) lowers the variance summed over all places with weights (n), in
        the square of the unit of the measure (Cohn, Ghahramani & Jordan 1996)."""
        variance = np.maximum(np.diag(self.covariance), 0.0) + self.nugget
        return self.unit * (self.covariance**2 @ weight) / variance

    def add(self, row):
        """Adds a measurement at the place of this row."""
        column = self.covariance[:, row]
        self.covariance = self.covariance - np.outer(column, column) / (max(column[row], 0.0) + self.nugget)
