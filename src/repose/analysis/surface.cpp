// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/surface.hpp"

#include "repose/core/numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

namespace repose {

namespace {

constexpr std::size_t parts = 8;         // parts of the profile for the jackknife
constexpr double hardly_in = 1e-9;       // [columns] a disc that reaches into a column by less does not count there
constexpr std::size_t least_points = 3;  // points that an exponent needs

SurfaceProfile empty_profile(const Box<2>& box, double column) {
  SurfaceProfile profile;
  const auto columns = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(box.width() / column)));
  profile.left = box.x_min;
  profile.column = box.width() / static_cast<double>(columns);
  profile.periodic = box.periodic;
  profile.height.assign(columns, no_number);
  return profile;
}

void cover(SurfaceProfile& profile, const Vec<2>& centre, double radius) {
  const auto columns = static_cast<std::int64_t>(profile.height.size());
  const double place = (centre[0] - profile.left) / profile.column;
  const double half = radius / profile.column;
  const auto first = static_cast<std::int64_t>(std::floor(place - half + hardly_in));
  const auto last = static_cast<std::int64_t>(std::ceil(place + half - hardly_in)) - 1;
  for (auto k = first; k <= last; ++k) {
    if (!profile.periodic && (k < 0 || k >= columns)) continue;
    const double low = static_cast<double>(k);
    const double aside = (std::clamp(place, low, low + 1.0) - place) * profile.column;
    const double top = centre[1] + std::sqrt(std::max(0.0, radius * radius - aside * aside));
    auto& height = profile.height[static_cast<std::size_t>(((k % columns) + columns) % columns)];
    if (!(height >= top)) height = top;
  }
}

/// The slope of the least-squares line through the logarithms; NaN without two different x.
double log_slope(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    mean_x += std::log(x[k]) / n;
    mean_y += std::log(y[k]) / n;
  }
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += squared(std::log(x[k]) - mean_x);
    xy += (std::log(x[k]) - mean_x) * (std::log(y[k]) - mean_y);
  }
  return xx > 0.0 ? xy / xx : no_number;
}

/// The exponent and its jackknife error; none with fewer than three points or a width of zero.
std::optional<Estimate> exponent_of(const std::vector<double>& x, const std::vector<double>& width,
                                    const std::function<double(std::size_t without)>& slope) {
  const bool rough = std::all_of(width.begin(), width.end(), [](double w) { return w > 0.0; });
  if (x.size() < least_points || !rough) return std::nullopt;
  return jackknife(parts, slope);
}

std::size_t part_of(std::size_t k, std::size_t count) { return k * parts / count; }

/// Sums over columns of the height above a reference, and of its square.
struct Moments {
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;

  Moments& operator+=(const Moments& other) {
    count += other.count;
    sum += other.sum;
    squares += other.squares;
    return *this;
  }
  double deviation() const {
    if (!(count > 0.0)) return no_number;
    return std::sqrt(std::max(0.0, squares / count - squared(sum / count)));
  }
};

/// The mean height of the columns that hold a disc: a reference that keeps the squares small.
double mean_height(const std::vector<double>& height) { return mean_of(height).mean; }

std::array<Moments, parts> moments_by_part(const std::vector<double>& height, double reference) {
  std::array<Moments, parts> moments{};
  for (std::size_t k = 0; k < height.size(); ++k) {
    if (std::isnan(height[k])) continue;
    const double h = height[k] - reference;
    moments[part_of(k, height.size())] += {1.0, h, h * h};
  }
  return moments;
}

double deviation_without(const std::array<Moments, parts>& moments, std::size_t without) {
  Moments total;
  for (std::size_t p = 0; p < parts; ++p) {
    if (p != without) total += moments[p];
  }
  return total.deviation();
}

}  // namespace

SurfaceProfile surface_profile(const Discs& discs, const Box<2>& box, double column) {
  auto profile = empty_profile(box, column);
  for (std::size_t k = 0; k < discs.size(); ++k) cover(profile, discs.position[k], discs.radius[k]);
  return profile;
}

double roughness(const SurfaceProfile& profile) {
  return deviation_without(moments_by_part(profile.height, mean_height(profile.height)), parts);
}

