// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/time_step.hpp"

#include "repose/boundaries/make_walls.hpp"
#include "repose/core/reproducible_math.hpp"
#include "repose/laws/any_law.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// What time steps are judged by: how fast grains fall, and the contacts that they can make.

namespace repose {

namespace {

/// The contacts between all materials and the sizes of grains that exist, at the ends of their range and the nominal
/// one if it lies between, and with walls: laws, who moves, and its partner. Grains of a start may be lighter than
/// others of their size; all then count as so light.
template <class Use>
void for_every_contact(const Scene& scene, const Use& use) {
  const auto names = scene.material_names();
  const auto laws = scene.material_laws();
  const bool start_alone = !scene.draws_grains() && scene.placed.empty();
  const double lightest = start_alone ? scene.start.lightest : std::min(1.0, scene.start.lightest);
  const auto size = [&](double diameter, const std::string& material) {
    return GrainSize{diameter, lightest * scene.mass_of(diameter, material)};
  };
  const bool walls = !scene.planes.empty() || !scene.pieces.empty() || scene.base->wall(scene);
  const double smallest = scene.smallest_diameter();
  const double largest = scene.largest_diameter();
  const double sizes[] = {smallest, std::clamp(scene.grains.diameter, smallest, largest), largest};
  for (std::size_t a = 0; a < names.size(); ++a) {
    for (std::size_t b = 0; b < names.size(); ++b) {
      for (const double mover : {sizes[0], sizes[2]}) {
        for (const double partner : sizes) {
          use(laws.table[a * names.size() + b], size(mover, names[a]), size(partner, names[b]));
        }
        if (!walls) continue;
        auto wall = size(mover, names[a]);
        wall.flat = true;
        use(laws.table[a * names.size() + b], size(mover, names[a]), wall);
      }
    }
  }
}

/// Height from which the fastest grain seems to fall [L].
double highest_fall(const Scene& scene) {
  double fall = std::max(scene.start.fall, scene.source->fall(scene));
  for (const auto& grain : scene.placed) {
    fall = std::max(fall, scene.rise(grain.velocity) + std::max(0.0, grain.position[scene.vertical()]));
  }
  return fall;
}

/// How many of the smallest grains may touch a wall side by side: all along a finite one, and between the sides of the
/// box and upright planes along an infinite one. Infinity for an upright infinite wall.
double side_by_side(const Scene& scene, const Wall<2>& wall) {
  const double d = scene.smallest_diameter();
  if (wall.finite()) return std::floor(2.0 * wall.half_length / d) + 1.0;
  if (std::fabs(wall.normal[1]) < std::fabs(wall.normal[0])) return std::numeric_limits<double>::infinity();
  const auto sides = upright_sides(scene);
  return std::floor(std::max(0.0, sides.right - sides.left) / std::fabs(wall.normal[1]) / d) + 1.0;
}
double side_by_side(const Scene& scene, const Wall<3>& wall) {
  const double d = scene.smallest_diameter();
  if (wall.finite()) return area(wall) / (d * d) + 1.0;
  if (std::fabs(wall.normal[2]) < 0.5) return std::numeric_limits<double>::infinity();
  const auto sides = upright_sides(scene);
  return std::max(0.0, sides.right - sides.left) * 2.0 * scene.box.half_depth / (d * d * std::fabs(wall.normal[2])) +
         1.0;
}

}  // namespace

template <int D>
Scene::LeastPiston Scene::least_piston(const repose::Wall<D>& piston) const {
  auto moving = static_cast<double>(source->released() + source->placed() + start.moving);
  for (const auto& grain : placed) moving += grain.fixed ? 0.0 : 1.0;
  LeastPiston least;
  least.grains = std::max(1.0, std::min(moving, side_by_side(*this, piston)));
  const auto& motion = piston.motion;
  const PistonLoad load{.count = least.grains,
                        .force = std::max(expected_column() * grain_weight(), motion.force / least.grains),
                        .alignment = dot(motion.direction, piston.normal),
                        .mass = motion.mass,
                        .stiffness = motion.stiffness,
                        .drag = motion.drag};
  for_every_contact(*this, [&](const ContactLaws& laws, const GrainSize& mover, const GrainSize&) {
    least.mass = std::max(least.mass, least_piston_mass(laws, mover, load, time_step()));
  });
  return least;
}

template Scene::LeastPiston Scene::least_piston(const repose::Wall<2>&) const;
template Scene::LeastPiston Scene::least_piston(const repose::Wall<3>&) const;

double Scene::rise(const Coordinates& velocity) const {
  const double square = velocity[0] * velocity[0] + velocity[1] * velocity[1] + velocity[2] * velocity[2];
  return gravity > 0.0 ? 0.5 * square / gravity : 0.0;
}

double Scene::contact_reach() const {
  double farthest = 1.0;
  if (!method->traits().force_laws) return farthest;
  for (const auto& laws : material_laws().table) farthest = std::max(farthest, reach(AnyNormal{laws.normal}));
  return farthest;
}

double Scene::contact_frequency() const {
  const double fall = highest_fall(*this);
  double frequency = 0.0;
  for_every_contact(*this, [&](const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner) {
    frequency = std::max(frequency,
                         stiffest_contact(laws, mover, partner, gravity, fall, static_cast<int>(dimension)).frequency);
  });
  return frequency;
}

double Scene::largest_step_of_bed() const {
  const double force = expected_column() * grain_weight();
  double step = std::numeric_limits<double>::infinity();
  for_every_contact(*this, [&](const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner) {
    step = std::min(step, repose::largest_step_of_bed(laws, mover, partner, force, static_cast<int>(dimension)));
  });
  return step;
}

double Scene::fastest_fall() const {
  // Without gravity nothing falls, but what is placed flies.
  if (gravity > 0.0) return std::sqrt(2.0 * gravity * highest_fall(*this));
  double fastest = 0.0;
  for (const auto& grain : placed)
    fastest = std::max(
        fastest, reproducible::hypot(reproducible::hypot(grain.velocity[0], grain.velocity[1]), grain.velocity[2]));
  return fastest;
}

}  // namespace repose
