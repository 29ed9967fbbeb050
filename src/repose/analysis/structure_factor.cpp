// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/structure_factor.hpp"

#include "repose/analysis/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace repose {

namespace {

using std::numbers::pi;

double weight(const Vec<2>& point, const Slab& slab, Window window) {
  if (window == Window::none) return 1.0;
  const auto hann = [](double place) { return squared(std::sin(pi * place)); };
  const double across = hann((point[1] - slab.low) / slab.height());
  return slab.box.periodic ? across : across * hann((point[0] - slab.box.x_min) / slab.box.width());
}

/// Sums of w exp(-i q . r) over all points, for q = (k, m) unit with m = -most..most. One row per k.
class Waves {
 public:
  Waves(const Vec<2>& unit, int most_k, int most_m) : unit_(unit), most_m_(most_m) {
    row_ = 2 * static_cast<std::size_t>(most_m) + 1;
    real_.assign(row_ * (static_cast<std::size_t>(most_k) + 1), 0.0);
    imaginary_.assign(real_.size(), 0.0);
    up_real_.resize(row_);
    up_imaginary_.resize(row_);
  }

  /// `reach[k]` is the largest |m| needed in row k.
  void add(const Vec<2>& point, double w, const std::vector<int>& reach) {
    const auto step = std::polar(1.0, -unit_[0] * point[0]);
    const auto step_up = std::polar(1.0, -unit_[1] * point[1]);
    std::complex<double> up = 1.0;
    const auto middle = static_cast<std::size_t>(most_m_);
    for (std::size_t m = 0; m <= middle; ++m) {
      up_real_[middle + m] = up_real_[middle - m] = up.real();
      up_imaginary_[middle + m] = up.imag();
      up_imaginary_[middle - m] = -up.imag();
      up *= step_up;
    }
    std::complex<double> across = w;
    for (std::size_t k = 0; k < reach.size(); ++k) {
      if (reach[k] >= 0) {
        const auto first = middle - static_cast<std::size_t>(reach[k]);
        const auto last = middle + static_cast<std::size_t>(reach[k]);
        const double a = across.real();
        const double b = across.imag();
        double* real = real_.data() + k * row_;
        double* imaginary = imaginary_.data() + k * row_;
        for (auto m = first; m <= last; ++m) {
          real[m] += a * up_real_[m] - b * up_imaginary_[m];
          imaginary[m] += a * up_imaginary_[m] + b * up_real_[m];
        }
      }
      across *= step;
    }
  }

  double power(std::size_t k, int m) const {
    const auto place = k * row_ + static_cast<std::size_t>(m + most_m_);
    return squared(real_[place]) + squared(imaginary_[place]);
  }

 private:
  Vec<2> unit_;
  int most_m_;
  std::size_t row_;
  std::vector<double> real_, imaginary_;
  std::vector<double> up_real_, up_imaginary_;
};

/// Correlation of the amplitudes of independent points at wave vectors that are `steps` grid steps apart along an axis:
/// the Fourier components of the squared window.
double amplitude_correlation(int steps, bool hann) {
  if (steps == 0) return 1.0;
  if (!hann || std::abs(steps) > 2) return 0.0;
  return std::abs(steps) == 1 ? 2.0 / 3.0 : 1.0 / 6.0;
}

}  // namespace

std::vector<double> structure_factor(const std::vector<Vec<2>>& points, const std::vector<Vec<2>>& wave_vectors,
                                     const Slab& slab, Window window) {
  std::vector<double> weights;
  double squares = 0.0;
  for (const auto& point : points) {
    weights.push_back(weight(point, slab, window));
    squares += squared(weights.back());
  }
  std::vector<double> result;
  for (const auto& q : wave_vectors) {
    double real = 0.0;
    double imaginary = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double phase = dot(q, points[k]);
      real += weights[k] * std::cos(phase);
      imaginary -= weights[k] * std::sin(phase);
    }
    result.push_back((squared(real) + squared(imaginary)) / squares);
  }
  return result;
}

