// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/q_model_layers.hpp"

#include "repose/core/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace repose::theory {

namespace {

/// The random numbers of one site in one layer of one run.
struct Stream {
  std::uint64_t seed;
  std::uint64_t index;
  std::uint32_t draw = 0;
  double next() { return uniform(seed, Purpose::force_fraction, index, draw++); }  // in [0, 1)
};

/// The logarithm of a Gamma(shape) variate, by Marsaglia & Tsang (2000): a variate of shape + 1, times U^(1/shape). The
/// logarithm does not underflow for small shapes.
double log_gamma_variate(double shape, Stream& random) {
  const double d = shape + 1.0 - 1.0 / 3.0;
  const double c = 1.0 / std::sqrt(9.0 * d);
  for (;;) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - random.next()));
    const double normal = radius * std::cos(2.0 * std::numbers::pi * random.next());
    const double log_u = std::log(1.0 - random.next());
    const double root = 1.0 + c * normal;
    if (root <= 0.0) continue;
    const double v = root * root * root;
    if (log_u < 0.5 * normal * normal + d - d * v + d * std::log(v)) {
      return std::log(d * v) + std::log(1.0 - random.next()) / shape;
    }
  }
}

enum class Kind { uniform, dirichlet, fixed, critical };

Kind kind_of(const QModel& model) {
  if (model.distribution == "uniform") return Kind::uniform;
  if (model.distribution == "dirichlet") return Kind::dirichlet;
  return model.distribution == "fixed" ? Kind::fixed : Kind::critical;
}

/// Draws the fractions of the receivers into the front of `fractions`. The entry of the last receiver is not used: it
/// gets the rest, so that weight is conserved to rounding.
void draw_fractions(Kind kind, double shape, std::size_t count, Stream random, std::vector<double>& fractions) {
  if (kind == Kind::fixed) {
    std::fill_n(fractions.begin(), count, 1.0 / static_cast<double>(count));
  } else if (kind == Kind::critical) {
    std::fill_n(fractions.begin(), count, 0.0);
    fractions[static_cast<std::size_t>(random.next() * static_cast<double>(count))] = 1.0;
  } else if (kind == Kind::uniform && count == 2) {
    fractions[0] = random.next();
  } else {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < count; ++k) {
      fractions[k] =
          kind == Kind::uniform ? std::log(-std::log(1.0 - random.next())) : log_gamma_variate(shape, random);
      most = std::max(most, fractions[k]);
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < count; ++k) sum += fractions[k] = std::exp(fractions[k] - most);
    for (std::size_t k = 0; k < count; ++k) fractions[k] /= sum;
  }
}

}  // namespace

void each_layer(const QModel& model, std::int64_t run,
                const std::function<void(std::int64_t layer, const std::vector<double>& weights)>& show) {
  const auto width = static_cast<std::size_t>(model.width);
  const auto kind = kind_of(model);
  const double shape = shape_of(model);
  const auto stream = [&](std::int64_t layer, std::int64_t site) {
    const auto place = (run * (model.layers + 1) + layer) * model.width + site;
    return Stream{static_cast<std::uint64_t>(model.seed), static_cast<std::uint64_t>(place)};
  };
  std::vector<double> weights(width, 0.0);
  std::vector<double> below(width);
  std::vector<double> fractions(static_cast<std::size_t>(model.neighbours));
  if (model.start == "gamma") {
    const double scale = 1.0 / (static_cast<double>(model.neighbours) * shape);
    for (std::int64_t i = 0; i < model.width; ++i) {
      auto random = stream(model.layers, i);  // the last layer passes nothing on
      const auto giving = static_cast<double>(receivers(model, 0, i).count());
      weights[static_cast<std::size_t>(i)] = scale * std::exp(log_gamma_variate(giving * shape, random));
    }
  }
  show(0, weights);
  for (std::int64_t layer = 0; layer < model.layers; ++layer) {
    std::ranges::fill(below, static_cast<double>(model.injection));
    for (std::int64_t i = 0; i < model.width; ++i) {
      const auto to = receivers(model, layer, i);
      const auto count = static_cast<std::size_t>(to.count());
      draw_fractions(kind, shape, count, stream(layer, i), fractions);
      const double weight = weights[static_cast<std::size_t>(i)];
      double left = weight;
      for (std::size_t k = 0; k < count; ++k) {
        const double given = k + 1 == count ? left : fractions[k] * weight;
        auto site = to.first + static_cast<std::int64_t>(k);
        if (site < 0) site += model.width;
        if (site >= model.width) site -= model.width;
        below[static_cast<std::size_t>(site)] += given;
        left -= given;
      }
    }
    weights.swap(below);
    show(layer + 1, weights);
  }
}

}  // namespace repose::theory
