// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/impact.hpp"

#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Head-on impacts against closed forms, and the soft method against the impacts.

namespace repose {
namespace {

using testing::settings_2d;
using testing::SoftWorld;

/// The restitution of a spring and dashpot that may not pull (Schwager & Poeschel 2007), or that may. An attraction
/// ends within a step at the edge of the reach, with an error of some 1e-5; otherwise the error is of fourth order.
double hooke_restitution(double damping, bool attraction) {
  const double b = damping;  // C / (2 m_red) for k = m_red = 1
  const double w = std::sqrt(1.0 - b * b);
  const double time = attraction ? std::numbers::pi : std::numbers::pi - std::atan2(2.0 * b * w, w * w - b * b);
  return std::exp(-b / w * time);
}

TEST(Impact, HookeAgainstTheClosedForm) {
  for (const bool attraction : {false, true}) {
    for (const double z : {0.0, 0.05, 0.2, 0.5, 0.7}) {
      // With m_ij = 2 m_red, as for two free grains, z of the nominal critical damping is sqrt(2) z of that of the
      // pair.
      const Hooke law{800.0, z / std::numbers::sqrt2, attraction};
      const auto impact = head_on({law}, {.mass = 1.4, .reduced_mass = 0.7, .diameter = 1.0, .speed = 0.3});
      EXPECT_NEAR(impact.restitution, hooke_restitution(z, attraction), attraction ? 1e-4 : 2e-6) << z << attraction;
      if (z == 0.0) {
        const double w = std::sqrt(800.0 / 0.7);
        EXPECT_NEAR(impact.duration, std::numbers::pi / w, 4e-3 / w);
        EXPECT_NEAR(impact.overlap, 0.3 / w, 1e-6 * 0.3 / w);
        EXPECT_NEAR(impact.force, 0.3 * w * 0.7, 1e-5 * 0.3 * w * 0.7);
      }
    }
  }
}

// F = k d^1.5: 0.4 k d_max^2.5 = m_red v^2 / 2; T = 2 d_max / v * integral of (1 - u^2.5)^(-1/2) = 2.94327 d_max / v.
TEST(Impact, HertzAgainstTheClosedForm) {
  const double integral = std::sqrt(std::numbers::pi) * std::tgamma(0.4) / (2.5 * std::tgamma(0.9));
  EXPECT_NEAR(2.0 * integral, 2.94327, 1e-5);
  for (const double speed : {0.01, 0.1, 1.0}) {
    const auto impact = head_on({Hertz{3e4, 0.0}}, {.mass = 1.0, .reduced_mass = 0.4, .diameter = 1.0, .speed = speed});
    const double deepest = std::pow(0.5 * 0.4 * speed * speed / (0.4 * 3e4), 0.4);
    EXPECT_NEAR(impact.overlap / deepest, 1.0, 1e-5);
    EXPECT_NEAR(impact.force / (3e4 * std::pow(deepest, 1.5)), 1.0, 1e-5);
    EXPECT_NEAR(impact.duration / (2.0 * integral * deepest / speed), 1.0, 3e-3);
    EXPECT_NEAR(impact.restitution, 1.0, 1e-6);
  }
}

// A dashpot relative to the local stiffness dissipates the same fraction at any speed.
TEST(Impact, HertzRestitutionDoesNotDependOnSpeed) {
  const auto at = [](double speed) {
    return head_on({Hertz{3e4, 0.2}}, {.mass = 1.0, .reduced_mass = 0.5, .diameter = 1.0, .speed = speed}).restitution;
  };
  EXPECT_NEAR(at(0.01), at(1.0), 1e-6);
  EXPECT_LT(at(1.0), 0.8);
}

NormalLaw with_request(NormalLaw law, double restitution) {
  std::visit(
      [&](auto& one) {
        one.damping_kind = DampingKind::restitution;
        one.restitution = restitution;
        if constexpr (requires { one.impact_speed; }) one.impact_speed = 1.3;
      },
      law);
  return law;
}

// The law has the requested restitution; if it does not depend on speed, for any masses.
TEST(Impact, RestitutionAsRequested) {
  for (const double e : {0.1, 0.3, 0.6, 0.9, 0.99, 1.0}) {
    for (const NormalLaw& given :
         {NormalLaw(Hooke{2e3}), NormalLaw(Hertz{2e4}), NormalLaw(Continuous::make(36, 1.2, 0.5, 1.0))}) {
      const auto law = with_restitution(with_request(given, e), 1.0, 1.0);
      EXPECT_NEAR(head_on({law}, {.mass = 1.0, .reduced_mass = 0.5, .diameter = 1.0, .speed = 1.3}).restitution, e,
                  1e-5);
      if (!std::holds_alternative<Continuous>(law)) {
        EXPECT_NEAR(head_on({law}, {.mass = 0.31, .reduced_mass = 0.05, .diameter = 0.7, .speed = 0.4}).restitution, e,
                    1e-5);
      }
    }
  }
}

// Two free grains, or a free and a fixed one, have the requested restitution under the method. Damping with velocities
// of the half step is of first order in w dt = 0.006, which gives an error of 5e-4.
TEST(Impact, RestitutionOfGrainsOfAnySize) {
  for (const double e : {0.2, 0.7}) {
    for (const NormalLaw& given : {NormalLaw(Hooke{2e3}), NormalLaw(Hertz{2e4})}) {
      const auto law = any_pair_law({with_restitution(with_request(given, e), 1.0, 1.0), None{}, {}, {}});
      for (const auto& [radius, fixed] : {std::pair{0.5, false}, std::pair{0.2, false}, std::pair{0.5, true}}) {
        SoftWorld<2, AnyPairLaw> world(law, settings_2d(1e-4, 0.0));
        const auto first = world.add({{0.0, 0.0}}, {{0.0, 0.0}}, 0.0, 0.5, fixed);
        const auto second = world.add({{0.0, 0.55 + radius}}, {{0.0, -0.5}}, 0.0, radius);
        world.advance(20000);
        EXPECT_NEAR(world[second].velocity[1] - world[first].velocity[1], 0.5 * e, 1e-3) << e << radius << fixed;
      }
    }
  }
}

TEST(Impact, RestitutionThatNoDampingGives) {
  const auto law = with_restitution(with_request(Hooke{2e3}, 1e-9), 1.0, 1.0);
  EXPECT_TRUE(std::isnan(std::get<Hooke>(law).damping));
}

TEST(Impact, OverlapAtRest) {
  EXPECT_NEAR(static_overlap({Hooke{500.0}}, 1.0, 1.0, 1.0), 0.002, 1e-12);
  EXPECT_NEAR(static_overlap({Hertz{1000.0}}, 1.0, 1.0, 8.0), 0.04, 1e-12);
  EXPECT_NEAR(static_overlap({Continuous::make(36, 1.2, 0.5, 1.0)}, 1.0, 1.0, 1.0), 0.0, 1e-12);
}

// At a fixed overlap and a small slip displacement, the force is ratio times the normal stiffness times the
// displacement. Pressing harder keeps the force, releasing reduces it.
TEST(MindlinLaw, ClosedForm) {
  const Mindlin law{0.5, 0.8};
  const Hertz normal{1e4, 0.0};
  double delta = 0.0;
  const auto touch_at = [](double overlap, double closing) {
    return make_touch(1.0 - overlap, 1.0 / (1.0 - overlap), 1.0, 1.0, closing, 1.0);
  };
  const auto held = touch_at(0.01, 0.0);
  const double stiffness = 0.8 * 1.5e4 * 0.1;
  EXPECT_NEAR(tangential_force(law, held, normal_force(normal, held), 0.1, 1e-3, delta), -stiffness * 1e-4, 1e-12);
  const auto pressed = touch_at(0.0121, 2.1);
  EXPECT_NEAR(tangential_force(law, pressed, normal_force(normal, pressed), 0.0, 1e-3, delta), -stiffness * 1e-4,
              1e-12);
  const auto let_go = touch_at(0.0025, -9.6);
  const double shorter = 1e-4 / 1.1;
  EXPECT_NEAR(delta, shorter, 1e-15);
  EXPECT_NEAR(tangential_force(law, let_go, normal_force(normal, let_go), 0.0, 1e-3, delta), -stiffness * 0.5 * shorter,
              1e-12);
}

// A disc that rolls on a wall under a torque of mu_r R N decelerates by 2/3 mu_r g (I = m R^2 / 2).
TEST(RollingSpring, RollingDecays) {
  auto settings = settings_2d(2e-4, 1.0);
  settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}}};
  const auto law = any_pair_law({Hooke{1e4, 0.5}, Linear{0.5, 5e3, 0.2}, RollingSpring{0.06, 200.0, 0.3}, {}});
  SoftWorld<2, AnyPairLaw> world(law, settings);
  const auto disc = world.add({{0.0, 0.5 - 1e-4}}, {{1.0, 0.0}}, -2.0);
  world.advance(50000);
  EXPECT_NEAR(world[disc].velocity[0], 1.0 - 2.0 / 3.0 * 0.06 * 10.0, 2e-3);
  world.advance(150000);
  // It stops after v^2 / (2 a) = 12.5, held by the spring, whose displacement 2/3 F / k is less than 1e-3.
  EXPECT_NEAR(world[disc].position[0], 12.5, 0.02);
  EXPECT_LT(std::fabs(world[disc].velocity[0]), 1e-6);
}

