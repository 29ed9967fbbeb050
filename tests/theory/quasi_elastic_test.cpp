// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/quasi_elastic.hpp"

#include <gtest/gtest.h>

namespace repose::theory {
namespace {

// The stresses of a purely vertical strain of 1, from the Lame constants.
TEST(QuasiElastic, IsTheConfinedElasticColumn) {
  for (const double nu : {-0.99, -0.3, 0.1, 0.3, 0.499}) {
    const double lame = nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    const double shear_modulus = 0.5 / (1.0 + nu);
    EXPECT_NEAR(stress_ratio({.poisson_ratio = nu}), lame / (lame + 2.0 * shear_modulus), 1e-14) << nu;
  }
  EXPECT_EQ(stress_ratio({.poisson_ratio = 0.5}), 1.0);  // a liquid
  EXPECT_EQ(stress_ratio({.poisson_ratio = 0.0}), 0.0);
}

}  // namespace
}  // namespace repose::theory
