// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/tail_fit.hpp"

#include "repose/analysis/student.hpp"
#include "repose/core/random.hpp"
#include "repose/core/reproducible_math.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {

namespace {

constexpr std::size_t least_tail = 50;       // sizes that a fit needs
constexpr std::size_t most_candidates = 40;  // places where the law may begin
constexpr double significant = 0.1;          // a law is refuted below, as Clauset et al. choose
constexpr double better = 0.05;              // a rival is better, or worse, below
constexpr std::uint64_t seed_of_draws = 1;

/// Sizes and their logarithms, rising.
struct Sample {
  std::vector<double> log;

  explicit Sample(std::vector<double> logs) : log(std::move(logs)) { std::sort(log.begin(), log.end()); }
  std::size_t size() const { return log.size(); }
};

struct Fit {
  std::size_t first = 0;  // of the tail
  double slope = 0.0;     // exponent - 1
  double distance = 2.0;
};

/// The law that begins at member `first`; `above` is the sum of the logarithms from there on.
Fit fit_from(const Sample& sample, std::size_t first, double above) {
  const auto n = static_cast<double>(sample.size() - first);
  const double begin = sample.log[first];
  Fit fit{first, 0.0, 0.0};
  const double sum = above - n * begin;
  if (!(sum > 0.0)) return {first, 0.0, 2.0};
  fit.slope = n / sum;
  for (std::size_t k = first; k < sample.size(); ++k) {
    const double expected = 1.0 - reproducible::exp(-fit.slope * (sample.log[k] - begin));
    const auto rank = static_cast<double>(k - first);
    fit.distance = std::max({fit.distance, std::fabs(expected - rank / n), std::fabs((rank + 1.0) / n - expected)});
  }
  return fit;
}

/// The law that lies nearest to its tail, of those that begin at quantiles of the sample.
Fit best_fit(const Sample& sample) {
  std::vector<double> above(sample.size() + 1, 0.0);
  for (std::size_t k = sample.size(); k-- > 0;) above[k] = above[k + 1] + sample.log[k];
  const std::size_t last = sample.size() - least_tail;
  const std::size_t candidates = std::min(most_candidates, last + 1);
  Fit best;
  for (std::size_t c = 0; c < candidates; ++c) {
    std::size_t first = candidates > 1 ? c * last / (candidates - 1) : 0;
    while (first > 0 && sample.log[first - 1] == sample.log[first]) --first;
    const auto fit = fit_from(sample, first, above[first]);
    if (fit.distance < best.distance) best = fit;
  }
  return best;
}

/// A sample of the law above its beginning and of the sizes themselves below it.
Sample synthetic(const Sample& sample, const Fit& fit, std::uint32_t number) {
  const auto n = sample.size();
  const double in_tail = static_cast<double>(n - fit.first) / static_cast<double>(n);
  std::vector<double> logs;
  for (std::size_t k = 0; k < n; ++k) {
    const double which = uniform(seed_of_draws, Purpose::resample, k, 2 * number);
    const double draw = uniform(seed_of_draws, Purpose::resample, k, 2 * number + 1);
    if (which < in_tail) {
      logs.push_back(sample.log[fit.first] - reproducible::log1p(-draw) / fit.slope);
    } else {
      logs.push_back(sample.log[static_cast<std::size_t>(draw * static_cast<double>(fit.first))]);
    }
  }
  return Sample(std::move(logs));
}

double p_value(const Sample& sample, const Fit& fit, int samples) {
  if (samples == 0) return TailFit::none;
  int farther = 0;
  for (int k = 0; k < samples; ++k) {
    if (best_fit(synthetic(sample, fit, static_cast<std::uint32_t>(k))).distance >= fit.distance) ++farther;
  }
  return static_cast<double>(farther) / samples;
}

/// Against exp(-rate (x - x_min)).
RivalLaw against_exponential(const Sample& sample, const Fit& fit) {
  const double begin = sample.log[fit.first];
  const auto n = static_cast<double>(sample.size() - fit.first);
  double mean = 0.0;  // of x/x_min - 1
  for (std::size_t k = fit.first; k < sample.size(); ++k) mean += (reproducible::exp(sample.log[k] - begin) - 1.0) / n;
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t k = fit.first; k < sample.size(); ++k) {
    const double y = sample.log[k] - begin;
    const double power = reproducible::log(fit.slope) - (fit.slope + 1.0) * y;
    const double other = -reproducible::log(mean) - (reproducible::exp(y) - 1.0) / mean;
    sum += power - other;
    squares += (power - other) * (power - other);
  }
  const double variance = squares / n - (sum / n) * (sum / n);
  return {ten_digits(sum), ten_digits(reproducible::erfc(std::fabs(sum) / std::sqrt(2.0 * n * variance)))};
}