IsotropicStructureFactor isotropic_structure_factor(const std::vector<Vec<2>>& points, const Slab& slab,
                                                    const StructureFactorOptions& options) {
  IsotropicStructureFactor result;
  if (points.empty() || !(options.largest > 0.0) || options.shells == 0) return result;
  const double largest = options.largest;
  const double vectors = 0.5 * pi * largest * largest * slab.area() / squared(2.0 * pi);
  const int stride =
      std::max(1, static_cast<int>(std::ceil(std::sqrt(vectors / static_cast<double>(options.most_vectors)))));
  const Vec<2> unit{{2.0 * pi * stride / slab.box.width(), 2.0 * pi * stride / slab.height()}};
  const int most_k = static_cast<int>(largest / unit[0]);
  const int most_m = static_cast<int>(largest / unit[1]);
  std::vector<int> reach;
  for (int k = 0; k <= most_k; ++k) {
    reach.push_back(static_cast<int>(std::sqrt(std::max(0.0, squared(largest) - squared(k * unit[0]))) / unit[1]));
  }

  Waves waves(unit, most_k, most_m);
  double squares = 0.0;
  for (const auto& point : points) {
    const double w = weight(point, slab, options.window);
    squares += w * w;
    waves.add(point - Vec<2>{{slab.box.x_min, slab.low}}, w, reach);
  }

  const bool smeared_y = options.window == Window::hann;
  const bool smeared_x = smeared_y && !slab.box.periodic;
  // The shell of a wave vector, -1 for none. A Hann window has three Fourier components, 0 and +-1, so the mean density
  // contributes at these wave vectors only.
  const auto shell_of = [&](int k, int m) {
    if (std::abs(k) > most_k || std::abs(m) > reach[static_cast<std::size_t>(std::abs(k))]) return -1;
    if (std::abs(k) * stride <= (smeared_x ? 1 : 0) && std::abs(m) * stride <= (smeared_y ? 1 : 0)) return -1;
    const double place = std::hypot(k * unit[0], m * unit[1]) / largest;
    const auto shells = static_cast<int>(options.shells);
    return std::min(shells - 1, static_cast<int>(place * shells));
  };
  // The sum of the correlations of S between a wave vector and those in its shell, itself included: the factor by which
  // the variance of the shell's mean exceeds that of independent values.
  const auto dependence = [&](int k, int m, int shell) {
    const int wide = smeared_x ? 2 / stride : 0;
    const int high = smeared_y ? 2 / stride : 0;
    double sum = 0.0;
    for (int dk = -wide; dk <= wide; ++dk) {
      for (int dm = -high; dm <= high; ++dm) {
        if (shell_of(k + dk, m + dm) != shell) continue;
        sum += squared(amplitude_correlation(dk * stride, smeared_x) * amplitude_correlation(dm * stride, smeared_y));
      }
    }
    return sum;
  };
  std::vector<std::vector<double>> values(options.shells);
  std::vector<double> wave_numbers(options.shells, 0.0);
  std::vector<double> dependences(options.shells, 0.0);
  for (int k = 0; k <= most_k; ++k) {
    const int furthest = reach[static_cast<std::size_t>(k)];
    for (int m = k == 0 ? 1 : -furthest; m <= furthest; ++m) {
      const int shell = shell_of(k, m);
      if (shell < 0) continue;
      const auto s = static_cast<std::size_t>(shell);
      values[s].push_back(waves.power(static_cast<std::size_t>(k), m) / squares);
      wave_numbers[s] += std::hypot(k * unit[0], m * unit[1]);
      dependences[s] += dependence(k, m, shell);
    }
  }
  for (std::size_t s = 0; s < options.shells; ++s) {
    if (values[s].empty()) continue;
    const auto mean = mean_of(values[s]);
    const auto count = static_cast<double>(mean.count);
    result.wave_number.push_back(wave_numbers[s] / count);
    result.value.push_back(mean.mean);
    result.error.push_back(mean.error * std::sqrt(dependences[s] / count));
    result.vectors.push_back(mean.count);
  }
  return result;
}

}  // namespace repose