RoughnessScaling roughness_scaling(const SurfaceProfile& profile, const std::vector<std::size_t>& windows) {
  RoughnessScaling result;
  const auto columns = profile.height.size();
  const double reference = mean_height(profile.height);
  // Running sums over twice the profile, so that windows can wrap.
  std::vector<Moments> running(2 * columns + 1);
  for (std::size_t k = 0; k < 2 * columns; ++k) {
    const double height = profile.height[k % columns];
    running[k + 1] = running[k];
    if (std::isnan(height)) continue;
    const double h = height - reference;
    running[k + 1] += {1.0, h, h * h};
  }
  std::vector<std::array<Moments, parts>> variances;  // for each window length: number and sum of variances
  for (const auto length : windows) {
    if (length < 2 || length > columns) continue;
    std::array<Moments, parts> by_part{};
    const auto places = profile.periodic ? columns : columns - length + 1;
    for (std::size_t k = 0; k < places; ++k) {
      const auto& from = running[k];
      const auto& to = running[k + length];
      const auto n = static_cast<double>(length);
      if (to.count - from.count != n) continue;
      const double mean = (to.sum - from.sum) / n;
      by_part[part_of(k, places)] += {1.0, std::max(0.0, (to.squares - from.squares) / n - mean * mean), 0.0};
    }
    Moments total;
    for (const auto& part : by_part) total += part;
    if (total.count == 0.0) continue;
    result.window.push_back(static_cast<double>(length) * profile.column);
    result.width.push_back(std::sqrt(total.sum / total.count));
    variances.push_back(by_part);
  }
  result.exponent = exponent_of(result.window, result.width, [&](std::size_t without) {
    std::vector<double> width;
    for (const auto& by_part : variances) {
      Moments total;
      for (std::size_t p = 0; p < parts; ++p) {
        if (p != without) total += by_part[p];
      }
      width.push_back(std::sqrt(total.sum / total.count));
    }
    return log_slope(result.window, width);
  });
  return result;
}

std::vector<std::size_t> usual_windows(const SurfaceProfile& profile) {
  std::vector<std::size_t> windows;
  for (int k = 0;; ++k) {
    const auto length = static_cast<std::size_t>(std::lround(4.0 * std::pow(2.0, 0.5 * k)));
    if (4 * length > profile.height.size()) break;
    windows.push_back(length);
  }
  return windows;
}

SurfaceGrowth surface_growth(const Discs& discs, const Box<2>& box, double column,
                             const std::vector<std::size_t>& deposited) {
  SurfaceGrowth result;
  auto profile = empty_profile(box, column);
  for (std::size_t k = 0; k < discs.size(); ++k) {
    if (discs.base[k]) cover(profile, discs.position[k], discs.radius[k]);
  }
  std::vector<double> numbers;
  std::vector<std::array<Moments, parts>> moments;
  std::size_t count = 0;
  auto next = deposited.begin();
  for (std::size_t k = 0; k < discs.size() && next != deposited.end(); ++k) {
    if (discs.base[k]) continue;
    cover(profile, discs.position[k], discs.radius[k]);
    ++count;
    for (; next != deposited.end() && *next <= count; ++next) {
      if (*next < count) continue;
      result.deposited.push_back(count);
      result.mean_height.push_back(mean_height(profile.height));
      result.width.push_back(roughness(profile));
      numbers.push_back(static_cast<double>(count));
      moments.push_back(moments_by_part(profile.height, result.mean_height.back()));
    }
  }
  result.exponent = exponent_of(numbers, result.width, [&](std::size_t without) {
    std::vector<double> width;
    for (const auto& by_part : moments) width.push_back(deviation_without(by_part, without));
    return log_slope(numbers, width);
  });
  return result;
}

std::vector<std::size_t> usual_numbers(const Discs& discs, const Box<2>& box, double column) {
  constexpr int most = 12;
  const double first = std::max(1.0, std::round(box.width() / column));
  const auto all = static_cast<double>(deposited_count(discs));
  std::vector<std::size_t> numbers;
  for (int k = 0; k < most && first < all; ++k) {
    const auto n = static_cast<std::size_t>(std::lround(first * std::pow(all / first, k / (most - 1.0))));
    if (numbers.empty() || n > numbers.back()) numbers.push_back(n);
  }
  return numbers;
}

}  // namespace repose
