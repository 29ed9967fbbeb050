// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose::theory {

/// The scalar model of force chains. Each site passes its weight on to `neighbours` sites of the next layer, in random
/// fractions q whose sum is 1: w(j, D+1) = injection + sum_i q_ij(D) w(i, D). Lengths are in sites, weights in the
/// weight of one grain. Source: Liu et al. (1995), Coppersmith et al. (1996); Bratberg (2003), eqs (50)-(51).
/// Validated by tests/theory/q_model_test.cpp.
struct QModel {
  std::int64_t width = 200;              ///< sites in a layer, at least `neighbours`
  std::int64_t layers = 200;             ///< number of layers below the first
  std::int64_t neighbours = 2;           ///< N, the sites below to which each site gives its weight
  std::string distribution = "uniform";  ///< of the fractions: uniform, dirichlet, fixed (1/N), critical (all to one)
  double shape = 2.0;                    ///< r of "dirichlet": fractions are Gamma(r) variates over their sum
  std::string edges = "periodic";        ///< or "walls"
  std::int64_t injection = 1;            ///< weight of each grain, 1 or 0
  std::string start = "zero";            ///< or "gamma": Gamma(N r) with mean 1, the stationary distribution
  std::int64_t runs = 20;                ///< independent runs, whose scatter gives standard errors
  std::int64_t seed = 1;
  std::string output = "distribution";  ///< or "variance"
  std::int64_t bins = 60;
  double largest = 6.0;  ///< right edge of the last bin, in units of the mean

  static constexpr ModelText text{.name = "q-model",
                                  .about = "Scalar model of weights passed on in random fractions from layer to layer",
                                  .source = "Liu et al. 1995, Coppersmith et al. 1996; Bratberg 2003, eqs (50)-(51)"};
};

/// The sites first <= j < last of the next layer to which a site gives its weight. Odd layers lie half a site to the
/// right of even ones (for even N). In a periodic model j may lie outside the layer and wraps; with walls only sites
/// inside are included.
struct Receivers {
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::int64_t count() const { return last - first; }
};
Receivers receivers(const QModel& model, std::int64_t layer, std::int64_t site);

/// The shape r of the fractions: 1 if uniform, infinite if fixed, 0 if critical.
double shape_of(const QModel& model);

/// The exact mean weight of a site in a layer.
double mean_weight(const QModel& model, std::int64_t layer);

void parameters(QModel& model, Parameters& to);
std::vector<std::string> relations(const QModel& model);

/// A table. With output = distribution, its columns are weight, density, density_error, exact and exact_in_bin for the
/// last layer (the last two only if the Gamma distribution is known). With output = variance, they are layer, variance,
/// variance_error and exact, from layer 1.
Table evaluate(const QModel& model);

}  // namespace repose::theory
