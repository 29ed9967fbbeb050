// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose::theory {

/// Scalar model of force chains: each site passes its weight on to `neighbours` sites of the next layer, in random
/// fractions that add up to 1: w(j, D+1) = injection + sum_i q_ij(D) w(i, D). Lengths in sites, weights in the weight
/// of one grain. Source: Liu et al. (1995), Coppersmith et al. (1996); Bratberg (2003), eqs (50)-(51). Validated by
/// tests/theory/q_model_test.cpp.
struct QModel {
  std::int64_t width = 200;              ///< sites in a layer, at least `neighbours`
  std::int64_t layers = 200;             ///< that weight is passed through
  std::int64_t neighbours = 2;           ///< N, that each site gives to
  std::string distribution = "uniform";  ///< of the fractions: uniform, dirichlet, fixed (1/N), critical (all to one)
  double shape = 2.0;                    ///< r of "dirichlet": fractions are Gamma(r) variates over their sum
  std::string edges = "periodic";        ///< or "walls"
  std::int64_t injection = 1;            ///< weight of each grain, 1 or 0
  std::string start = "zero";            ///< or "gamma": Gamma(N r) of mean 1, which the fractions leave as it is
  std::int64_t runs = 20;                ///< independent; standard errors are between them
  std::int64_t seed = 1;
  std::string output = "distribution";  ///< or "variance"
  std::int64_t bins = 60;
  double largest = 6.0;  ///< right edge of the last bin, per mean

  static constexpr ModelText text{.name = "q-model",
                                  .about = "Scalar model of weights passed on in random fractions from layer to layer",
                                  .source = "Liu et al. 1995, Coppersmith et al. 1996; Bratberg 2003, eqs (50)-(51)"};
};

/// Sites first <= j < last of the next layer that site i of a layer gives to. Odd layers lie half a site to the right
/// of even ones (N even). Past the ends in a periodic model; at a wall only those inside.
struct Receivers {
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::int64_t count() const { return last - first; }
};
Receivers receivers(const QModel& model, std::int64_t layer, std::int64_t site);

/// r of the fractions: 1 if uniform; infinite if fixed, 0 if critical.
double shape_of(const QModel& model);

/// Mean weight of a site in a layer, exact.
double mean_weight(const QModel& model, std::int64_t layer);

void parameters(QModel& model, Parameters& to);
std::vector<std::string> relations(const QModel& model);

/// distribution: columns weight, density, density_error, exact, exact_in_bin (the last two where a Gamma distribution
/// is known), of the last layer; variance: columns layer, variance, variance_error, exact, for layers 1 and on.
Table evaluate(const QModel& model);

}  // namespace repose::theory
