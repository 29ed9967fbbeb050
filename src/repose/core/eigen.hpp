// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sparse factorisations gain nothing from vector instructions. Every file must agree on them, since Eigen aligns its
// memory accordingly, and its prefetch does not compile without optimisation, as tests are.
#define EIGEN_DONT_VECTORIZE
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