// On a slope a disc rests if tan(angle) < mu_r, and otherwise rolls down with the acceleration 2/3 g (sin - mu_r cos).
TEST(RollingSpring, SlopeOfRest) {
  for (const double slope : {0.15, 0.25}) {
    const double angle = std::atan(slope);
    auto settings = settings_2d(2e-4, 1.0);
    settings.walls = {Wall<2>{.point = {}, .normal = {{-std::sin(angle), std::cos(angle)}}}};
    const auto law = any_pair_law({Hooke{1e4, 0.5}, Linear{0.8, 5e3, 0.2}, RollingSpring{0.2, 2e4, 0.3}, {}});
    SoftWorld<2, AnyPairLaw> world(law, settings);
    const auto disc = world.add(settings.walls[0].normal * 0.4999);
    world.advance(100000);
    const double displacement = magnitude(world[disc].position - settings.walls[0].normal * 0.4999);
    if (slope < 0.2) {
      EXPECT_LT(displacement, 5e-3);
    } else {
      EXPECT_NEAR(displacement, (std::sin(angle) - 0.2 * std::cos(angle)) / 3.0 * 400.0, 0.1);
    }
  }
}

// The rolling torques on a pair are equal and opposite: two discs that rotate against each other stop together.
TEST(RollingSpring, TorquesAreOpposite) {
  const auto law = any_pair_law({Hooke{1e4, 0.5}, None{}, RollingSpring{0.3, 200.0, 0.1}, ConstantCohesion{5.0}});
  SoftWorld<2, AnyPairLaw> world(law, settings_2d(2e-4, 0.0));
  world.add({{0.0, 0.0}}, {}, 1.0, 0.5);
  world.add({{0.8995, 0.0}}, {}, -0.5, 0.4);
  const auto spin = [&](int k) { return 0.5 * world[k].mass * world[k].radius * world[k].rim_velocity; };
  const double before = spin(0) + spin(1);
  world.advance(200000);
  EXPECT_NEAR(spin(0) + spin(1), before, 1e-10);
  EXPECT_NEAR(world[0].rim_velocity / 0.5, world[1].rim_velocity / 0.4, 1e-3);
}

}  // namespace
}  // namespace repose
