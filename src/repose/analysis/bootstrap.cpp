// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/bootstrap.hpp"

#include "repose/analysis/student.hpp"
#include "repose/core/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>

namespace repose {

namespace {

constexpr std::uint64_t seed_of_draws = 1;
constexpr std::size_t tail = 10;           // resamples that are too few for a quantile
constexpr double most_undefined = 0.01;    // fraction of the resamples
constexpr double least_stretching = 0.25;  // keeps the acceleration from turning far quantiles around

/// The distribution of the resampled statistic, in places of the normal distribution.
class Distribution {
 public:
  explicit Distribution(std::vector<double> values) : sorted_(std::move(values)) {
    std::sort(sorted_.begin(), sorted_.end());
    const auto count = static_cast<double>(sorted_.size());
    mean_ = std::accumulate(sorted_.begin(), sorted_.end(), 0.0) / count;
    double squares = 0.0;
    for (const double x : sorted_) squares += (x - mean_) * (x - mean_);
    deviation_ = sorted_.front() < sorted_.back() ? std::sqrt(squares / (count - 1.0)) : 0.0;
    outermost_ = -normal_quantile(static_cast<double>(tail) / count);
  }

  double mean() const { return mean_; }
  double deviation() const { return deviation_; }

  double value_at(double place) const {
    const auto last = sorted_.size() - 1;
    const double normal = mean_ + place * deviation_;
    if (place <= -outermost_) return std::min(sorted_[tail - 1], normal);
    if (place >= outermost_) return std::max(sorted_[last - tail + 1], normal);
    const double rank = normal_probability(place) * static_cast<double>(sorted_.size()) - 0.5;
    const auto below = static_cast<std::size_t>(std::clamp(rank, 0.0, static_cast<double>(last) - 1.0));
    return sorted_[below] + (rank - static_cast<double>(below)) * (sorted_[below + 1] - sorted_[below]);
  }

  /// Equal values count half on either side.
  double place_of(double value) const {
    const auto [first, last] = std::equal_range(sorted_.begin(), sorted_.end(), value);
    const auto count = static_cast<double>(sorted_.size());
    const double below = 0.5 * static_cast<double>((first - sorted_.begin()) + (last - sorted_.begin()));
    const double normal = (value - mean_) / deviation_;
    if (below < static_cast<double>(tail)) return std::min(-outermost_, normal);
    if (below > count - static_cast<double>(tail)) return std::max(outermost_, normal);
    return normal_quantile(below / count);
  }

 private:
  std::vector<double> sorted_;
  double mean_ = 0.0;
  double deviation_ = 0.0;
  double outermost_ = 0.0;
};

/// Efron's corrections of a place in the distribution, with the levels of Student's t.
struct Corrections {
  double bias = 0.0;          ///< z_0
  double acceleration = 0.0;  ///< a
  double widening = 1.0;      ///< of the error by few members

