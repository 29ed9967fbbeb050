// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/base_rings.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {

namespace {

constexpr double dip_inner = 0.15;  // [loaded radii]
constexpr double dip_outer = 0.45;
constexpr double most_rings = 1e6;

/// Where a load lies about the axis, and what it adds to a part of a ring.
struct PolarLoad {
  double radius;
  std::size_t sector;
  double normal;  // downwards
  double radial;  // outwards
};

std::vector<PolarLoad> polar(const std::vector<BaseLoad>& loads, const BaseRingSettings& settings) {
  std::vector<PolarLoad> result;
  result.reserve(loads.size());
  for (const auto& load : loads) {
    const Vec<2> from_axis = load.place - settings.axis;
    const double radius = magnitude(from_axis);
    double turn = std::atan2(from_axis[1], from_axis[0]) / (2.0 * std::numbers::pi);
    if (turn < 0.0) turn += 1.0;
    const auto sector = static_cast<std::size_t>(turn * static_cast<double>(settings.sectors));
    const double radial = radius > 0.0 ? (load.force[0] * from_axis[0] + load.force[1] * from_axis[1]) / radius : 0.0;
    result.push_back({radius, std::min(sector, settings.sectors - 1), -load.force[2], radial});
  }
  return result;
}

/// The sums over one sector of a ring.
struct Part {
  double count = 0.0;
  double normal = 0.0;
  double radial = 0.0;

  void add(const PolarLoad& load) {
    count += 1.0;
    normal += load.normal;
    radial += load.radial;
  }
};

double ring_area(double inner, double outer) { return std::numbers::pi * (outer - inner) * (outer + inner); }

/// The area of a sector of a ring.
double area_of(const Part& part, double inner, double outer, const BaseRingSettings& settings) {
  if (settings.area_of_load) return part.count * *settings.area_of_load;
  return ring_area(inner, outer) / static_cast<double>(settings.sectors);
}

/// The mean of a force per area over the sectors of a ring, but one.
double per_area(const std::vector<Part>& parts, double Part::*force, double inner, double outer,
                const BaseRingSettings& settings, std::size_t without) {
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (k == without) continue;
    sum += parts[k].*force;
    area += area_of(parts[k], inner, outer, settings);
  }
  return area > 0.0 ? sum / area : no_number;
}

}  // namespace

std::vector<BaseLoad> loads_on_base_grains(const OrderedGrains<3>& grains, const Contacts<3>& contacts) {
  std::vector<Vec<3>> force(grains.size());
  const auto add = [&](std::int64_t on, std::int64_t from, const Vec<3>& value) {
    const auto at = grains.find(on).value();
    if (grains->base[at] && !grains->line[grains.find(from).value()].fixed()) force[at] += value;
  };
  for (const auto& contact : contacts.list) {
    if (contact.second < 0) continue;
    const Vec<3> on_first = force_of(contact);
    add(contact.first, contact.second, on_first);
    add(contact.second, contact.first, -on_first);
  }
  std::vector<BaseLoad> loads;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!grains->base[k]) continue;
    const auto& position = grains->line[k].position;
    loads.push_back({{{position[0], position[1]}}, force[k]});
  }
  return loads;
}

std::vector<BaseLoad> loads_on_walls(const OrderedGrains<3>& grains, const Contacts<3>& contacts,
                                     const std::vector<bool>& walls) {
  std::vector<BaseLoad> loads;
  for (const auto& contact : contacts.list) {
    if (contact.second >= 0 || !walls[static_cast<std::size_t>(-1 - contact.second)]) continue;
    const auto& grain = grains->line[grains.find(contact.first).value()];
    if (grain.fixed()) continue;
    const Vec<3> point = grain.position - contact.normal * contact.first_lever;
    loads.push_back({{{point[0], point[1]}}, -force_of(contact)});
  }
  return loads;
}

std::optional<double> loaded_radius(const std::vector<BaseLoad>& loads, const Vec<2>& axis) {
  struct Step {
    double radius, normal;
  };
  std::vector<Step> steps;
  double all = 0.0;
  for (const auto& load : loads) {
    steps.push_back({magnitude(load.place - axis), -load.force[2]});
    all -= load.force[2];
  }
  if (!(all > 0.0)) return std::nullopt;
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.radius < b.radius; });
  double sum = 0.0;
  for (const auto& step : steps) {
    sum += step.normal;
    if (sum >= part_in_loaded_radius * all) return step.radius;
  }
  return std::nullopt;
}

std::optional<Estimate> dip_index(const std::vector<BaseLoad>& loads, const BaseRingSettings& settings,
                                  double loaded_radius) {
  const double inner_end = dip_inner * loaded_radius;
  const double outer_end = dip_outer * loaded_radius;
  std::vector<Part> inner(settings.sectors);
  std::vector<Part> outer(settings.sectors);
  for (const auto& load : polar(loads, settings)) {
    if (load.radius <= inner_end) {
      inner[load.sector].add(load);
    } else if (load.radius <= outer_end) {
      outer[load.sector].add(load);
    }
  }
  const auto index = jackknife(settings.sectors, [&](std::size_t without) {
    return per_area(outer, &Part::normal, inner_end, outer_end, settings, without) /
           per_area(inner, &Part::normal, 0.0, inner_end, settings, without);
  });
  if (!std::isfinite(index.mean) ||
      !(per_area(inner, &Part::normal, 0.0, inner_end, settings, settings.sectors) > 0.0)) {
    return std::nullopt;
  }
  return index;
}

BaseRings measure_base_rings(const std::vector<BaseLoad>& loads, const BaseRingSettings& settings) {
  REPOSE_ASSERT(settings.width > 0.0 && settings.sectors >= 2);
  BaseRings result;
  std::vector<std::vector<Part>> parts;
  for (const auto& load : polar(loads, settings)) {
    result.load += load.normal;
    const double place = load.radius / settings.width;
    if (!(place < most_rings)) continue;
    const auto ring = static_cast<std::size_t>(place);
    if (ring >= parts.size()) parts.resize(ring + 1, std::vector<Part>(settings.sectors));
    parts[ring][load.sector].add(load);
  }
  double cumulative = 0.0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    BaseRing ring;
    ring.inner = static_cast<double>(k) * settings.width;
    ring.outer = static_cast<double>(k + 1) * settings.width;
    for (const auto& part : parts[k]) {
      ring.count += static_cast<std::size_t>(part.count);
      ring.area += area_of(part, ring.inner, ring.outer, settings);
      cumulative += part.normal;
    }
    const auto mean = [&](double Part::*force) {
      return jackknife(settings.sectors, [&](std::size_t without) {
        return per_area(parts[k], force, ring.inner, ring.outer, settings, without);
      });
    };
    const auto pressure = mean(&Part::normal);
    const auto shear = mean(&Part::radial);
    ring.pressure = pressure.mean;
    ring.pressure_error = pressure.error;
    ring.shear = shear.mean;
    ring.shear_error = shear.error;
    ring.cumulative = cumulative;
    result.rings.push_back(ring);
  }
  result.loaded_radius = loaded_radius(loads, settings.axis);
  if (result.loaded_radius) result.dip_index = dip_index(loads, settings, *result.loaded_radius);
  return result;
}

}  // namespace repose
