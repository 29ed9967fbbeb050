// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/time_step.hpp"

#include "repose/core/vec.hpp"
#include "repose/laws/impact.hpp"
#include "repose/laws/inertia.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

namespace {

/// [L] R* of two grains, or of a grain and a flat wall.
double effective_radius(const GrainSize& mover, const GrainSize& partner) {
  if (partner.flat) return 0.5 * mover.diameter;
  return 0.5 * mover.diameter * partner.diameter / (mover.diameter + partner.diameter);
}

/// The normal force [M L/T^2] of Hertz's law where the contact carries `force`: more, if it adheres.
double load_of_normal_law(const ContactLaws& laws, double radius, double force) {
  const auto* adhesion = std::get_if<Jkr>(&laws.cohesion);
  return adhesion == nullptr ? force : at_radius(*adhesion, radius).apparent_load(force);
}

/// The linear response of a contact to a displacement and a velocity.
struct Response {
  double stiffness;  // [M/T^2]
  double dashpot;    // [M/T]
};

/// The response along the normal, at rest at this touch.
Response normal_response(const AnyNormal& law, Touch<double> touch) {
  const auto rest = normal_force(law, touch);
  touch.closing_speed = 1e-6;
  return {rest.stiffness, (normal_force(law, touch).total - rest.total) / touch.closing_speed};
}

/// The response along the tangent, from a displacement and a velocity too small to slide.
Response surface_response(const AnyTangential& law, const Touch<double>& touch, const NormalForce<double>& normal) {
  const double small = 1e-9 * touch.diameter;
  const double speed = 1e-9;
  double displaced = small;
  double undisplaced = 0.0;
  return {-tangential_force(law, touch, normal, 0.0, 0.0, displaced) / small,
          -tangential_force(law, touch, normal, speed, 0.0, undisplaced) / speed};
}

/// The response of rolling resistance, likewise.
Response rolling_response(const AnyRolling& law, const Touch<double>& touch, const NormalForce<double>& normal,
                          int dimension) {
  const double small = 1e-9 * touch.diameter;
  const double speed = 1e-9;
  const auto of = [&](auto along) {
    auto displaced = along * small;
    auto undisplaced = along * 0.0;
    return Response{magnitude(rolling_force(law, touch, normal, along * 0.0, 0.0, displaced)) / small,
                    magnitude(rolling_force(law, touch, normal, along * speed, 0.0, undisplaced)) / speed};
  };
  return dimension == 3 ? of(Vec<3>{{1.0, 0.0, 0.0}}) : of(1.0);
}

/// The response of the resistance to twisting, likewise; none in 2D.
Response twisting_response(const AnyTwisting& law, const Touch<double>& touch, const NormalForce<double>& normal,
                           int dimension) {
  if (dimension == 2) return {0.0, 0.0};
  const double small = 1e-9 * touch.diameter;
  const double speed = 1e-9;
  double displaced = small;
  double undisplaced = 0.0;
  return {-twisting_force(law, touch, normal, 0.0, 0.0, displaced) / small,
          -twisting_force(law, touch, normal, speed, 0.0, undisplaced) / speed};
}

/// Sums over the normals n of the contacts of a grain in a dense bed, of a unit displacement u and a unit spin w; see
/// `largest_step_of_bed`.
struct Neighbours {
  double approach;          // of (u.n)^2
  double slip_of_approach;  // of 1 - (u.n)^2, over that
  double turn;              // of the square of the part of w that slips or rolls
  double twist_of_turn;     // of (w.n)^2, over that
};

Neighbours neighbours_in(int dimension) {
  return dimension == 3 ? Neighbours{4.0, 2.0, 8.0, 0.5} : Neighbours{3.0, 1.0, 6.0, 0.0};
}

double largest_stable_step(const Response& mode) {
  const double c = mode.dashpot;
  const double k = mode.stiffness;
  return 4.0 / (c + std::sqrt(c * c + 4.0 * k));
}

}  // namespace

