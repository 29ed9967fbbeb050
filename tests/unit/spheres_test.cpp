// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "support/spheres.hpp"

#include "repose/laws/impact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// Motions of few spheres with closed forms, in random directions of space, by the soft method and by contact dynamics.
// A sphere has the mass 1, the radius R = 1/2 and I = 2/5 m R^2.

namespace repose {
namespace {

using testing::endless_plane;
using testing::number;
using testing::random_direction;
using testing::rigid_3d;
using testing::soft_3d;
using testing::Spheres;
using testing::spin_of;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The part of a across n, as a unit vector.
Vec<3> unit_across(const Vec<3>& a, const Vec<3>& n) {
  const Vec<3> across = tangential(a, n);
  return across * (1.0 / magnitude(across));
}

constexpr double stiffness = 1e4;

/// A sphere at rest on a plane with this normal, against which gravity 1 pulls it.
Spheres on_plane(const ContactLaws& laws, const Vec<3>& normal, double step = 1e-4) {
  auto settings = soft_3d(step, -normal);
  settings.walls = {endless_plane({}, normal)};
  return {laws, settings};
}
Spheres on_plane(const ImpulseLaw& law, const Vec<3>& normal) {
  auto settings = rigid_3d(1e-3, -normal);
  settings.walls = {endless_plane({}, normal)};
  return {law, settings};
}

// A sphere that slides ends rolling at 5/7 of its speed: the angular momentum about the line of contact is kept. Both
// methods keep it to rounding; the soft sphere is rolling once the tangential dashpot has damped its spring.
TEST(Spheres, ASlidingSphereEndsRolling) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Vec<3> normal = random_direction(seed);
    const Vec<3> velocity = unit_across(random_direction(seed, 2), normal) * 1.3;
    auto soft = on_plane({Hooke{stiffness, 0.5}, Linear{0.3, 3e3, 0.3}, {}, {}}, normal);
    auto rigid = on_plane({.friction = 0.3}, normal);
    soft.add(normal * (0.5 - 1.0 / stiffness), velocity);
    rigid.add(normal * 0.5, velocity);
    soft.advance(40000);
    rigid.advance(4000);
    for (auto* world : {&soft, &rigid}) {
      const auto& sphere = (*world)[0];
      EXPECT_LT(magnitude(sphere.velocity - velocity * (5.0 / 7.0)), 1e-10);
      EXPECT_LT(magnitude(sphere.velocity - cross(sphere.rim_velocity, normal)), 1e-10);  // it rolls
      EXPECT_NEAR(dot(sphere.rim_velocity, normal), 0.0, 1e-10);
    }
  }
}

// A sphere that spins about the normal of a plane slows down by mu_t N R / I = 5/2 mu_t g / R. While it slides, the
// twist of each step is the same, so that the spin falls exactly linearly; the first kick of the soft method is half a
// step.
TEST(Spheres, AConstantTwistingTorqueSlowsSpinLinearly) {
  const Vec<3> normal = random_direction(7);
  const ContactLaws laws{Hooke{stiffness, 0.5}, Linear{0.3, 3e3, 0.3}, {}, {}, TwistingConstant{{0.02, 1e-3}}};
  auto soft = on_plane(laws, normal);
  auto rigid = on_plane({.friction = 0.3, .twisting_friction = 0.02}, normal);
  soft.add(normal * (0.5 - 1.0 / stiffness), {}, normal * -3.0);
  rigid.add(normal * 0.5, {}, normal * -3.0);
  soft.advance(20000);
  rigid.advance(2000);
  const double rate = 2.5 * 0.02 / 0.5;  // 0.1: after 2 time units the spin is 2.8
  EXPECT_LT(magnitude(spin_of(soft[0]) + normal * (3.0 - rate * (2.0 - 0.5e-4))), 1e-9);
  EXPECT_LT(magnitude(spin_of(rigid[0]) + normal * (3.0 - rate * (2.0 - 0.5e-3))), 1e-9);
  // Contact dynamics then stops it, and keeps it at rest; the soft torque fades below a velocity of 1e-3.
  soft.advance(290000);
  rigid.advance(29000);
  EXPECT_LT(magnitude(spin_of(soft[0])), 2e-3);
  EXPECT_LT(magnitude(spin_of(rigid[0])), 1e-12);
}

