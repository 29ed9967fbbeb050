// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/pair_correlation.hpp"

#include "repose/analysis/solid_fraction.hpp"
#include "repose/neighbours/near_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace repose {

namespace {

constexpr double usual_reach = 8.0;  // [mean diameters]

/// Discs in contact, and the rows of a lattice, are whole diameters apart but for rounding, overlap and the tolerance
/// of a solver. An edge there would divide them between two bins by chance, so edges lie a little below.
constexpr double below_contact = 2e-4;  // [mean diameters]
constexpr double most_of_a_bin = 0.1;   // of narrow bins

struct Bins {
  double width;
  std::size_t count;
  double back;  // [L] of the edges from whole multiples of the width

  Bins(double reach, double bin_width, double diameter)
      : width(bin_width * diameter),
        count(static_cast<std::size_t>(std::floor(reach / width + 1e-9))),
        back(std::min(below_contact * diameter, most_of_a_bin * width)) {}

  /// Lower edge of a bin; the first bin begins at 0.
  double edge(std::size_t bin) const { return std::max(0.0, static_cast<double>(bin) * width - back); }

  void add(std::vector<std::size_t>& pairs, double distance) const {
    const auto bin = static_cast<std::size_t>((distance + back) / width);
    if (bin < count) ++pairs[bin];
  }
};

/// Sets the values from the numbers of pairs and the numbers expected without correlation.
void finish(Correlation& correlation, const Bins& bins, const std::vector<double>& expected) {
  for (std::size_t k = 0; k < bins.count; ++k) {
    const auto pairs = static_cast<double>(correlation.pairs[k]);
    const bool possible = expected[k] > 0.0;
    const double none = std::numeric_limits<double>::quiet_NaN();
    correlation.distance.push_back(0.5 * (bins.edge(k) + bins.edge(k + 1)));
    correlation.value.push_back(possible ? pairs / expected[k] : none);
    correlation.error.push_back(possible ? std::sqrt(std::max(pairs, 1.0)) / expected[k] : none);
  }
}

/// For each bin, the sum over all points of the area within the slab of the ring about the point.
std::vector<double> ring_areas(const std::vector<Vec<2>>& points, const Slab& slab, const Bins& bins) {
  std::vector<double> areas(bins.count, 0.0);
  for (const auto& point : points) {
    const double below = point[1] - slab.low;
    const double above = slab.high - point[1];
    const double left = slab.box.periodic ? std::numeric_limits<double>::infinity() : point[0] - slab.box.x_min;
    const double right = slab.box.periodic ? std::numeric_limits<double>::infinity() : slab.box.x_max - point[0];
    double inner = 0.0;
    for (std::size_t k = 0; k < bins.count; ++k) {
      const double within = disc_area_in({}, bins.edge(k + 1), {{{-left, -below}}, {{right, above}}});
      areas[k] += within - inner;
      inner = within;
    }
  }
  return areas;
}

/// Integral of (length - d) over d in [from, to], d < length.
double overlap_integral(double length, double from, double to) {
  from = std::min(from, length);
  to = std::min(to, length);
  return (to - from) * (length - 0.5 * (from + to));
}

}  // namespace

PairCorrelation pair_correlation(const Discs& discs, const Slab& slab, const PairCorrelationOptions& options) {
  PairCorrelation result;
  const double diameter = mean_diameter(discs);
  std::vector<Vec<2>> points;
  for (const auto k : centres_in(discs, slab)) points.push_back(discs.position[k]);
  if (points.size() < 2) return result;

  const double width = slab.box.width();
  const bool periodic = slab.box.periodic;
  const double most = periodic ? 0.5 * width : std::hypot(width, slab.height());
  const double wanted = options.reach > 0.0 ? options.reach : std::min(usual_reach, slab.height() / diameter);
  const double reach = std::min(wanted * diameter, most);
  const Bins bins(reach, options.bin_width, diameter);
  const double strip = std::min(options.strip * diameter, most);
  for (auto* correlation : {&result.radial, &result.along_x, &result.along_y}) {
    correlation->pairs.assign(bins.count, 0);
  }
  const double strip_reach = std::hypot(reach, strip);
  for_near_pairs(points, slab.box, std::min(strip_reach, std::hypot(width, slab.height())),
                 [&](std::uint32_t i, std::uint32_t j) {
                   const Vec<2> d = separation(points[i], points[j], slab.box);
                   const double along_x = std::fabs(d[0]);
                   const double along_y = std::fabs(d[1]);
                   const double squares = squared(d);
                   if (squares < reach * reach) bins.add(result.radial.pairs, std::sqrt(squares));
                   if (along_y < strip) bins.add(result.along_x.pairs, along_x);
                   if (along_x < strip) bins.add(result.along_y.pairs, along_y);
                 });

  const auto count = static_cast<double>(points.size());
  auto radial = ring_areas(points, slab, bins);
  for (auto& pairs : radial) pairs *= 0.5 * (count - 1.0) / slab.area();
  // The expected number of pairs of N uniform points with a separation in a rectangle of |dx|, |dy| is N (N-1)/2 times
  // the integral, over both signs, of the fraction of the slab that stays in it when shifted by (dx, dy).
  const double scale = 0.5 * count * (count - 1.0) / (slab.area() * slab.area());
  const auto integral_x = [&](double from, double to) {
    return 2.0 * (periodic ? width * (to - from) : overlap_integral(width, from, to));
  };
  const auto integral_y = [&](double from, double to) { return 2.0 * overlap_integral(slab.height(), from, to); };
  std::vector<double> along_x;
  std::vector<double> along_y;
  for (std::size_t k = 0; k < bins.count; ++k) {
    const double from = bins.edge(k);
    const double to = bins.edge(k + 1);
    along_x.push_back(scale * integral_x(from, to) * integral_y(0.0, strip));
    along_y.push_back(scale * integral_y(from, to) * integral_x(0.0, strip));
  }
  finish(result.radial, bins, radial);
  finish(result.along_x, bins, along_x);
  finish(result.along_y, bins, along_y);
  return result;
}

}  // namespace repose
