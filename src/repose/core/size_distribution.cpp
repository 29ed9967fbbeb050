// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/size_distribution.hpp"

#include "repose/core/reproducible_math.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace repose {

namespace {

/// Distribution function of a normal variable, and its inverse.
double normal_fraction(double x, double centre, double spread) {
  return 0.5 * reproducible::erfc((centre - x) / (spread * std::numbers::sqrt2));
}
double normal_quantile(double fraction, double centre, double spread) {
  return centre - reproducible::inverse_erfc(2.0 * fraction) * (spread * std::numbers::sqrt2);
}

/// The cumulative fractions of these weights: running sums, scaled so that the last is 1.
std::vector<double> cumulative(std::vector<double> weights) {
  double sum = 0.0;
  for (auto& weight : weights) {
    sum += weight;
    weight = sum;
  }
  for (auto& weight : weights) weight /= sum;
  return weights;
}

}  // namespace

LogMoments log_moments(double mean, double deviation) {
  const double ratio = deviation / mean;
  const double variance = reproducible::log1p(ratio * ratio);
  return {reproducible::log(mean) - 0.5 * variance, std::sqrt(variance)};
}

SizeDistribution SizeDistribution::fixed(double diameter) { return uniform(diameter, diameter); }

SizeDistribution SizeDistribution::uniform(double low, double high) {
  SizeDistribution sizes;
  sizes.smallest_ = low;
  sizes.largest_ = high;
  return sizes;
}

SizeDistribution SizeDistribution::normal(double mean, double deviation, double low, double high) {
  auto sizes = uniform(low, high);
  sizes.kind_ = Kind::normal;
  sizes.centre_ = mean;
  sizes.spread_ = deviation;
  sizes.from_ = normal_fraction(low, mean, deviation);
  sizes.to_ = normal_fraction(high, mean, deviation);
  return sizes;
}

SizeDistribution SizeDistribution::log_normal(double mean, double deviation, double low, double high) {
  const auto [centre, spread] = log_moments(mean, deviation);
  auto sizes = normal(centre, spread, reproducible::log(low), reproducible::log(high));
  sizes.kind_ = Kind::log_normal;
  sizes.smallest_ = low;
  sizes.largest_ = high;
  return sizes;
}

SizeDistribution SizeDistribution::table(std::vector<double> diameters, std::vector<double> weights) {
  const auto [low, high] = std::minmax_element(diameters.begin(), diameters.end());
  auto sizes = uniform(*low, *high);
  sizes.kind_ = Kind::table;
  sizes.diameters_ = std::move(diameters);
  sizes.below_ = cumulative(std::move(weights));
  return sizes;
}

/// Between two sieves a < b the mass (d^2 in 2D) per diameter is constant, so the number density is proportional to
/// 1/d^2. The fraction by number between them is proportional to the fraction by mass divided by a b, and the part of
/// it below d is (1/a - 1/d) / (1/a - 1/b).
SizeDistribution SizeDistribution::sieve(std::vector<double> diameters, const std::vector<double>& passing) {
  auto sizes = uniform(diameters.front(), diameters.back());
  sizes.kind_ = Kind::sieve;
  std::vector<double> by_number{0.0};
  for (std::size_t k = 1; k < diameters.size(); ++k) {
    by_number.push_back((passing[k] - passing[k - 1]) / (diameters[k - 1] * diameters[k]));
  }
  sizes.diameters_ = std::move(diameters);
  sizes.below_ = cumulative(std::move(by_number));
  return sizes;
}

double SizeDistribution::quantile(double u) const {
  if (smallest_ == largest_) return largest_;
  // The first entry whose cumulative fraction exceeds u. Rounding must not lead beyond the last entry.
  const auto entry = [&] {
    const auto found = std::upper_bound(below_.begin(), below_.end(), u);
    return static_cast<std::size_t>(std::min(found, below_.end() - 1) - below_.begin());
  };
  switch (kind_) {
    case Kind::uniform:
      return smallest_ + (largest_ - smallest_) * u;
    case Kind::table:
      return diameters_[entry()];
    case Kind::sieve: {
      const auto k = entry();
      const double low = 1.0 / diameters_[k - 1];
      const double high = 1.0 / diameters_[k];
      const double part = (u - below_[k - 1]) / (below_[k] - below_[k - 1]);
      return std::clamp(1.0 / (low + (high - low) * part), diameters_[k - 1], diameters_[k]);
    }
    default:
      break;
  }
  const double fraction = from_ + (to_ - from_) * u;
  if (fraction <= 0.0) return smallest_;
  if (fraction >= 1.0) return largest_;
  const double x = normal_quantile(fraction, centre_, spread_);
  return std::clamp(kind_ == Kind::log_normal ? reproducible::exp(x) : x, smallest_, largest_);
}

namespace {

/// The mean of a function of the diameter.
template <class Of>
double mean_of(const SizeDistribution& sizes, const Of& of) {
  constexpr int parts = 4096;
  double sum = 0.0;
  for (int k = 0; k < parts; ++k) sum += of(sizes.quantile((k + 0.5) / parts));
  return sum / parts;
}

}  // namespace

double SizeDistribution::mean_square() const {
  return mean_of(*this, [](double diameter) { return diameter * diameter; });
}

double SizeDistribution::mean_cube() const {
  return mean_of(*this, [](double diameter) { return diameter * diameter * diameter; });
}

}  // namespace repose