// w decays as exp(-5/2 b t). The dashpot uses the velocity half a step old, an error of 5/4 b dt = 4e-5 of the
// exponent.
TEST(Spheres, AViscousTwistingTorqueLetsSpinDecay) {
  const Vec<3> normal = random_direction(8);
  auto world = on_plane({Hooke{stiffness, 0.5}, None{}, {}, {}, TwistingViscous{{10.0, 0.3}}}, normal);
  world.add(normal * (0.5 - 1.0 / stiffness), {}, normal * 2.0);
  world.advance(10000);
  EXPECT_NEAR(dot(spin_of(world[0]), normal), 2.0 * std::exp(-2.5 * 0.3), 2.0 * 1e-4);
  EXPECT_LT(magnitude(tangential(spin_of(world[0]), normal)), 1e-12);
}

// On a spring it oscillates with w^2 = k_w R^2 / I = 5/2 k_w / m, by the leapfrog w dt = 2 asin(w dt / 2), without
// loss: the displacement about the normal is kept from step to step and through new lists. A contact that begins has a
// whole step of displacement at its first force, which is a phase of one step and makes the amplitude larger by (w
// dt)^2 / 2 = 5e-5. The contact is that of two spheres, which keep their places as long as they spin about the
// vertical.
TEST(Spheres, ATwistingSpringOscillates) {
  const double step = 1e-3;
  const double k = 40.0;
  Spheres world({Hooke{stiffness, 0.5}, None{}, {}, {}, TwistingSpring{{1e3, k, 0.0}}},
                soft_3d(step, {{0.0, 0.0, -1.0}}));
  world.add({{0.0, 0.0, 0.0}}, {}, {}, 0.5, true);
  world.add({{0.0, 0.0, 1.0 - 1.0 / stiffness}}, {}, {{0.0, 0.0, 0.1}});
  const double frequency = 2.0 / step * std::asin(0.5 * step * std::sqrt(2.5 * k));
  for (int n = 1; n <= 5; ++n) {
    world.advance(777);
    world.refresh();                               // the list is built again
    const double time = (777.0 * n + 0.5) * step;  // of the velocity, and one step
    EXPECT_NEAR(spin_of(world[1])[2], 0.1 * std::cos(frequency * time), 1e-5);
  }
}

// The spring about the normal of a wall keeps its displacement likewise.
TEST(Spheres, ATwistingSpringOscillatesOnAPlane) {
  const double step = 1e-3;
  const Vec<3> normal = random_direction(9);
  auto world = on_plane({Hooke{stiffness, 0.5}, None{}, {}, {}, TwistingSpring{{1e3, 40.0, 0.0}}}, normal, step);
  world.add(normal * (0.5 - 1.0 / stiffness), {}, normal * 0.1);
  const double frequency = 2.0 / step * std::asin(0.5 * step * 10.0);
  for (int n = 1; n <= 5; ++n) {
    world.advance(777);
    world.refresh();
    const double time = (777.0 * n + 0.5) * step;
    EXPECT_NEAR(dot(spin_of(world[0]), normal), 0.1 * std::cos(frequency * time), 1e-5);
  }
}

/// The velocities of a sphere before and after an impact on a plane through the origin.
struct Thrown {
  Vec<3> normal;
  Grain<3> before;
  Grain<3> after;

  Vec<3> slip(const Grain<3>& of) const { return tangential(of.velocity, normal) - cross(of.rim_velocity, normal); }
  double energy_gain() const { return kinetic_energy(after) / kinetic_energy(before) - 1.0; }
  /// The change of the angular momentum about the place of contact, over m R.
  Vec<3> turn() const {
    return (after.rim_velocity - before.rim_velocity) * 0.4 + cross(normal, Vec<3>(after.velocity - before.velocity));
  }
};

