// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/q_model.hpp"

#include "repose/theory/q_model_layers.hpp"
#include "repose/theory/q_model_moments.hpp"

#include <boost/math/distributions/gamma.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace repose::theory {

namespace {

/// The mean and standard error of a quantity over independent runs, added one by one (Welford).
struct BetweenRuns {
  double mean = 0.0;
  double squares = 0.0;
  double count = 0.0;

  void add(double value) {
    count += 1.0;
    const double off = value - mean;
    mean += off / count;
    squares += off * (value - mean);
  }
  double error() const { return std::sqrt(squares / (count - 1.0) / count); }
};

/// The mean of (w/mean - 1)^2 over the sites of a layer.
double spread(const std::vector<double>& weights, double mean) {
  double sum = 0.0;
  for (const double w : weights) sum += (w / mean - 1.0) * (w / mean - 1.0);
  return sum / static_cast<double>(weights.size());
}

Table variance_table(const QModel& model) {
  std::vector<BetweenRuns> runs(static_cast<std::size_t>(model.layers));
  for (std::int64_t run = 0; run < model.runs; ++run) {
    each_layer(model, run, [&](std::int64_t layer, const std::vector<double>& weights) {
      if (layer > 0) runs[static_cast<std::size_t>(layer - 1)].add(spread(weights, mean_weight(model, layer)));
    });
  }
  Column layers{"layer", "1", "D, counted from the top", {}, {}};
  Column variance{"variance", "1", "variance of the weight of a site over mean^2, mean of the runs", {}, {}};
  Column error{"variance_error", "1", "standard error between the runs", {}, {}};
  Column exact{"exact", "1", "variance by the exact recursion of the two-point moments", {}, {}};
  exact.values = exact_variance(model);
  exact.values.erase(exact.values.begin());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    layers.values.push_back(static_cast<double>(k + 1));
    variance.values.push_back(runs[k].mean);
    error.values.push_back(runs[k].error());
  }
  return {{std::move(layers), std::move(variance), std::move(error), std::move(exact)}, {}};
}

/// The bin of a weight in units of the mean; `bins` if it lies beyond the last.
std::size_t bin_of(const QModel& model, double weight) {
  const double place = weight / model.largest * static_cast<double>(model.bins);
  return static_cast<std::size_t>(std::min(place, static_cast<double>(model.bins)));
}

Table distribution_table(const QModel& model) {
  const auto bins = static_cast<std::size_t>(model.bins);
  const double bin = model.largest / static_cast<double>(model.bins);
  const double mean = mean_weight(model, model.layers);
  std::vector<BetweenRuns> density(bins + 1);
  BetweenRuns variance;
  for (std::int64_t run = 0; run < model.runs; ++run) {
    each_layer(model, run, [&](std::int64_t layer, const std::vector<double>& weights) {
      if (layer < model.layers) return;
      std::vector<std::int64_t> counts(bins + 1, 0);
      for (const double w : weights) ++counts[bin_of(model, w / mean)];
      const double each = 1.0 / (static_cast<double>(model.width) * bin);
      for (std::size_t k = 0; k <= bins; ++k) density[k].add(static_cast<double>(counts[k]) * each);
      variance.add(spread(weights, mean));
    });
  }
  Table table;
  Column centre{"weight", "mean weight", "middle of a bin", {}, {}};
  Column dense{"density", "1 / mean weight", "density of weights in the last layer, mean of the runs", {}, {}};
  Column error{"density_error", "1 / mean weight", "standard error between the runs", {}, {}};
  Column exact{"exact", "1 / mean weight", "Gamma(N r) distribution, at the middle of the bin", {}, {}};
  Column in_bin{"exact_in_bin", "1 / mean weight", "Gamma(N r) distribution, averaged over the bin", {}, {}};
  const double shape = static_cast<double>(model.neighbours) * shape_of(model);
  const bool known = shape > 0.0 && std::isfinite(shape);
  for (std::size_t k = 0; k < bins; ++k) {
    const double low = bin * static_cast<double>(k);
    centre.values.push_back(low + 0.5 * bin);
    dense.values.push_back(density[k].mean);
    error.values.push_back(density[k].error());
    if (!known) continue;
    const boost::math::gamma_distribution<double> gamma(shape, 1.0 / shape);
    exact.values.push_back(boost::math::pdf(gamma, low + 0.5 * bin));
    in_bin.values.push_back((boost::math::cdf(gamma, low + bin) - boost::math::cdf(gamma, low)) / bin);
  }
  table.columns = {std::move(centre), std::move(dense), std::move(error)};
  if (known) {
    table.columns.push_back(std::move(exact));
    table.columns.push_back(std::move(in_bin));
  }
  table.numbers = {{"beyond", density[bins].mean * bin, "1", "fraction of the weights beyond the last bin"},
                   {"variance", variance.mean, "1", "variance of the weight of a site over mean^2, mean of the runs"},
                   {"variance_error", variance.error(), "1", "standard error between the runs"},
                   {"variance_exact", exact_variance(model).back(), "1",
                    "variance by the exact recursion of the two-point moments"}};
  return table;
}

}  // namespace