  double place_at(double t) const {
    const double z = bias + widening * t;
    return bias + z / std::max(least_stretching, 1.0 - acceleration * z);
  }
  double t_at(double place) const {
    const double z = place - bias;
    return (z / std::max(least_stretching, 1.0 + acceleration * z) - bias) / widening;
  }
};

std::vector<double> drawn_values(const Resampled& samples, std::size_t members) {
  std::vector<double> values;
  std::vector<double> weights(members);
  for (std::size_t r = 0; r < resamples; ++r) {
    std::fill(weights.begin(), weights.end(), 0.0);
    std::size_t first = 0;
    std::uint32_t draw = 0;
    for (const auto size : samples.sizes) {
      for (std::size_t k = 0; k < size; ++k) {
        const double place = uniform(seed_of_draws, Purpose::resample, r, draw++) * static_cast<double>(size);
        weights[first + static_cast<std::size_t>(place)] += 1.0;
      }
      first += size;
    }
    if (const double value = samples.statistic(weights); !std::isnan(value)) values.push_back(value);
  }
  return values;
}

/// How the members of the samples influence the statistic, by leaving each out.
struct Jackknife {
  double squares = 0.0, cubes = 0.0;  ///< sums of the influences
  std::vector<double> variances;      ///< by sample, of the statistic
};

Jackknife jackknifed(const Resampled& samples, std::size_t members) {
  Jackknife found;
  std::vector<double> weights(members, 1.0);
  std::size_t first = 0;
  for (const auto size : samples.sizes) {
    const auto n = static_cast<double>(size);
    std::vector<double> without;
    for (std::size_t k = 0; k < size; ++k) {
      weights[first + k] = 0.0;
      without.push_back(samples.statistic(weights));
      weights[first + k] = 1.0;
    }
    const double mean = std::accumulate(without.begin(), without.end(), 0.0) / n;
    double variance = 0.0;
    for (const double value : without) {
      const double influence = (mean - value) * (n - 1.0) / n;
      found.squares += influence * influence;
      found.cubes += influence * influence * influence;
      variance += (mean - value) * (mean - value) * (n - 1.0) / n;
    }
    found.variances.push_back(variance);
    first += size;
  }
  return found;
}

/// Degrees of freedom, and the factor that widens the error of resamples to that of samples.
void set_freedom(Inference& inference, Corrections& corrections, const Jackknife& leave_out,
                 const std::vector<std::size_t>& sizes) {
  const auto fewest = static_cast<double>(*std::min_element(sizes.begin(), sizes.end()));
  std::vector<double> freedoms;
  double sum = 0.0;
  double narrowed = 0.0;
  for (std::size_t s = 0; s < sizes.size(); ++s) {
    const auto n = static_cast<double>(sizes[s]);
    freedoms.push_back(n - 1.0);
    sum += leave_out.variances[s];
    narrowed += leave_out.variances[s] * (n - 1.0) / n;
  }
  const bool known = std::isfinite(sum) && sum > 0.0;
  inference.freedom = known ? satterthwaite(leave_out.variances, freedoms) : fewest - 1.0;
  corrections.widening = std::sqrt(known ? sum / narrowed : fewest / (fewest - 1.0));
}

}  // namespace

Inference bootstrap(const Resampled& samples, const std::string& test) {
  const auto members = std::accumulate(samples.sizes.begin(), samples.sizes.end(), std::size_t{0});
  Inference inference;
  inference.test = test;
  inference.count = members;
  if (members == 0) return inference;
  inference.value = samples.statistic(std::vector<double>(members, 1.0));
  if (std::isnan(inference.value) || *std::min_element(samples.sizes.begin(), samples.sizes.end()) < 2) {
    return inference;
  }
  auto values = drawn_values(samples, members);
  if (static_cast<double>(values.size()) < (1.0 - most_undefined) * static_cast<double>(resamples)) return inference;
  const auto distribution = std::make_shared<const Distribution>(std::move(values));
  const auto leave_out = jackknifed(samples, members);
  Corrections corrections;
  set_freedom(inference, corrections, leave_out, samples.sizes);
  inference.error = corrections.widening * distribution->deviation();
  inference.bias = corrections.widening * corrections.widening * (distribution->mean() - inference.value);
  if (inference.error == 0.0) {
    inference.low = inference.high = inference.value;
    inference.p_above = [value = inference.value](double bound) { return value > bound ? 0.0 : 1.0; };
    inference.p_below = [value = inference.value](double bound) { return value < bound ? 0.0 : 1.0; };
    return inference;
  }
  corrections.bias = distribution->place_of(inference.value);
  const double acceleration = leave_out.cubes / (6.0 * std::pow(leave_out.squares, 1.5));
  if (std::isfinite(acceleration)) corrections.acceleration = acceleration;
  const double t = student_quantile(1.0 - test_level, inference.freedom);
  inference.low = ten_digits(distribution->value_at(corrections.place_at(-t)));
  inference.high = ten_digits(distribution->value_at(corrections.place_at(t)));
  inference.p_above = [=, freedom = inference.freedom](double bound) {
    return ten_digits(student_probability(corrections.t_at(distribution->place_of(bound)), freedom));
  };
  inference.p_below = [=, freedom = inference.freedom](double bound) {
    return ten_digits(student_probability(-corrections.t_at(distribution->place_of(bound)), freedom));
  };
  return inference;
}

}  // namespace repose