/// exp(z^2) erfc(z), z at most 25.
double scaled_erfc(double z) { return reproducible::exp(z * z) * reproducible::erfc(z); }

/// The mean of t with the density exp(-2 z t - t^2) over t > 0, and that of its square over the square of the mean.
struct TailMoments {
  double mean = 0.0, ratio = 0.0;
};
TailMoments moments_at(double z) {
  const double mean = 1.0 / (std::sqrt(std::numbers::pi) * scaled_erfc(z)) - z;
  return {mean, (0.5 - z * mean) / (mean * mean)};
}

/// Against a log-normal law cut at x_min: the logarithm over x_min has the density exp(-a y - b y^2), of which the
/// power law is the limit b = 0. Its likelihood is largest where the first two moments are those of the sample.
RivalLaw against_log_normal(const Sample& sample, const Fit& fit) {
  constexpr double most = 25.0;  // where the law can hardly be told from its limit
  constexpr double least = -20.0;
  const double begin = sample.log[fit.first];
  const auto n = static_cast<double>(sample.size() - fit.first);
  double mean = 0.0;
  double square = 0.0;
  for (std::size_t k = fit.first; k < sample.size(); ++k) {
    const double y = sample.log[k] - begin;
    mean += y / n;
    square += y * y / n;
  }
  const double ratio = square / (mean * mean);
  if (ratio >= moments_at(most).ratio) return {0.0, 1.0};
  double low = least;
  double high = most;
  for (int step = 0; step < 100; ++step) {
    const double middle = 0.5 * (low + high);
    (moments_at(middle).ratio < ratio ? low : high) = middle;
  }
  const double z = 0.5 * (low + high);
  const double root = moments_at(z).mean / mean;  // of b
  const double a = 2.0 * z * root;
  const double norm = std::sqrt(std::numbers::pi) / (2.0 * root) * scaled_erfc(z);
  const double other = -n * (a * mean + root * root * square + reproducible::log(norm));
  const double power = n * (reproducible::log(fit.slope) - fit.slope * mean);
  const double log_ratio = std::min(0.0, power - other);
  return {ten_digits(log_ratio), ten_digits(0.5 * reproducible::erfc(std::sqrt(-log_ratio)))};
}

std::string verdict_of(const TailFit& found) {
  if (found.p_value < significant) return fmt::format("no power law: p {:.3g} below {:g}", found.p_value, significant);
  if (found.exponential.log_ratio < 0.0 && found.exponential.p_value < better) {
    return fmt::format("no power law: an exponential is likelier, p {:.3g}", found.exponential.p_value);
  }
  if (found.log_normal.p_value < better) {
    return fmt::format("no power law: a log-normal is likelier, p {:.3g}", found.log_normal.p_value);
  }
  if (found.tail < least_events_of_power_law) {
    return fmt::format("undecided: {} events in the tail, {} needed", found.tail, least_events_of_power_law);
  }
  if (found.decades < least_decades_of_power_law) {
    return fmt::format("undecided: {:.2g} decades, {:g} needed", found.decades, least_decades_of_power_law);
  }
  if (!(found.exponential.log_ratio > 0.0 && found.exponential.p_value < better)) {
    return fmt::format("undecided: an exponential does as well, p {:.3g}", found.exponential.p_value);
  }
  return "power law";
}

}  // namespace

TailFit fit_tail(const std::vector<double>& sizes, int synthetic) {
  TailFit found;
  std::vector<double> logs;
  for (const double size : sizes) {
    if (size > 0.0 && std::isfinite(size)) logs.push_back(reproducible::log(size));
  }
  found.events = static_cast<std::int64_t>(logs.size());
  found.verdict = fmt::format("undecided: {} events, a fit needs {}", found.events, least_tail);
  if (logs.size() < least_tail) return found;
  const Sample sample(std::move(logs));
  const auto fit = best_fit(sample);
  if (!(fit.slope > 0.0)) {
    found.verdict = "no power law: all events have one size";
    return found;
  }
  found.tail = static_cast<std::int64_t>(sample.size() - fit.first);
  found.x_min = ten_digits(reproducible::exp(sample.log[fit.first]));
  found.exponent = ten_digits(1.0 + fit.slope);
  found.error = ten_digits(fit.slope / std::sqrt(static_cast<double>(found.tail)));
  found.decades = ten_digits((sample.log.back() - sample.log[fit.first]) / std::numbers::ln10);
  found.distance = ten_digits(fit.distance);
  found.p_value = p_value(sample, fit, synthetic);
  found.exponential = against_exponential(sample, fit);
  found.log_normal = against_log_normal(sample, fit);
  found.verdict = verdict_of(found);
  return found;
}

}  // namespace repose