Receivers receivers(const QModel& model, std::int64_t layer, std::int64_t site) {
  const auto n = model.neighbours;
  Receivers to;
  to.first = site - (layer % 2 == 0 ? n / 2 : (n - 1) / 2);
  to.last = to.first + n;
  if (model.edges == "walls") to = {std::max<std::int64_t>(to.first, 0), std::min(to.last, model.width)};
  return to;
}

double shape_of(const QModel& model) {
  if (model.distribution == "uniform") return 1.0;
  if (model.distribution == "fixed") return std::numeric_limits<double>::infinity();
  return model.distribution == "critical" ? 0.0 : model.shape;
}

double mean_weight(const QModel& model, std::int64_t layer) {
  double start = 0.0;
  if (model.start == "gamma") {
    std::int64_t links = 0;
    for (std::int64_t i = 0; i < model.width; ++i) links += receivers(model, 0, i).count();
    start = static_cast<double>(links) / static_cast<double>(model.neighbours * model.width);
  }
  return start + static_cast<double>(layer * model.injection);
}

void parameters(QModel& model, Parameters& to) {
  to.integer("width", model.width, {.low = 2, .high = 1'000'000}, "sites in a layer");
  to.integer("layers", model.layers, {.low = 1, .high = 1'000'000}, "number of layers below the first");
  to.integer("neighbours", model.neighbours, {.low = 2, .high = 100},
             "N, sites below to which a site gives its weight");
  to.choice("distribution", model.distribution, {"uniform", "dirichlet", "fixed", "critical"},
            "of the fractions q, whose sum is 1: uniform, Dirichlet with a shape, 1/N each, or all to one site");
  to.number("shape", model.shape, {.low = 0.01, .high = 1e4}, "1", "r of the Dirichlet distribution; 1 is uniform");
  to.choice("edges", model.edges, {"periodic", "walls"},
            "with walls, a site beside one gives all its weight to its neighbours inside");
  to.integer("injection", model.injection, {.low = 0, .high = 1}, "weight of each grain");
  to.choice("start", model.start, {"zero", "gamma"}, "weights of layer 0: none, or Gamma(N r) of mean 1");
  to.integer("runs", model.runs, {.low = 2, .high = 100'000}, "independent runs, whose scatter gives standard errors");
  to.integer("seed", model.seed, {.low = 0}, "seed of the random numbers");
  to.choice("output", model.output, {"distribution", "variance"},
            "distribution of weights in the last layer, or their variance in each layer");
  to.integer("bins", model.bins, {.low = 1, .high = 100'000}, "bins of the distribution");
  to.number("largest", model.largest, {.low = 0.0, .low_allowed = false}, "mean weight", "end of the last bin");
}

std::vector<std::string> relations(const QModel& model) {
  std::vector<std::string> problems;
  if (model.width < model.neighbours) {
    problems.push_back(fmt::format("width = {}: must be >= neighbours ({})", model.width, model.neighbours));
  }
  const bool gamma_known = model.distribution == "uniform" || model.distribution == "dirichlet";
  if (model.start == "gamma" && !gamma_known) {
    problems.push_back(
        fmt::format("start = gamma: needs distribution = uniform | dirichlet, not {}", model.distribution));
  }
  constexpr double most_steps = 1e10;  // about a quarter of an hour
  const double steps = static_cast<double>(model.width) * static_cast<double>(model.layers) *
                       static_cast<double>(model.neighbours) * static_cast<double>(model.runs);
  if (steps > most_steps) {
    problems.push_back(
        fmt::format("width, layers, neighbours and runs: their product is {:g}; must be <= {:g}", steps, most_steps));
  }
  if (model.start == "zero" && model.injection == 0) {
    problems.emplace_back("injection = 0: needs start = gamma; otherwise all weights are 0");
  }
  if (model.edges == "walls" && model.width > 4000) {
    problems.push_back(fmt::format(
        "width = {}: must be <= 4000 with edges = walls (exact moments of all pairs of sites)", model.width));
  }
  return problems;
}

Table evaluate(const QModel& model) {
  return model.output == "variance" ? variance_table(model) : distribution_table(model);
}

}  // namespace repose::theory
