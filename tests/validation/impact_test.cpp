// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/impact.hpp"

#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

// Impacts and friction of discs in the soft method against closed forms (docs/verification.md).

namespace repose {
namespace {

using testing::settings_2d;
using testing::SoftWorld;
using Law = PairLaw<Hooke, Linear>;
using World = SoftWorld<2, AnyPairLaw>;

constexpr double friction = 0.3;
constexpr double restitution = 0.8;

/// A stiff contact with restitution 0.8 and a tangential stiffness of 2/7 of the normal one.
AnyPairLaw stiff() {
  Hooke hooke{1e6};
  hooke.damping_kind = DampingKind::restitution;
  hooke.restitution = restitution;
  return any_pair_law({with_restitution(hooke, 1.0, 1.0), Linear{friction, 2e6 / 7.0, 0.0}, {}, {}});
}

struct Rebound {
  double normal;      ///< speed away from the wall
  double tangential;  ///< speed along the wall
  double spin;
  double energy;  ///< kinetic energy after over that before
};

/// A disc thrown at a wall without gravity.
Rebound thrown(double normal, double tangential, double spin) {
  auto settings = settings_2d(2e-5, 0.0);
  settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}}};
  World world(stiff(), settings);
  const auto disc = world.add({{0.0, 0.501}}, {{tangential, -normal}}, spin);
  const double before = kinetic_energy(world.grains);
  world.advance(5000);
  const auto& after = world[disc];
  return {after.velocity[1], after.velocity[0], after.rim_velocity / after.radius,
          kinetic_energy(world.grains) / before};
}

// Oblique impacts at all angles. If the contact slides throughout (|v_t| well above 3 mu (1 + e) v_n for a disc), the
// tangential impulse is mu times the normal one: v_t' = v_t - mu (1 + e) v_n and w' R = -2 mu (1 + e) v_n. No impact
// gains energy, also at grazing incidence. The damping is of first order in w dt = 0.02: 2e-3 of the impulse.
TEST(SoftOblique, ImpactAtEveryAngle) {
  int sliding = 0;
  for (int degrees = 1; degrees < 90; degrees += 2) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const double normal = std::cos(angle);
    const double tangential = std::sin(angle);
    const auto after = thrown(normal, tangential, 0.0);
    EXPECT_NEAR(after.normal, restitution * normal, 4e-3 * normal) << degrees;
    EXPECT_LT(after.energy, 1.0) << degrees;
    EXPECT_GT(after.energy, restitution * restitution * normal * normal) << degrees;
    const double impulse = friction * (1.0 + restitution) * normal;
    if (tangential < 4.2 * impulse) continue;  // sticks for some time, at the latest when the contact ends
    ++sliding;
    EXPECT_NEAR(after.tangential, tangential - impulse, 4e-3 * impulse) << degrees;
    EXPECT_NEAR(after.spin * 0.5, -2.0 * impulse, 8e-3 * impulse) << degrees;
  }
  EXPECT_GT(sliding, 9);
}

// Any impact with a wall, slipping or sticking, conserves the angular momentum about the contact point, m v_t R - I w
// (w counter-clockwise), to rounding, because the only forces act there.
TEST(SoftOblique, AngularMomentumAboutTheContact) {
  for (const auto& [tangential, spin] : {std::pair{0.3, 0.0}, std::pair{0.2, -2.0}, std::pair{-1.0, 5.0}}) {
    const auto after = thrown(1.0, tangential, spin);
    // The lever is the radius of the disc, independent of the overlap.
    EXPECT_NEAR(after.tangential * 0.5 - 0.125 * after.spin, tangential * 0.5 - 0.125 * spin, 1e-10);
  }
}

// A spinning disc falls vertically. It slides throughout if |w| R > 3 mu (1 + e) v_n, and leaves sideways.
TEST(SoftOblique, SpinningImpact) {
  const double impulse = friction * (1.0 + restitution);
  for (const double spin : {-8.0, 8.0}) {
    const auto after = thrown(1.0, 0.0, spin);
    const double side = spin > 0.0 ? -1.0 : 1.0;
    EXPECT_NEAR(after.tangential, side * impulse, 4e-3 * impulse);
    EXPECT_NEAR(after.spin * 0.5, spin * 0.5 + 2.0 * side * impulse, 8e-3 * impulse);
    EXPECT_LT(after.energy, 1.0);
  }
}

