// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/force_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {

namespace {

/// Probability densities from counts; all zero if the counts are.
std::vector<double> densities(const std::vector<double>& counts, double bin_width) {
  double all = 0.0;
  for (const double count : counts) all += count;
  std::vector<double> values;
  for (const double count : counts) values.push_back(all > 0.0 ? count / (all * bin_width) : 0.0);
  return values;
}

/// The axis of a contact from the horizontal, in [0, 180) degrees.
double axis_deg(const Vec<2>& normal) {
  const double angle = std::atan2(normal[1], normal[0]) * 180.0 / std::numbers::pi;
  const double folded = angle < 0.0 ? angle + 180.0 : angle;
  return folded < 180.0 ? folded : 0.0;
}

/// Bins of the directions of contacts.
template <int D>
struct Directions;

template <>
struct Directions<2> {
  static constexpr std::size_t bins = 36;
  static constexpr double width = 180.0 / bins;  // [deg]
  static constexpr auto centres = &ForceStatistics::direction_deg;

  static std::size_t bin(const Vec<2>& normal) {
    return static_cast<std::size_t>(axis_deg(normal) / width + 0.5) % bins;
  }
  static double centre(std::size_t bin) { return static_cast<double>(bin) * width; }
};

template <>
struct Directions<3> {
  static constexpr std::size_t bins = 20;
  static constexpr double width = 1.0 / bins;
  static constexpr auto centres = &ForceStatistics::direction_cosine;

  static std::size_t bin(const Vec<3>& normal) {
    return std::min(static_cast<std::size_t>(std::fabs(normal[2]) / width), bins - 1);
  }
  static double centre(std::size_t bin) { return (static_cast<double>(bin) + 0.5) * width; }
};

}  // namespace

template <int D>
std::optional<ForceStatistics> measure_force_statistics(const Contacts<D>& contacts, double threshold) {
  std::vector<const Contact<D>*> counting;
  for (const auto& contact : contacts.list) {
    if (contact.normal_force > threshold && std::isfinite(contact.normal_force)) counting.push_back(&contact);
  }
  if (counting.empty()) return std::nullopt;
  const auto n = static_cast<double>(counting.size());
  ForceStatistics statistics;
  double sum = 0.0;
  double largest = 0.0;
  for (const auto* contact : counting) {
    sum += contact->normal_force;
    largest = std::max(largest, contact->normal_force);
  }
  statistics.mean = sum / n;

  constexpr double usual_width = 0.1;
  constexpr double most_bins = 1000.0;
  const double range = largest / statistics.mean;
  statistics.bin_width = std::max(usual_width, range / (most_bins - 1.0));
  // No contact counts below the threshold: a bin that began at 0 would seem to hold too few.
  const double start = std::max(0.0, threshold) / statistics.mean;
  const auto bins = static_cast<std::size_t>((range - start) / statistics.bin_width) + 1;
  std::vector<double> counts(bins, 0.0);
  std::vector<double> all(Directions<D>::bins, 0.0);
  std::vector<double> strong(Directions<D>::bins, 0.0);
  for (const auto* contact : counting) {
    const double f = contact->normal_force / statistics.mean;
    counts[std::min(static_cast<std::size_t>((f - start) / statistics.bin_width), bins - 1)] += 1.0;
    const auto direction = Directions<D>::bin(contact->normal);
    all[direction] += 1.0;
    if (contact->normal_force * n > sum) {  // as in find_chains
      strong[direction] += 1.0;
      statistics.strong_fraction += 1.0;
    }
    if (contact->sliding) statistics.sliding_fraction += 1.0;
  }
  statistics.strong_fraction /= n;
  statistics.sliding_fraction /= n;
  statistics.density = densities(counts, statistics.bin_width);
  for (std::size_t k = 0; k < bins; ++k) {
    statistics.f.push_back(start + (static_cast<double>(k) + 0.5) * statistics.bin_width);
    statistics.error.push_back(std::sqrt(counts[k]) / (n * statistics.bin_width));
  }
  statistics.direction_all = densities(all, Directions<D>::width);
  statistics.direction_strong = densities(strong, Directions<D>::width);
  auto& centres = statistics.*Directions<D>::centres;
  for (std::size_t k = 0; k < Directions<D>::bins; ++k) centres.push_back(Directions<D>::centre(k));
  return statistics;
}

template std::optional<ForceStatistics> measure_force_statistics(const Contacts<2>&, double);
template std::optional<ForceStatistics> measure_force_statistics(const Contacts<3>&, double);

}  // namespace repose