/// Throws a sphere at a random plane, at this angle from the normal with speed 1 and a random spin.
template <class Law, class Settings>
Thrown thrown(const Law& law, Settings settings, double degrees, std::uint64_t seed, double gap, long steps) {
  Thrown of;
  of.normal = random_direction(seed);
  settings.walls = {endless_plane({}, of.normal)};
  Spheres world(law, settings);
  const double angle = degrees * std::numbers::pi / 180.0;
  const Vec<3> along = unit_across(random_direction(seed, 2), of.normal);
  const Vec<3> velocity = along * std::sin(angle) - of.normal * std::cos(angle);
  world.add(of.normal * (0.5 + gap), velocity, random_direction(seed, 4) * 3.0);
  of.before = world[0];
  world.advance(steps);
  of.after = world[0];
  return of;
}

// Hooke without friction limit: the normal velocity turns round with the requested restitution, and the surface moves
// as on a spring, by the factor cos(w T) with w^2 = 7/2 k_t / m over the time T = pi sqrt(m/k) of the contact.
TEST(Spheres, AnElasticImpactHasItsClosedForm) {
  const double factor = std::cos(std::numbers::pi * std::sqrt(3.5 * 2e3 / stiffness));
  const ContactLaws laws{Hooke{stiffness, 0.0}, Linear{1e9, 2e3, 0.0}, {}, {}};
  for (int degrees = 0; degrees <= 80; degrees += 10) {
    const auto of = thrown(laws, soft_3d(2e-6), degrees, 20 + static_cast<std::uint64_t>(degrees), 0.0, 17000);
    const double closing = -dot(of.before.velocity, of.normal);
    EXPECT_NEAR(dot(of.after.velocity, of.normal), closing, 1e-6);
    // The step in which the contact ends is known to one step, and so is its spring.
    EXPECT_LT(magnitude(of.slip(of.after) - of.slip(of.before) * factor), 3e-4 * magnitude(of.slip(of.before)));
    // What the spring holds when the contact ends is lost.
    const double held = (1.0 - factor * factor) / 3.5 * squared(of.slip(of.before));
    EXPECT_NEAR(kinetic_energy(of.before) - kinetic_energy(of.after), 0.5 * held, 2e-4);
    EXPECT_LT(magnitude(of.turn()), 1e-11);
  }
}

// With damping and friction no impact gains energy, of whatever angle, grazing included, and the restitution is that
// requested. The tolerance is the error of the integration, as in 2D (tests/contract/soft_contract_test.cpp).
TEST(Spheres, AnObliqueImpactGainsNoEnergy) {
  ContactLaws laws{Hooke{stiffness, 0.0, false, DampingKind::restitution, 0.7}, Linear{0.4, 3e3, 0.0}, {}, {}};
  laws.normal = with_restitution(laws.normal, 1.0, 1.0);
  for (int degrees = 0; degrees <= 90; degrees += 5) {
    const auto of = thrown(laws, soft_3d(1e-5), degrees, 40 + static_cast<std::uint64_t>(degrees), 1e-4, 20000);
    const double closing = -dot(of.before.velocity, of.normal);
    EXPECT_NEAR(dot(of.after.velocity, of.normal), closing < 1e-9 ? -closing : 0.7 * closing, 2e-4) << degrees;
    EXPECT_LE(of.energy_gain(), 1e-5) << degrees;
    EXPECT_LT(magnitude(of.turn()), 1e-11) << degrees;
    if (degrees < 60) {
      EXPECT_LT(of.energy_gain(), -0.02) << degrees;
    }
  }
}

