// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/statistics.hpp"
#include "repose/record/record.hpp"
#include "repose/sweep/table.hpp"

#include <functional>
#include <string>
#include <vector>

namespace repose {

/// A curve of theory in the bins of a response, and its distance from the response.
struct ResponseCurve {
  std::string name;            ///< elastic (layer on a rough rigid floor), osl, diffusive, elastic_fitted
  std::vector<double> values;  ///< [F/h] by bin
  double chi_square = 0.0;     ///< NaN without errors of the response
};

/// Response of a bed to one downward force F on a grain a height h above the centres of its base: the normal force on
/// the base with the load less that without it, of members with the same seed. Points of a sweep whose scenes differ in
/// the place of the load alone belong to one response: a seed counts once, with the mean over its places, because
/// errors are between seeds. Validated by tests/unit/point_response_test.cpp and tests/cli/test_theory_network.py.
struct PointResponse {
  std::string name;            ///< of the first point with the load
  std::string without;         ///< point without a load
  std::size_t places = 0;      ///< of the load, each a point
  double force = 0.0;          ///< [grain weights]
  Estimate depth;              ///< [L] h, over seeds
  double bin = 0.0;            ///< [h] width of a bin: whole pitches of the base, at least 0.1 h
  std::vector<double> x;       ///< [h] middle of each bin, from below the load
  std::vector<Estimate> bins;  ///< [F/h] response, over seeds
  Estimate total;              ///< [F] force that reaches the base
  Estimate second_moment;      ///< [h^2] of the response within 2 h
  double nonlinearity =
      0.0;               ///< relative rms difference from an earlier response of other force, same seeds and places
  double poisson = 0.0;  ///< of the elastic curve: (1 - k_t/k_n)/4, of a random network of such springs
  double fitted_poisson = 0.0;  ///< of the elastic curve of least chi-square; NaN without errors of the response
  double eta = 0.0;             ///< of OSL: tan^2 of the angle at which a grain sits in the hollow of the base row
  std::vector<ResponseCurve> curves;
};

/// Responses in the order of the plan; none where no points differ in a load alone. `state` gives the last state of a
/// member by its number in the table.
std::vector<PointResponse> point_responses(const SweepPlan& plan, const SweepTable& table,
                                           const std::function<Record<2>(std::size_t member)>& state);

/// One row per bin of each response; and everything else, one object per response.
std::string response_csv(const std::vector<PointResponse>& responses);
std::string response_json(const std::vector<PointResponse>& responses);

}  // namespace repose
