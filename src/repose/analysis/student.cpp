// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/student.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace repose {

double student_quantile(double probability, double freedom) {
  return boost::math::quantile(boost::math::students_t(freedom), probability);
}

double student_probability(double t, double freedom) {
  if (std::isinf(t)) return t > 0.0 ? 1.0 : 0.0;
  return boost::math::cdf(boost::math::students_t(freedom), t);
}

double normal_quantile(double probability) { return boost::math::quantile(boost::math::normal(), probability); }

double normal_probability(double z) { return boost::math::cdf(boost::math::normal(), z); }

double ten_digits(double x) { return std::isfinite(x) ? std::strtod(fmt::format("{:.10g}", x).c_str(), nullptr) : x; }

}  // namespace repose