// Rigid: the impulse is (1 + e) m v_n along the normal; across it the one that stops the slip, 2/7 m times the slip, or
// mu times the normal one against the slip.
TEST(Spheres, ARigidImpactHasItsClosedForm) {
  int slides = 0;
  for (int degrees = 0; degrees <= 85; degrees += 5) {
    const auto of = thrown(ImpulseLaw{.restitution = 0.6, .friction = 0.2}, rigid_3d(1e-3), degrees,
                           60 + static_cast<std::uint64_t>(degrees), 0.02, 300);
    const double push = 1.6 * -dot(of.before.velocity, of.normal);
    const Vec<3> slip = of.slip(of.before);
    const double stopped = magnitude(slip) / 3.5;
    slides += stopped > 0.2 * push ? 1 : 0;
    const Vec<3> across = slip * (-std::min(stopped, 0.2 * push) / magnitude(slip));
    EXPECT_LT(magnitude(of.after.velocity - (of.before.velocity + of.normal * push + across)), 1e-10) << degrees;
    EXPECT_LT(magnitude(of.turn()), 1e-12) << degrees;
    EXPECT_LE(of.energy_gain(), 1e-12) << degrees;
  }
  EXPECT_GT(slides, 4);
  EXPECT_LT(slides, 18);
}

// Two free spheres keep their angular momentum about the origin in an oblique impact, to rounding.
TEST(Spheres, FreeSpheresKeepAngularMomentum) {
  const auto momentum = [](const Spheres& world) {
    Vec<3> sum;
    for (const auto& g : world.grains.line) {
      sum += cross(g.position, g.velocity) * g.mass + g.rim_velocity * (0.4 * g.mass * g.radius);
    }
    return sum;
  };
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const ContactLaws laws{
        Hertz{1e5, 0.3}, Mindlin{0.4, 0.8, 0.1}, RollingSpring{0.1, 200.0, 0.3}, {}, TwistingSpring{{0.1, 200.0, 0.3}}};
    Spheres soft(laws, soft_3d(1e-4));
    Spheres rigid(ImpulseLaw{.restitution = 0.5, .friction = 0.4, .rolling_friction = 0.1, .twisting_friction = 0.1},
                  rigid_3d(1e-3));
    for (auto* world : {&soft, &rigid}) {
      const Vec<3> along = random_direction(seed);
      const Vec<3> aside = unit_across(random_direction(seed, 2), along) * 0.4;
      world->add(along * -0.6, along, random_direction(seed, 4) * 5.0);
      world->add(along * 0.5 + aside, {}, random_direction(seed, 6) * 5.0, 0.4);
      const Vec<3> before = momentum(*world);
      const double spin = world->grains.line[1].rim_velocity[0];
      world->advance(world == &soft ? 8000 : 800);
      EXPECT_LT(magnitude(momentum(*world) - before), 1e-12);
      EXPECT_NE(world->grains.line[1].rim_velocity[0], spin);
    }
  }
}

// The friction of a rigid contact that slides has the limit of a circle, not of a pyramid, and is opposite to the slip:
// of a sphere on one plane, and of one that slides along a groove of two planes at once.
TEST(Spheres, FrictionOpposesTheSlip) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const bool groove = seed > 3;
    const Vec<3> up = random_direction(seed);
    const Vec<3> side = unit_across(random_direction(seed, 2), up);
    const Vec<3> a = groove ? Vec<3>(up * std::cos(0.6) + side * std::sin(0.6)) : up;
    const Vec<3> b = up * std::cos(0.9) - side * std::sin(0.9);
    auto settings = rigid_3d(1e-3, -up, 1e-13);
    settings.walls = {endless_plane({}, a)};
    if (groove) settings.walls.push_back(endless_plane({}, b));
    // The place that touches the planes: p.a = p.b = 1/2.
    const Vec<3> corner = (a + b) * (0.5 / (1.0 + dot(a, b)));
    Spheres world(ImpulseLaw{.friction = 0.3}, settings);
    world.add(groove ? corner : Vec<3>(a * 0.5), cross(up, side) * 2.0 + (groove ? Vec<3>{} : side * 0.7),
              random_direction(seed, 4) * 2.0);
    world.advance(50);
    const auto contacts = world.contacts();
    ASSERT_EQ(contacts.size(), groove ? 2U : 1U);
    for (const auto& contact : contacts.list) {
      const auto& sphere = world[0];
      const Vec<3> slip = tangential(sphere.velocity, contact.normal) - cross(sphere.rim_velocity, contact.normal);
      const Vec<3>& friction = contact.tangential_force;
      ASSERT_GT(magnitude(slip), 0.1);
      EXPECT_NEAR(magnitude(friction), 0.3 * contact.normal_force, 1e-12);
      EXPECT_LT(magnitude(friction * (1.0 / magnitude(friction)) + slip * (1.0 / magnitude(slip))), 1e-9);
      EXPECT_NEAR(dot(friction, contact.normal), 0.0, 1e-12);
      EXPECT_TRUE(contact.sliding);
    }
  }
}

