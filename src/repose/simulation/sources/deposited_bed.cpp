// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/bases/deposited_bed.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/team.hpp"
#include "repose/methods/deposition/spheres.hpp"
#include "repose/simulation/sources/draw.hpp"
#include "repose/simulation/sources/initial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

namespace repose {

namespace {

/// A deposit on a level floor in a square periodic box about the origin, which leaves a diameter around the base. As
/// many spheres are dropped as fill it to a thickness [L] at the solid fraction of such deposits.
Grains<3> random_deposit(const Scene& scene, double base_radius, double thickness) {
  constexpr double solid_fraction = 0.58;  // Visscher and Bolsterli (1972)
  const double largest = scene.largest_drawn();
  const double half = base_radius + largest;
  const GrainDraw<3> sizes(scene, Purpose::base_species, Purpose::base_size);
  SphereDepositionSettings settings;
  settings.critical_angle_deg = 0.0;
  settings.box.periodic = settings.box.periodic_y = true;
  settings.box.x_min = settings.box.y_min = -half;
  settings.box.x_max = settings.box.y_max = half;
  settings.floor = 0.0;
  settings.largest_radius = 0.5 * largest;
  double missing = solid_fraction * thickness * 4.0 * half * half;
  for (; missing > 0.0; ++settings.count) {
    const double radius = sizes(static_cast<std::uint64_t>(settings.count)).grain.radius;
    missing -= 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  }
  settings.draw = [&sizes, seed = static_cast<std::uint64_t>(scene.seed)](std::int64_t k,
                                                                          std::span<DroppedSphere> spheres) {
    for (auto& sphere : spheres) {
      const auto index = static_cast<std::uint64_t>(k++);
      const auto random = [&](std::uint32_t draw) { return uniform(seed, Purpose::base_height, index, draw); };
      const auto grain = sizes(index).grain;
      sphere = {{random(1), random(2)}, grain.radius, grain.mass, 0};
    }
  };
  Grains<3> grains;
  Team team(1);
  const auto method = make_sphere_deposition(settings);
  method->grains_added(grains);
  if (method->advance(grains, static_cast<double>(settings.count), team).trouble) {
    throw RunError(
        "the deposited base cannot be made: a sphere finds no place to rest; another seed makes another one");
  }
  return grains;
}

/// Where the centre of a sphere ends that falls straight down onto others, at the nodes of a square grid about the
/// origin.
class Landings {
 public:
  Landings(double half, double probe_radius)
      : half_(half),
        probe_(probe_radius),
        count_(static_cast<long>(std::ceil(2.0 * half / spacing())) + 1),
        height_(static_cast<std::size_t>(count_ * count_), -std::numeric_limits<double>::infinity()) {}

  void add(const Grain<3>& sphere) {
    for_nodes(sphere, [&](std::size_t node, double height) { height_[node] = std::max(height_[node], height); });
  }

  /// The least distance [L] that a sphere lies below what covers it: 0 where the falling one can touch it.
  double cover(const Grain<3>& sphere) const {
    double least = std::numeric_limits<double>::infinity();
    for_nodes(sphere, [&](std::size_t node, double height) { least = std::min(least, height_[node] - height); });
    return least;
  }

  /// The mean height [L] of the nodes within a distance of the origin.
  double mean(double distance) const {
    double sum = 0.0;
    double count = 0.0;
    for (long i = 0; i < count_; ++i) {
      for (long j = 0; j < count_; ++j) {
        if (place(i) * place(i) + place(j) * place(j) > distance * distance) continue;
        sum += height_[static_cast<std::size_t>(i * count_ + j)];
        count += 1.0;
      }
    }
    return sum / count;
  }

 private:
  double spacing() const { return 0.5 * probe_; }
  double place(long node) const { return static_cast<double>(node) * spacing() - half_; }

  /// Calls use(node, height of the falling sphere there on this one alone) for the nodes at which they touch.
  template <class Use>
  void for_nodes(const Grain<3>& sphere, const Use& use) const {
    const double reach = sphere.radius + probe_;
    const auto first = [&](double at) {
      return std::max(0L, std::lround(std::ceil((at - reach + half_) / spacing())));
    };
    const auto last = [&](double at) {
      return std::min(count_ - 1, std::lround(std::floor((at + reach + half_) / spacing())));
    };
    const auto& centre = sphere.position;
    for (long i = first(centre[0]); i <= last(centre[0]); ++i) {
      const double x = place(i) - centre[0];
      for (long j = first(centre[1]); j <= last(centre[1]); ++j) {
        const double y = place(j) - centre[1];
        const double rise = reach * reach - x * x - y * y;
        if (rise >= 0.0) use(static_cast<std::size_t>(i * count_ + j), centre[2] + std::sqrt(rise));
      }
    }
  }

  double half_;
  double probe_;
  long count_;
  std::vector<double> height_;
};

/// The spheres of a deposit within `radius` of the middle that grains from above can reach. Those that stick out of the
/// surface are left out: centres lie at most at its mean height. Of the others all are kept that lie less than a
/// largest diameter below the landings of the smallest grain, since a grain that moves sideways under one of the
/// uppermost meets the next ones.
std::vector<Grain<3>> spheres_at_surface(const Grains<3>& deposit, double radius, double smallest, double largest) {
  const double half = radius + largest;
  const double probe = 0.5 * smallest;
  Landings natural(half, probe);
  for (const auto& sphere : deposit.line) natural.add(sphere);
  const double highest = natural.mean(radius) - probe - 0.5 * largest;
  Landings landings(half, probe);
  for (const auto& sphere : deposit.line) {
    if (sphere.position[2] <= highest) landings.add(sphere);
  }
  std::vector<Grain<3>> kept;
  for (const auto& sphere : deposit.line) {
    const auto& place = sphere.position;
    const bool within = place[0] * place[0] + place[1] * place[1] <= radius * radius;
    if (within && place[2] <= highest && landings.cover(sphere) < largest) kept.push_back(sphere);
  }
  return kept;
}

}  // namespace

/// The highest centre lies at height 0.
void DepositedBed::add_grains(const Scene& scene, Grains<3>& grains, std::int64_t& id) const {
  const auto deposit = random_deposit(scene, radius, depth(scene));
  auto spheres = spheres_at_surface(deposit, radius, scene.smallest_drawn(), scene.largest_drawn());
  std::sort(spheres.begin(), spheres.end(), [](const auto& a, const auto& b) {
    return std::tie(a.position[0], a.position[1], a.position[2]) <
           std::tie(b.position[0], b.position[1], b.position[2]);
  });
  double highest = -std::numeric_limits<double>::infinity();
  for (const auto& sphere : spheres) highest = std::max(highest, sphere.position[2]);
  const auto number = scene.material_number(material);
  for (const auto& sphere : spheres) {
    auto grain = make_grain<3>(scene, 2.0 * sphere.radius, material);
    grain.inverse_mass = 0.0;
    grain.position = sphere.position;
    grain.position[2] -= highest;
    grains.add(grain, id++, true, number);
  }
}

}  // namespace repose
