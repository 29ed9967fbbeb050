// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/sphere_structure.hpp"

#include "repose/analysis/near_spheres.hpp"
#include "repose/core/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace repose {

namespace {

using std::numbers::pi;

constexpr double below_contact = 2e-4;  // [diameters], as in 2D
constexpr double most_of_a_bin = 0.1;

/// The mean over directions of the part of a cuboid that stays in it when it is shifted by r, as a polynomial in r.
std::array<double, 4> shift_polynomial(const Cuboid& cuboid) {
  std::array<double, 3> open{};  // 1/side of an axis that is not periodic
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    open[k] = cuboid.periodic[k] ? 0.0 : 1.0 / cuboid.side(axis);
  }
  // Means over directions of |n_x|, |n_x n_y| and |n_x n_y n_z|.
  const double pairs = open[0] * open[1] + open[1] * open[2] + open[2] * open[0];
  return {1.0, -0.5 * (open[0] + open[1] + open[2]), 2.0 / (3.0 * pi) * pairs,
          -open[0] * open[1] * open[2] / (4.0 * pi)};
}

/// Integral of 4 pi r^2 times the polynomial from 0 to r.
double integral(const std::array<double, 4>& polynomial, double r) {
  double sum = 0.0;
  double power = r * r * r;
  for (std::size_t k = 0; k < polynomial.size(); ++k) {
    sum += polynomial[k] * power / static_cast<double>(k + 3);
    power *= r;
  }
  return 4.0 * pi * sum;
}

std::vector<Vec<3>> points_in(const std::vector<Vec<3>>& points, const Cuboid& cuboid) {
  std::vector<Vec<3>> inside;
  for (const auto& point : points) {
    if (cuboid.holds(point)) inside.push_back(point);
  }
  return inside;
}

/// The box of x and y, in which pairs are searched; z wraps by images.
Box<3> level_box(const Cuboid& cuboid) {
  Box<3> box;
  if (cuboid.periodic[0]) {
    box.periodic = true;
    box.x_min = cuboid.low[0];
    box.x_max = cuboid.high[0];
  }
  if (cuboid.periodic[1]) {
    box.periodic_y = true;
    box.y_min = cuboid.low[1];
    box.y_max = cuboid.high[1];
  }
  return box;
}

/// Calls use(distance) for each pair of points, one time.
template <class Use>
void for_distances(std::vector<Vec<3>> points, const Cuboid& cuboid, double reach, const Use& use) {
  const auto count = static_cast<std::uint32_t>(points.size());
  const Box<3> box = level_box(cuboid);
  if (cuboid.periodic[2]) {
    for (std::uint32_t k = 0; k < count; ++k) {  // images above the cuboid of the points near its lower face
      Vec<3> image = points[k];
      if (image[2] - cuboid.low[2] > reach) continue;
      image[2] += cuboid.side(2);
      points.push_back(image);
    }
  }
  for_near_pairs(points, box, reach, [&](std::uint32_t i, std::uint32_t j) {
    if (j >= count) return;  // two images; j < i
    use(magnitude(separation(points[i], points[j], box)));
  });
}

double weight(const Vec<3>& point, const Cuboid& cuboid, Window window) {
  double product = 1.0;
  if (window == Window::none) return product;
  for (int axis = 0; axis < 3; ++axis) {
    if (cuboid.periodic[static_cast<std::size_t>(axis)]) continue;
    product *= squared(std::sin(pi * (point[axis] - cuboid.low[axis]) / cuboid.side(axis)));
  }
  return product;
}

/// exp(-i m unit x) for m = 0, ... most, by repeated multiplication.
std::vector<std::complex<double>> powers(double phase, int most) {
  const std::complex<double> step{std::cos(phase), -std::sin(phase)};
  std::vector<std::complex<double>> result{{1.0, 0.0}};
  for (int m = 0; m < most; ++m) result.push_back(result.back() * step);
  return result;
}

}  // namespace

Correlation sphere_pair_correlation(const std::vector<Vec<3>>& points, const Cuboid& cuboid, double reach,
                                    double bin_width, double diameter) {
  Correlation correlation;
  const auto inside = points_in(points, cuboid);
  if (inside.size() < 2 || !(bin_width > 0.0)) return correlation;
  for (int axis = 0; axis < 3; ++axis) {
    const bool wraps = cuboid.periodic[static_cast<std::size_t>(axis)];
    reach = std::min(reach, (wraps ? 0.5 : 1.0) * cuboid.side(axis));
  }
  const double back = std::min(below_contact * diameter, most_of_a_bin * bin_width);
  const auto bins = static_cast<std::size_t>(std::floor(reach / bin_width + 1e-9));
  correlation.pairs.assign(bins, 0);
  for_distances(inside, cuboid, reach, [&](double distance) {
    const auto bin = static_cast<std::size_t>((distance + back) / bin_width);
    if (bin < bins) ++correlation.pairs[bin];
  });
  const auto polynomial = shift_polynomial(cuboid);
  const auto n = static_cast<double>(inside.size());
  const auto edge = [&](std::size_t bin) { return std::max(0.0, static_cast<double>(bin) * bin_width - back); };
  for (std::size_t k = 0; k < bins; ++k) {
    const double space = integral(polynomial, edge(k + 1)) - integral(polynomial, edge(k));
    const double expected = 0.5 * n * (n - 1.0) * space / cuboid.volume();
    const auto pairs = static_cast<double>(correlation.pairs[k]);
    correlation.distance.push_back(0.5 * (edge(k) + edge(k + 1)));
    correlation.value.push_back(expected > 0.0 ? pairs / expected : no_number);
    correlation.error.push_back(expected > 0.0 ? std::sqrt(std::max(pairs, 1.0)) / expected : no_number);
  }
  return correlation;
}