// Friction stays in the tangent plane of a contact that moves: a sphere that rolls over a fixed one presses on it with
// the normal force alone. The impulse of a step is the start of the next.
TEST(Spheres, FrictionTurnsWithItsContact) {
  auto settings = rigid_3d(1e-3, {{0.0, 0.0, -1.0}});
  Spheres world(ImpulseLaw{.friction = 0.8, .rolling_friction = 0.05, .twisting_friction = 0.05}, settings);
  world.add({}, {}, {}, 0.5, true);
  const Vec<3> place{{0.1, 0.05, std::sqrt(1.0 - 0.0125)}};
  world.add(place, tangential(Vec<3>{{0.2, -0.1, 0.0}}, place), place * 4.0);
  int steps = 0;
  for (; steps < 2500 && world.contacts().size() + (steps < 5 ? 1 : 0) > 0; ++steps) {
    world.advance(1);
    for (const auto& contact : world.contacts().list) {
      EXPECT_NEAR(dot(contact.tangential_force, contact.normal), 0.0, 2e-3 * magnitude(contact.tangential_force));
      EXPECT_LE(magnitude(contact.tangential_force), 0.8 * contact.normal_force * (1.0 + 1e-9));
      const double twist = std::fabs(dot(contact.rolling, contact.normal));
      EXPECT_LE(twist, 0.05 * contact.normal_force * (1.0 + 1e-2));
    }
  }
  EXPECT_GT(steps, 300);
  EXPECT_LT(world[1].position[2], 0.9);
}

// Three fixed spheres that touch carry a fourth, each with W / (3 cos) of its weight, cos = sqrt(2/3) rigid; a soft one
// has sunk a little, and cos is that of its height.
TEST(Spheres, ThreeSpheresCarryAFourth) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto turn = testing::random_rotation(seed);
    const Vec<3> down = turn(Vec<3>{{0.0, 0.0, -1.0}});
    Spheres soft({Hooke{1e3, 0.5}, None{}, {}, {}}, soft_3d(1e-3, down));
    Spheres rigid(ImpulseLaw{}, rigid_3d(1e-2, down));
    for (auto* world : {&soft, &rigid}) {
      for (int k = 0; k < 3; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 3.0;
        world->add(turn(Vec<3>{{std::cos(angle) / std::sqrt(3.0), std::sin(angle) / std::sqrt(3.0), 0.0}}), {}, {}, 0.5,
                   true);
      }
      world->add(turn(Vec<3>{{0.0, 0.0, std::sqrt(2.0 / 3.0)}}));
      world->advance(world == &soft ? 60000 : 100);
      const auto contacts = world->contacts();
      ASSERT_EQ(contacts.size(), 3U);
      for (const auto& contact : contacts.list) {
        const double cosine = -std::fabs(dot(contact.normal, down));
        EXPECT_NEAR(contact.normal_force, -1.0 / (3.0 * cosine), 1e-9);
        EXPECT_NEAR(-cosine, std::sqrt(2.0 / 3.0), world == &soft ? 1e-3 : 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace repose
