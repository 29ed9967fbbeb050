// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/response.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

std::string cell(double x) { return std::isnan(x) ? "" : fmt::format("{}", x); }

nlohmann::ordered_json number(double x) {
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json estimate(const Estimate& value) {
  return {{"mean", number(value.mean)}, {"error", number(value.error)}};
}

}  // namespace

std::string response_csv(const std::vector<PointResponse>& responses) {
  std::string text = "point,x_over_h,response,response_error,elastic,osl,diffusive,elastic_fitted\n";
  for (const auto& response : responses) {
    for (std::size_t k = 0; k < response.x.size(); ++k) {
      text += fmt::format("{},{},{},{}", response.name, response.x[k] + 0.0, cell(response.bins[k].mean),
                          cell(response.bins[k].error));
      for (const auto& curve : response.curves) text += fmt::format(",{}", cell(curve.values[k]));
      text += response.curves.size() < 4 ? ",\n" : "\n";
    }
  }
  return text;
}

std::string response_json(const std::vector<PointResponse>& responses) {
  auto all = nlohmann::ordered_json::array();
  for (const auto& response : responses) {
    nlohmann::ordered_json curves;
    for (const auto& curve : response.curves) {
      curves[curve.name] = {{"chi_square", number(curve.chi_square)},
                            {"bins", response.x.size()},
                            {"peak", number(*std::ranges::max_element(curve.values))}};
    }
    all.push_back({{"point", response.name},
                   {"without", response.without},
                   {"places", response.places},
                   {"seeds", response.depth.count},
                   {"force", response.force},
                   {"depth", estimate(response.depth)},
                   {"bin", response.bin},
                   {"total", estimate(response.total)},
                   {"second_moment", estimate(response.second_moment)},
                   {"centre", estimate(response.bins[response.bins.size() / 2])},
                   {"nonlinearity", number(response.nonlinearity)},
                   {"poisson", response.poisson},
                   {"fitted_poisson", number(response.fitted_poisson)},
                   {"eta", response.eta},
                   {"curves", curves}});
  }
  return all.dump(2) + "\n";
}

}  // namespace repose