std::vector<double> sphere_structure_factor(const std::vector<Vec<3>>& points, const std::vector<Vec<3>>& wave_vectors,
                                            const Cuboid& cuboid, Window window) {
  const auto inside = points_in(points, cuboid);
  std::vector<double> weights;
  double squares = 0.0;
  for (const auto& point : inside) {
    weights.push_back(weight(point, cuboid, window));
    squares += squared(weights.back());
  }
  std::vector<double> result;
  for (const auto& q : wave_vectors) {
    double real = 0.0;
    double imaginary = 0.0;
    for (std::size_t k = 0; k < inside.size(); ++k) {
      const double phase = dot(q, inside[k]);
      real += weights[k] * std::cos(phase);
      imaginary -= weights[k] * std::sin(phase);
    }
    result.push_back((squared(real) + squared(imaginary)) / squares);
  }
  return result;
}

IsotropicStructureFactor sphere_isotropic_structure_factor(const std::vector<Vec<3>>& points, const Cuboid& cuboid,
                                                           const StructureFactorOptions& options) {
  IsotropicStructureFactor result;
  const auto inside = points_in(points, cuboid);
  if (inside.empty() || !(options.largest > 0.0) || options.shells == 0) return result;
  const double largest = options.largest;
  const double half_sphere = 2.0 / 3.0 * pi * largest * largest * largest;
  const double vectors = half_sphere * cuboid.volume() / (8.0 * pi * pi * pi);
  const int stride =
      std::max(1, static_cast<int>(std::ceil(std::cbrt(vectors / static_cast<double>(options.most_vectors)))));
  Vec<3> unit{};
  std::array<int, 3> most{};
  std::array<bool, 3> smeared{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    unit[axis] = 2.0 * pi * stride / cuboid.side(axis);
    most[k] = static_cast<int>(largest / unit[axis]);
    smeared[k] = options.window == Window::hann && !cuboid.periodic[k];
  }
  // Half of the wave vectors, since q and -q give the same.
  struct Wave {
    int k, l, m;
    std::size_t shell;
  };
  std::vector<Wave> waves;
  std::vector<double> wave_numbers(options.shells, 0.0);
  for (int k = 0; k <= most[0]; ++k) {
    for (int l = k == 0 ? 0 : -most[1]; l <= most[1]; ++l) {
      for (int m = k == 0 && l == 0 ? 1 : -most[2]; m <= most[2]; ++m) {
        const double q = magnitude(Vec<3>{{k * unit[0], l * unit[1], m * unit[2]}});
        const auto near = [&](int number, std::size_t axis) {
          return std::abs(number) * stride <= (smeared[axis] ? 1 : 0);
        };
        if (q > largest || (near(k, 0) && near(l, 1) && near(m, 2))) continue;
        const auto shell =
            std::min(options.shells - 1, static_cast<std::size_t>(q / largest * static_cast<double>(options.shells)));
        waves.push_back({k, l, m, shell});
        wave_numbers[shell] += q;
      }
    }
  }
  std::vector<std::complex<double>> sums(waves.size());
  double squares = 0.0;
  for (const auto& point : inside) {
    const double w = weight(point, cuboid, options.window);
    squares += w * w;
    const Vec<3> from = point - cuboid.low;
    const auto x = powers(unit[0] * from[0], most[0]);
    const auto y = powers(unit[1] * from[1], most[1]);
    const auto z = powers(unit[2] * from[2], most[2]);
    const auto factor = [](const auto& of, int number) {
      const auto value = of[static_cast<std::size_t>(std::abs(number))];
      return number < 0 ? std::conj(value) : value;
    };
    for (std::size_t k = 0; k < waves.size(); ++k) {
      const auto xy = w * x[static_cast<std::size_t>(waves[k].k)] * factor(y, waves[k].l);
      sums[k] += xy * factor(z, waves[k].m);
    }
  }
  // The amplitudes of vectors one and two steps apart along an axis with a Hann window are correlated by 2/3 and 1/6.
  const double each = stride == 1 ? 1.0 + 2.0 * (squared(2.0 / 3.0) + squared(1.0 / 6.0))
                                  : 1.0 + (stride == 2 ? 2.0 * squared(1.0 / 6.0) : 0.0);
  double dependence = 1.0;
  for (const bool is_smeared : smeared) dependence *= is_smeared ? each : 1.0;
  std::vector<std::vector<double>> values(options.shells);
  for (std::size_t k = 0; k < waves.size(); ++k) values[waves[k].shell].push_back(std::norm(sums[k]) / squares);
  for (std::size_t s = 0; s < options.shells; ++s) {
    if (values[s].empty()) continue;
    const auto mean = mean_of(values[s]);
    result.wave_number.push_back(wave_numbers[s] / static_cast<double>(mean.count));
    result.value.push_back(mean.mean);
    result.error.push_back(mean.error * std::sqrt(dependence));
    result.vectors.push_back(mean.count);
  }
  return result;
}

}  // namespace repose