// A disc that cannot roll (mu_r = 5) sticks on a slope below the friction angle, and above it slides with the
// acceleration g (sin - mu cos), for the linear and the cumulative law. Until friction has built up, the disc gains a
// speed of some 4e-3, which adds 0.04 to its displacement in a time of 10.
TEST(SoftIncline, StickAndSlip) {
  for (const TangentialLaw& tangential :
       {TangentialLaw(Linear{0.4, 1e4, 0.2}), TangentialLaw(Cumulative{0.4, 1.214})}) {
    for (const double slope : {0.35, 0.45}) {
      const double angle = std::atan(slope);
      auto settings = settings_2d(2e-4, 1.0);
      settings.walls = {Wall<2>{.point = {}, .normal = {{-std::sin(angle), std::cos(angle)}}}};
      World world(any_pair_law({Hooke{2e4, 0.5}, tangential, RollingSpring{5.0, 5e3, 0.5}, {}}), settings);
      const Vec<2> start = settings.walls[0].normal * (0.5 - 5e-5 * std::cos(angle));
      const auto disc = world.add(start);
      world.advance(50000);  // time 10
      const double displacement = magnitude(world[disc].position - start);
      if (slope < 0.4) {
        EXPECT_LT(displacement, 2e-3);
        EXPECT_LT(magnitude(world[disc].velocity), 1e-4);
      } else {
        EXPECT_NEAR(displacement, (std::sin(angle) - 0.4 * std::cos(angle)) * 50.0, 0.05);
      }
    }
  }
}

// A stack of 20 discs: contact k from the top carries k weights, so its overlap is k m g / K, to 1e-7 once settled.
TEST(SoftStack, SettlesUnderItsWeight) {
  constexpr int count = 20;
  auto settings = settings_2d(1e-3, 1.0);
  settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}}};
  World world(any_pair_law({Hooke{1e4, 0.5}, Linear{0.5, 5e3, 0.2}, {}, {}}), settings);
  for (int k = 0; k < count; ++k) world.add({{0.0, 0.5 + k}});
  world.advance(200000);
  double height = 0.0;
  for (int k = 0; k < count; ++k) {
    height += (k == 0 ? 0.5 : 1.0) - (count - k) * 1e-4;
    EXPECT_NEAR(world[k].position[1], height, 1e-7) << k;
  }
  for (const auto& contact : world.contacts().list) {
    const double above = static_cast<double>(count - std::max(contact.first, contact.second));
    EXPECT_NEAR(contact.normal_force, contact.second < 0 ? count : above, 1e-3);
  }
}

/// The final velocities of three discs: a large disc drives a small one (a tenth of its size, a hundredth of its mass)
/// against another large one.
std::array<double, 3> three_grains(double time_step, bool synchronised) {
  auto settings = settings_2d(time_step, 0.0);
  settings.synchronised = synchronised;
  World world(any_pair_law({Hooke{1e4, 0.3}, None{}, {}, {}}), settings);
  world.add({{-0.56, 0.0}}, {{1.0, 0.0}});
  world.add({{0.0, 0.0}}, {}, 0.0, 0.05);
  world.add({{0.551, 0.0}});
  world.advance(std::lround(0.5 / time_step));
  return {world[0].velocity[0], world[1].velocity[0], world[2].velocity[0]};
}

// Three grains with size ratio 10: the small one bounces between the large ones. At w dt = 0.2 of the small grain both
// kinds of velocities agree, to a thousandth of the speed, with a step that is 32 times smaller.
TEST(SoftThreeGrains, SizeRatioOfTen) {
  const double step = 2e-4;
  const auto exact = three_grains(step / 32.0, true);
  EXPECT_NEAR(exact[0] + 0.01 * exact[1] + exact[2], 1.0, 1e-12);
  EXPECT_GT(exact[2], 0.3);
  for (const bool synchronised : {false, true}) {
    const auto found = three_grains(step, synchronised);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], exact[k], 1e-3) << synchronised << k;
  }
}

}  // namespace
}  // namespace repose
