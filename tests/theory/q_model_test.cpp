// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/q_model.hpp"

#include "repose/core/errors.hpp"
#include "repose/theory/models.hpp"
#include "repose/theory/q_model_layers.hpp"
#include "repose/theory/q_model_moments.hpp"

#include <boost/math/distributions/gamma.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <vector>

namespace repose::theory {
namespace {

std::vector<double> last_layer(const QModel& model, std::int64_t run) {
  std::vector<double> last;
  each_layer(model, run, [&](std::int64_t layer, const std::vector<double>& weights) {
    if (layer == model.layers) last = weights;
  });
  return last;
}

/// Kolmogorov-Smirnov: sqrt(n) D is below 0.5 with probability 4 % and above 1.8 with probability 0.3 %.
double kolmogorov_smirnov(std::vector<double> sample, double shape, double mean) {
  std::ranges::sort(sample);
  const boost::math::gamma_distribution<double> gamma(shape, mean / shape);
  const auto n = static_cast<double>(sample.size());
  double most = 0.0;
  for (std::size_t k = 0; k < sample.size(); ++k) {
    const double below = boost::math::cdf(gamma, sample[k]);
    most = std::max({most, below - static_cast<double>(k) / n, static_cast<double>(k + 1) / n - below});
  }
  return most * std::sqrt(n);
}

// Weight is conserved: every layer adds `width` grains, for any fractions and edges.
TEST(QModel, ConservesWeight) {
  for (const char* distribution : {"uniform", "dirichlet", "fixed", "critical"}) {
    for (const char* edges : {"periodic", "walls"}) {
      for (const std::int64_t neighbours : {2, 3, 5}) {
        const QModel model{.width = 7,
                           .layers = 40,
                           .neighbours = neighbours,
                           .distribution = distribution,
                           .shape = 0.3,
                           .edges = edges};
        each_layer(model, 0, [&](std::int64_t layer, const std::vector<double>& w) {
          const double expected = static_cast<double>(layer * model.width);
          EXPECT_NEAR(std::accumulate(w.begin(), w.end(), 0.0), expected, 1e-13 * expected + 1e-300) << distribution;
          EXPECT_GE(*std::ranges::min_element(w), layer > 0 ? 1.0 - 1e-12 : 0.0) << "weight is pressure, not tension";
        });
      }
    }
  }
}

// A site gives to as many sites as it receives from, so Gamma weights stay Gamma also beside a wall.
TEST(QModel, SitesGiveToAsManyAsTheyReceiveFrom) {
  for (const std::int64_t neighbours : {2, 3, 4, 5}) {
    const QModel model{.width = 9, .neighbours = neighbours, .edges = "walls"};
    for (const std::int64_t layer : {0, 1}) {
      std::vector<std::int64_t> from(9, 0);
      for (std::int64_t i = 0; i < 9; ++i) {
        const auto to = receivers(model, layer, i);
        EXPECT_GE(to.count(), 1);
        for (auto j = to.first; j < to.last; ++j) ++from[static_cast<std::size_t>(j)];
      }
      for (std::int64_t j = 0; j < 9; ++j) {
        EXPECT_EQ(from[static_cast<std::size_t>(j)], receivers(model, layer + 1, j).count()) << neighbours << ' ' << j;
      }
    }
  }
}

// Independent Gamma(N r) weights, distributed by Dirichlet(r) fractions, become sums of independent Gamma(r) weights.
// So their joint distribution is invariant at any width. Moments are within 4 standard errors. Kolmogorov-Smirnov
// applies to the distribution, because the sites of one layer are independent.
TEST(QModel, GammaWeightsAreInvariant) {
  struct Case {
    std::int64_t width, neighbours;
    const char* distribution;
    double shape;
  };
  for (const auto& [width, neighbours, distribution, shape] :
       {Case{8000, 2, "uniform", 1.0}, Case{8000, 3, "uniform", 1.0}, Case{8000, 2, "dirichlet", 2.5},
        Case{8000, 2, "dirichlet", 0.4}, Case{3, 2, "uniform", 1.0}}) {
    const QModel model{.width = width,
                       .layers = 30,
                       .neighbours = neighbours,
                       .distribution = distribution,
                       .shape = shape,
                       .injection = 0,
                       .start = "gamma"};
    const double r = shape_of(model) * static_cast<double>(neighbours);
    std::vector<double> sample;
    for (std::int64_t run = 0; sample.size() < 8000; ++run) {
      for (const double w : last_layer(model, run)) sample.push_back(w);
    }
    const auto n = static_cast<double>(sample.size());
    double mean = 0.0;
    double square = 0.0;
    for (const double w : sample) {
      mean += w / n;
      square += (w - 1.0) * (w - 1.0) / n;
    }
    EXPECT_NEAR(mean, 1.0, 4.0 / std::sqrt(r * n)) << width << ' ' << distribution;
    // Var (w - 1)^2 = mu4 - mu2^2 = (2 + 6/r) / r^2
    EXPECT_NEAR(square, 1.0 / r, 4.0 * std::sqrt((2.0 + 6.0 / r) / n) / r) << width << ' ' << distribution;
    const double distance = kolmogorov_smirnov(sample, r, 1.0);
    EXPECT_LT(distance, 1.8) << width << ' ' << distribution;
    EXPECT_GT(distance, 0.35) << width << ' ' << distribution << ": too near to be random";
    EXPECT_GT(kolmogorov_smirnov(sample, 1.25 * r, 1.0), 1.8) << "the test can tell a shape 25 % larger";
    for (const double v : exact_variance(model)) EXPECT_NEAR(v, 1.0 / r, 1e-12 / r);
  }
}

// Between walls a site that gives to n sites keeps Gamma(n r) with mean n/N.
TEST(QModel, GammaWeightsAreInvariantBetweenWalls) {
  const QModel model{.width = 5, .layers = 24, .neighbours = 2, .edges = "walls", .injection = 0, .start = "gamma"};
  std::vector<double> corner;
  std::vector<double> middle;
  for (std::int64_t run = 0; run < 4000; ++run) {
    const auto w = last_layer(model, run);
    corner.push_back(w[0]);
    middle.push_back(w[2]);
  }
  EXPECT_LT(kolmogorov_smirnov(corner, 1.0, 0.5), 1.8);
  EXPECT_LT(kolmogorov_smirnov(middle, 2.0, 1.0), 1.8);
  EXPECT_GT(kolmogorov_smirnov(corner, 2.0, 1.0), 1.8);
}

/// E w_i w_j of a small system from all outcomes of the critical model, where each site has N choices.
std::vector<double> enumerated(const QModel& model) {
  struct State {
    std::vector<double> weights;
    double chance;
  };
  std::vector<State> states{{std::vector<double>(static_cast<std::size_t>(model.width), 0.0), 1.0}};
  for (std::int64_t layer = 0; layer < model.layers; ++layer) {
    std::vector<State> next;
    for (auto& state : states) {
      std::vector<State> growing{{std::vector<double>(state.weights.size(), 1.0), state.chance}};
      for (std::int64_t i = 0; i < model.width; ++i) {
        const auto to = receivers(model, layer, i);
        std::vector<State> more;
        for (const auto& one : growing) {
          for (auto j = to.first; j < to.last; ++j) {
            more.push_back(one);
            more.back().chance /= static_cast<double>(to.count());
            more.back().weights[static_cast<std::size_t>((j + model.width) % model.width)] +=
                state.weights[static_cast<std::size_t>(i)];
          }
        }
        growing.swap(more);
      }
      next.insert(next.end(), growing.begin(), growing.end());
    }
    states.swap(next);
  }
  double square = 0.0;
  for (const auto& state : states) {
    for (const double w : state.weights) square += state.chance * w * w / static_cast<double>(model.width);
  }
  const double mean = mean_weight(model, model.layers);
  return {square / (mean * mean) - 1.0};
}

TEST(QModel, RecursionEqualsTheSumOverAllOutcomes) {
  for (const char* edges : {"periodic", "walls"}) {
    for (const auto& [width, neighbours, layers] : {std::array<std::int64_t, 3>{3, 2, 4}, {4, 2, 4}, {3, 3, 3}}) {
      const QModel model{
          .width = width, .layers = layers, .neighbours = neighbours, .distribution = "critical", .edges = edges};
      EXPECT_NEAR(exact_variance(model).back(), enumerated(model)[0], 1e-11) << edges << width << neighbours;
    }
  }
}

// The recursion against runs: the variance of every layer is within 4.5 standard errors, and the mean square over the
// layers, which are correlated, is of order 1.
TEST(QModel, RecursionEqualsRuns) {
  for (const char* edges : {"periodic", "walls"}) {
    for (const auto& [neighbours, distribution, shape] :
         {std::tuple<std::int64_t, const char*, double>{2, "uniform", 1.0},
          {3, "uniform", 1.0},
          {2, "dirichlet", 0.5},
          {4, "dirichlet", 3.0},
          {2, "critical", 1.0}}) {
      const QModel model{.width = 24,
                         .layers = 40,
                         .neighbours = neighbours,
                         .distribution = distribution,
                         .shape = shape,
                         .edges = edges,
                         .runs = 600,
                         .seed = 3,
                         .output = "variance"};
      const auto table = evaluate(model);
      double square = 0.0;
      for (std::size_t k = 1; k < 40; ++k) {
        const double off = (table.column("variance").values[k] - table.column("exact").values[k]) /
                           table.column("variance_error").values[k];
        EXPECT_LT(std::abs(off), 4.5) << edges << distribution << neighbours << " layer " << k + 1;
        square += off * off / 39.0;
      }
      EXPECT_LT(square, 6.0);
      EXPECT_GT(square, 0.02);
    }
  }
}

// For two neighbours with uniform fractions the variance tends to 1/2 (Gamma(2) is the limit law), slowly and from
// below. C(s), minus a third of C(0) + m^2 at s = 0, diffuses with a sink at 0 of a third of the growth of C(0) + m^2,
// that is, of D. Its value at 0 is -4/(3 sqrt pi) D^(3/2), so the variance is 1/2 - 2/sqrt(pi D) up to terms of order
// 1/D.
TEST(QModel, VarianceTendsToOneHalfSlowly) {
  const QModel model{.width = 1200, .layers = 20000, .output = "variance"};
  const auto variance = exact_variance(model);
  for (const std::size_t layer : {500U, 2000U, 8000U, 20000U}) {
    const auto depth = static_cast<double>(layer);
    EXPECT_NEAR((0.5 - variance[layer]) * std::sqrt(std::numbers::pi * depth) / 2.0, 1.0, 1.5 / std::sqrt(depth))
        << layer;
    EXPECT_GT(std::abs((0.5 - variance[layer]) * std::sqrt(depth) - 1.0), 0.03)
        << "the test can tell 1 from 2/sqrt(pi)";
  }
}

// In a narrow layer the sum of the weights is fixed. Gamma(N r) weights with that condition are Dirichlet variates.
TEST(QModel, NarrowLayersTendToADirichletLaw) {
  for (const auto& [width, neighbours, shape] :
       {std::tuple<std::int64_t, std::int64_t, double>{5, 2, 1.0}, {4, 3, 0.5}}) {
    const QModel model{
        .width = width, .layers = 100000, .neighbours = neighbours, .distribution = "dirichlet", .shape = shape};
    const auto w = static_cast<double>(width);
    const double limit = (w - 1.0) / (static_cast<double>(neighbours) * shape * w + 1.0);
    EXPECT_NEAR(exact_variance(model).back(), limit, 1e-4 * limit) << width;  // up to a term of order 1/D
  }
}

// Equal fractions keep all weights equal. Between walls the weights become uneven, without randomness.
TEST(QModel, FixedFractions) {
  const auto even = last_layer({.width = 12, .layers = 30, .neighbours = 3, .distribution = "fixed"}, 0);
  for (const double w : even) EXPECT_NEAR(w, 30.0, 1e-12);
  for (const double v : exact_variance({.width = 12, .layers = 30, .distribution = "fixed"}))
    EXPECT_NEAR(v, 0.0, 1e-13);
  const QModel walled{.width = 12, .layers = 30, .distribution = "fixed", .edges = "walls", .output = "variance"};
  const auto table = evaluate(walled);
  EXPECT_GT(table.column("exact").values.back(), 1e-3);
  EXPECT_NEAR(table.column("variance").values.back(), table.column("exact").values.back(), 1e-12);
}

// If each site gives all to one neighbour, two weights meet like two random walks, whose difference has variance 1/2
// per layer and a mean range of 2 sqrt(T/pi). The sum over all pairs of layers of grains is E w^2 = (16/(15 sqrt pi))
// D^(5/2), so the variance over mean^2 grows as 0.602 sqrt(D). In a narrow system all weight ends at one site: width
// - 1.
TEST(QModel, CriticalFractionsGatherTheWeight) {
  const QModel wide{.width = 2000, .layers = 10000, .distribution = "critical"};
  const double limit = 16.0 / (15.0 * std::sqrt(std::numbers::pi));
  const auto variance = exact_variance(wide);
  const double near = variance[2500] / std::sqrt(2500.0) / limit - 1.0;
  const double far = variance[10000] / std::sqrt(10000.0) / limit - 1.0;
  EXPECT_NEAR(far, 0.0, 0.03);
  EXPECT_NEAR(far / near, 0.5, 0.1) << "a correction of 1/sqrt(D)";
  const QModel narrow{.width = 6, .layers = 4000, .distribution = "critical"};
  EXPECT_NEAR(exact_variance(narrow).back(), 5.0, 0.05);
}

TEST(QModel, IsAPureFunctionOfTheSeed) {
  const QModel model{.width = 50, .layers = 20, .distribution = "dirichlet", .shape = 0.7};
  EXPECT_EQ(last_layer(model, 3), last_layer(model, 3));
  EXPECT_NE(last_layer(model, 3), last_layer(model, 4));
  auto other = model;
  other.seed = 2;
  EXPECT_NE(last_layer(model, 3), last_layer(other, 3));
}

TEST(QModel, HistogramHoldsEveryWeight) {
  const auto table = evaluate({.width = 100, .layers = 60, .bins = 30, .largest = 3.0});
  double sum = table.number("beyond");
  for (const double d : table.column("density").values) sum += 0.1 * d;
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(table.column("exact").values[4], 4.0 * 0.45 * std::exp(-0.9), 1e-14);
}

TEST(QModel, ReportsContradictingSettings) {
  for (const auto& settings : {std::vector<Setting>{{"width", "2"}, {"neighbours", "3"}},
                               {{"injection", "0"}},
                               {{"start", "gamma"}, {"distribution", "fixed"}},
                               {{"edges", "walls"}, {"width", "5000"}}}) {
    EXPECT_THROW(make_model("q-model", settings), InputError) << settings[0].first;
  }
}

}  // namespace
}  // namespace repose::theory