StiffestContact stiffest_contact(const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner,
                                 double gravity, double fall, int dimension) {
  const double m = mover.mass;
  const double pair_mass = 2.0 * m * partner.mass / (m + partner.mass);
  const double diameter = 0.5 * (mover.diameter + partner.diameter);
  double normal =
      std::visit([&](const auto& law) { return stiffness_at(law, pair_mass, diameter, m * gravity * fall); },
                 at_radius(laws.normal, effective_radius(mover, partner)));
  if (const auto* adhesion = std::get_if<Jkr>(&laws.cohesion)) {
    normal = std::max(normal, stiffness_at(at_radius(*adhesion, effective_radius(mover, partner)), m * gravity * fall));
  }
  const auto at_surface = [&](const auto& law) { return surface_stiffness(law, normal, m, inertia_in(dimension)); };
  const double stiffest =
      std::max({normal, std::visit(at_surface, laws.tangential), std::visit(at_surface, laws.rolling),
                dimension == 3 ? std::visit(at_surface, laws.twisting) : 0.0});
  return {std::sqrt(stiffest / m)};
}

double largest_step_of_bed(const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner, double force,
                           int dimension) {
  const double m = mover.mass;
  const double pair_mass = 2.0 * m * partner.mass / (m + partner.mass);
  const double diameter = 0.5 * (mover.diameter + partner.diameter);
  const AnyNormal normal_law{at_radius(laws.normal, effective_radius(mover, partner))};
  const double load = load_of_normal_law(laws, effective_radius(mover, partner), force);
  const double overlap = static_overlap(normal_law, pair_mass, diameter, load);
  if (!std::isfinite(overlap)) return std::numeric_limits<double>::infinity();
  const double distance = diameter - overlap;
  const auto touch = make_touch(distance, 1.0 / distance, diameter, reach(normal_law) * diameter, 0.0, pair_mass);
  const auto normal = normal_response(normal_law, touch);
  const auto surface = surface_response({laws.tangential}, touch, normal_force(normal_law, touch));
  const auto rolling = rolling_response({laws.rolling}, touch, normal_force(normal_law, touch), dimension);
  const auto twisting = twisting_response({laws.twisting}, touch, normal_force(normal_law, touch), dimension);
  const auto sums = neighbours_in(dimension);
  const double inertia = inertia_in(dimension).inverse;
  const auto step_of = [&](double sum, const Response& one, double ratio, const Response& other) {
    return largest_stable_step(
        {sum * (one.stiffness + ratio * other.stiffness) / m, sum * (one.dashpot + ratio * other.dashpot) / m});
  };
  const double against = step_of(2.0 * sums.approach, normal, sums.slip_of_approach, surface);
  const double spinning = step_of(2.0 * inertia * sums.turn, surface, sums.twist_of_turn, twisting);
  const double turning_apart = step_of(2.0 * inertia * sums.turn, rolling, sums.twist_of_turn, twisting);
  return std::min({against, spinning, turning_apart});
}

double least_piston_mass(const ContactLaws& laws, const GrainSize& grain, const PistonLoad& load, double step) {
  const double m = grain.mass;
  const double d = grain.diameter;
  const AnyNormal normal_law{at_radius(laws.normal, 0.5 * d)};
  const double overlap = static_overlap(normal_law, m, d, load_of_normal_law(laws, 0.5 * d, load.force));
  if (!std::isfinite(overlap)) return 0.0;
  const double distance = d - overlap;
  const double inverse_mass = 1.0 / m + 1.0 / load.mass;
  const auto touch = make_touch(distance, 1.0 / distance, d, reach(normal_law) * d, 0.0, m, inverse_mass, 0.5 * d);
  const auto normal = normal_response(normal_law, touch);
  const auto surface = surface_response({laws.tangential}, touch, normal_force(normal_law, touch));
  const double head_on = load.alignment * load.alignment;
  const double stiffness =
      load.stiffness + load.count * (head_on * normal.stiffness + (1.0 - head_on) * surface.stiffness);
  const double dashpot = load.drag + load.count * (head_on * normal.dashpot + (1.0 - head_on) * surface.dashpot);
  const double dt = step / auto_part_of_bed;
  return 0.25 * (stiffness * dt * dt + 2.0 * dashpot * dt);
}

}  // namespace repose
