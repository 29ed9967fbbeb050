// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/heap_zones.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace repose {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

/// A part of the heap: distance from the apex over the half-width, height above the base over that of the apex.
struct Zone {
  double nearest, farthest, low, high;
};
constexpr Zone middle{0.0, 0.15, 0.4, 0.6};
constexpr Zone lower{0.0, 0.15, 0.1, 0.3};
constexpr Zone flanks{0.3, 0.7, 0.1, 1.0};

class Frame {
 public:
  Frame(const HeapShape& heap, const Fields& fields, double base_height)
      : heap_(heap),
        fields_(fields),
        base_height_(base_height),
        half_width_(0.5 * (heap.surface.back().x - heap.surface.front().x)) {}

  /// Calls use(cell, outward) for the cells of a zone; outward is 1 on the right of the apex, -1 on the left.
  void each(const Zone& zone, const std::function<void(std::size_t, double)>& use) const {
    for (std::size_t row = 0; row < fields_.y.size(); ++row) {
      const double height = (fields_.y[row] - base_height_) / heap_.apex_height;
      if (height < zone.low || height > zone.high) continue;
      for (std::size_t column = 0; column < fields_.x.size(); ++column) {
        const double offset = (fields_.x[column] - heap_.apex_x) / half_width_;
        if (std::fabs(offset) < zone.nearest || std::fabs(offset) > zone.farthest) continue;
        use(row * fields_.x.size() + column, offset < 0.0 ? -1.0 : 1.0);
      }
    }
  }

  double mean_solid_fraction(const Zone& zone) const {
    double sum = 0.0;
    double count = 0.0;
    each(zone, [&](std::size_t cell, double) {
      sum += fields_.solid_fraction[cell];
      count += 1.0;
    });
    return sum / count;
  }

  /// Stress of the flanks, with the shear of the left one turned to that of the right; its major axis.
  double stress_inclination() const {
    double xx = 0.0;
    double yy = 0.0;
    double outward_xy = 0.0;
    each(flanks, [&](std::size_t cell, double outward) {
      xx += fields_.stress[0][cell];
      yy += fields_.stress[3][cell];
      outward_xy += outward * 0.5 * (fields_.stress[1][cell] + fields_.stress[2][cell]);
    });
    // The axis at an angle a from x has the shear (p1 - p2) sin a cos a; outwards and down is a below x on the right.
    const double angle = 0.5 * std::atan2(-2.0 * outward_xy, xx - yy);
    return degrees * (angle < 0.0 ? angle + std::numbers::pi : angle);
  }

 private:
  const HeapShape& heap_;
  const Fields& fields_;
  double base_height_;
  double half_width_;
};

}  // namespace

std::optional<HeapZones> heap_zones(const HeapShape& heap, const Fields& fields, double base_height) {
  if (heap.surface.size() < 2 || !(heap.apex_height > 0.0) || fields.density.empty()) return std::nullopt;
  const Frame frame(heap, fields, base_height);
  HeapZones zones;
  zones.middle_solid_fraction = frame.mean_solid_fraction(middle);
  zones.lower_solid_fraction = frame.mean_solid_fraction(lower);
  zones.stress_inclination_deg = frame.stress_inclination();
  zones.steeper_than_surface_deg = std::numeric_limits<double>::quiet_NaN();
  if (heap.left && heap.right) {
    const double angle = 0.5 * (heap.left->angle_deg + heap.right->angle_deg);
    zones.steeper_than_surface_deg = zones.stress_inclination_deg - angle;
  }
  if (std::isnan(zones.middle_solid_fraction) || std::isnan(zones.lower_solid_fraction)) return std::nullopt;
  return zones;
}

}  // namespace repose
