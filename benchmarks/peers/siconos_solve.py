#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Solves a contact problem in 2D with NSGS of Siconos (Debian's python3-siconos), the nonsmooth Gauss-Seidel method.

Siconos runs in its fastest mode: the matrix in blocks of 2 x 2, each contact solved exactly with the effect of its
neighbours from their blocks, without evaluation of its own error between iterations. Only the iterations are timed, not
the building of the matrix and not the independent residual that decides when to stop.

usage: siconos_solve.py FILE [--tolerance T | --iterations N] [--warm] [--seconds S]
"""

import argparse
import json
import time
import warnings

import numpy as np
import scipy.sparse
import siconos.numerics as siconos
from contact_problem import NORMAL, TANGENTIAL, contact_velocities, read_problem, residual

ERROR_EVALUATION = siconos.SICONOS_FRICTION_3D_IPARAM_ERROR_EVALUATION
LIGHT = siconos.SICONOS_FRICTION_3D_NSGS_ERROR_EVALUATION_LIGHT


def matrix_to_contacts(problem):
    """H as a sparse matrix: the rows are the normal and tangential velocity of one contact after the other, the columns
    the velocity components of one body after the other."""
    contacts = len(problem.friction)
    parts = [NORMAL, TANGENTIAL]
    rows, columns, values = [], [], []
    for side, blocks in enumerate((problem.to_first, problem.to_second)):
        row, column = np.arange(2 * contacts).reshape(-1, 2, 1), 3 * problem.bodies[:, side].reshape(-1, 1, 1)
        rows.append(np.broadcast_to(row, (contacts, 2, 3)).ravel())
        columns.append(np.broadcast_to(column + np.arange(3), (contacts, 2, 3)).ravel())
        values.append(blocks[:, parts].ravel())
    place = np.concatenate(rows), np.concatenate(columns)
    return scipy.sparse.csr_matrix((np.concatenate(values), place), (2 * contacts, problem.inverse_mass.size))


class Nsgs:
    """The problem in the form of Siconos, u = W p + q with W = H M^-1 H^T, and the number of iterations so far."""

    def __init__(self, problem, warm=False):
        if problem.rolling_friction.any() or not np.isfinite(problem.friction).all():
            raise ValueError("NSGS of Siconos in 2D knows neither rolling friction nor infinite friction")
        self.problem = problem
        self.contacts = len(problem.friction)
        h = matrix_to_contacts(problem)
        w = (h @ scipy.sparse.diags(problem.inverse_mass.ravel()) @ h.T).tocsc()
        self.matrix = siconos.NM_create(siconos.NM_SPARSE_BLOCK, *w.shape)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of a conversion of indices
            failed, self.matrix.matrix1 = siconos.SBM_from_csparse(2, w)
        assert not failed
        self.posed = siconos.FrictionContactProblem()
        self.posed.dimension = 2
        self.posed.numberOfContacts = self.contacts
        self.posed.M = self.matrix
        self.posed.q = contact_velocities(problem, problem.free_velocity)[:, [NORMAL, TANGENTIAL]].ravel()
        self.posed.mu = np.ascontiguousarray(problem.friction)
        self.options = siconos.SolverOptions(siconos.SICONOS_FRICTION_2D_NSGS)
        self.options.dparam[siconos.SICONOS_DPARAM_TOL] = 0.0
        self.options.iparam[ERROR_EVALUATION] = LIGHT
        self.impulses = np.zeros(2 * self.contacts)
        if warm:
            self.impulses[:] = problem.start[:, [NORMAL, TANGENTIAL]].ravel()
        self.velocities = np.zeros(2 * self.contacts)
        self.iterations = 0
        self.cpu_seconds = 0.0

    def iterate(self, count):
        self.options.iparam[siconos.SICONOS_IPARAM_MAX_ITER] = count
        start = time.process_time()
        siconos.fc2d_nsgs_sbm(self.posed, self.impulses, self.velocities, self.options)
        self.cpu_seconds += time.process_time() - start
        self.iterations += int(self.options.iparam[siconos.SICONOS_IPARAM_ITER_DONE])

    def residual(self):
        impulses = np.zeros((self.contacts, 3))
        impulses[:, [NORMAL, TANGENTIAL]] = self.impulses.reshape(-1, 2)
        return residual(self.problem, impulses)["worst"]

    def solve(self, tolerance, seconds):
        """Iterates until the independent residual, computed every 5 % of the iterations, is within the tolerance, or until
    the CPU time is used up."""
        while self.residual() > tolerance and self.cpu_seconds < seconds:
            self.iterate(max(5, self.iterations // 20))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("--tolerance", type=float, default=1e-4, help="of the outside residual (default: 1e-4)")
    parser.add_argument("--iterations", type=int, help="so many, whatever the residual")
    parser.add_argument("--warm", action="store_true", help="from the impulses of the file, not from none")
    parser.add_argument("--seconds", type=float, default=60.0, help="CPU time at most (default: 60)")
    options = parser.parse_args()
    nsgs = Nsgs(read_problem(options.file), options.warm)
    if options.iterations:
        nsgs.iterate(options.iterations)
    else:
        nsgs.solve(options.tolerance, options.seconds)
    found = {
        "contacts": nsgs.contacts,
        "iterations": nsgs.iterations,
        "contact_iterations": nsgs.iterations * nsgs.contacts,
        "cpu_seconds": nsgs.cpu_seconds,
        "residual": nsgs.residual(),
    }
    print(json.dumps(found))


if __name__ == "__main__":
    main()
