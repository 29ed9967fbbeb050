// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/q_model_moments.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace repose::theory {

namespace {

using Row = std::vector<double>;

/// The variance of a starting weight at a site with `count` receivers: Gamma(count r) with mean count/N.
double starting_square(const QModel& model, std::int64_t count) {
  const double mean = static_cast<double>(count) / static_cast<double>(model.neighbours);
  return mean * mean / (static_cast<double>(count) * shape_of(model));
}

std::vector<double> periodic_variance(const QModel& model) {
  const auto width = static_cast<std::size_t>(model.width);
  const auto n = static_cast<std::int64_t>(model.neighbours);
  const double mean_square = 1.0 / static_cast<double>(n * n);
  const auto moments = fraction_moments(model, n);
  Row covariance(width, 0.0);
  if (model.start == "gamma") covariance[0] = starting_square(model, n);
  Row next(width);
  std::vector<double> variance;
  for (std::int64_t layer = 0;; ++layer) {
    const double m = mean_weight(model, layer);
    variance.push_back(m > 0.0 ? covariance[0] / (m * m) : 0.0);
    if (layer == model.layers) return variance;
    std::ranges::fill(next, 0.0);
    const double square = covariance[0] + m * m;
    for (std::int64_t apart = 1 - n; apart < n; ++apart) {  // k - l, which n - |apart| pairs have; same for -apart
      const auto pairs = static_cast<double>(n - std::abs(apart));
      const auto shift = static_cast<std::size_t>(apart < 0 ? apart + model.width : apart);
      const double factor = pairs * mean_square;
      const auto wrap = static_cast<std::ptrdiff_t>(width - shift);
      std::transform(next.begin(), next.begin() + wrap, covariance.begin() + static_cast<std::ptrdiff_t>(shift),
                     next.begin(), [&](double sum, double c) { return sum + factor * c; });
      std::transform(next.begin() + wrap, next.end(), covariance.begin(), next.begin() + wrap,
                     [&](double sum, double c) { return sum + factor * c; });
      const double excess = (apart == 0 ? moments.same : moments.different) - mean_square;
      next[shift] += pairs * excess * square;
    }
    covariance.swap(next);
  }
}

/// to = P rows, where P is the matrix of the mean fractions of a layer: a site gives equal fractions to its receivers.
void apply_mean_fractions(const QModel& model, std::int64_t layer, const Row& rows, std::size_t length, Row& to) {
  std::ranges::fill(to, 0.0);
  for (std::int64_t i = 0; i < model.width; ++i) {
    const auto r = receivers(model, layer, i);
    const double fraction = 1.0 / static_cast<double>(r.count());
    const auto* from = rows.data() + static_cast<std::size_t>(i) * length;
    for (auto j = r.first; j < r.last; ++j) {
      auto* row = to.data() + static_cast<std::size_t>(j) * length;
      for (std::size_t k = 0; k < length; ++k) row[k] += fraction * from[k];
    }
  }
}

void transpose(const Row& from, std::size_t width, Row& to) {
  constexpr std::size_t block = 32;
  for (std::size_t a = 0; a < width; a += block) {
    for (std::size_t b = 0; b < width; b += block) {
      for (std::size_t i = a; i < std::min(a + block, width); ++i) {
        for (std::size_t j = b; j < std::min(b + block, width); ++j) to[j * width + i] = from[i * width + j];
      }
    }
  }
}

std::vector<double> walled_variance(const QModel& model) {
  const auto width = static_cast<std::size_t>(model.width);
  const auto injection = static_cast<double>(model.injection);
  Row mean(width, 0.0);
  Row squares(width * width, 0.0);  // E w_i w_j - E w_i E w_j
  if (model.start == "gamma") {
    for (std::size_t i = 0; i < width; ++i) {
      const auto count = receivers(model, 0, static_cast<std::int64_t>(i)).count();
      mean[i] = static_cast<double>(count) / static_cast<double>(model.neighbours);
      squares[i * width + i] = starting_square(model, count);
    }
  }
  Row half(width * width);
  Row flipped(width * width);
  Row next_mean(width);
  std::vector<double> variance;
  for (std::int64_t layer = 0;; ++layer) {
    const double m = mean_weight(model, layer);
    double sum = 0.0;
    for (std::size_t i = 0; i < width; ++i) sum += squares[i * width + i] + (mean[i] - m) * (mean[i] - m);
    variance.push_back(m > 0.0 ? sum / (static_cast<double>(width) * m * m) : 0.0);
    if (layer == model.layers) return variance;
    Row diagonal(width);
    for (std::size_t i = 0; i < width; ++i) diagonal[i] = squares[i * width + i] + mean[i] * mean[i];
    apply_mean_fractions(model, layer, squares, width, half);
    transpose(half, width, flipped);
    apply_mean_fractions(model, layer, flipped, width, squares);
    for (std::int64_t i = 0; i < model.width; ++i) {
      const auto r = receivers(model, layer, i);
      const auto count = static_cast<double>(r.count());
      const auto moments = fraction_moments(model, r.count());
      for (auto j = r.first; j < r.last; ++j) {
        for (auto k = r.first; k < r.last; ++k) {
          const double excess = (j == k ? moments.same : moments.different) - 1.0 / (count * count);
          squares[static_cast<std::size_t>(j) * width + static_cast<std::size_t>(k)] +=
              excess * diagonal[static_cast<std::size_t>(i)];
        }
      }
    }
    apply_mean_fractions(model, layer, mean, 1, next_mean);
    for (auto& one : next_mean) one += injection;
    mean.swap(next_mean);
  }
}

}  // namespace

FractionMoments fraction_moments(const QModel& model, std::int64_t count) {
  const auto n = static_cast<double>(count);
  if (count == 1) return {};
  if (model.distribution == "fixed") return {1.0 / (n * n), 1.0 / (n * n)};
  const double r = shape_of(model);
  return {(r + 1.0) / (n * (n * r + 1.0)), r / (n * (n * r + 1.0))};
}

std::vector<double> exact_variance(const QModel& model) {
  return model.edges == "walls" ? walled_variance(model) : periodic_variance(model);
}

}  // namespace repose::theory
