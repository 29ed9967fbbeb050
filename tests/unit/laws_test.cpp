// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/contact_force.hpp"
#include "repose/laws/registry.hpp"
#include "repose/laws/time_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace repose {
namespace {

Touch<double> touch_at(double distance, double cutoff, double closing_speed = 0.0, double mass = 1.0,
                       double diameter = 1.0) {
  return make_touch(distance, 1.0 / distance, diameter, cutoff * diameter, closing_speed, mass);
}

// (3) with the sign of the exponent corrected: m g at r = s, and 1.2^-37 = 1.2e-3 m g at the cutoff.
TEST(ContinuousLaw, ClosedForm) {
  const auto law = Continuous::make(36, 1.2, 0.5, 1.0);
  EXPECT_DOUBLE_EQ(normal_force(law, touch_at(1.0, 1.2)).elastic, 1.0);
  EXPECT_NEAR(normal_force(law, touch_at(1.2, 1.2)).elastic, std::pow(1.2, -37), 1e-15);
  EXPECT_NEAR(normal_force(law, touch_at(0.9, 1.2, 0.0, 0.7, 1.1)).elastic, 0.7 * std::pow(1.1 / 0.9, 37), 1e-9);
  const auto uneven = Continuous::make(36.5, 1.2, 0.5, 2.0);
  EXPECT_NEAR(normal_force(uneven, touch_at(0.95, 1.2)).elastic, 2.0 * std::pow(1.0 / 0.95, 37.5), 1e-9);
}

// The dashpot is 2 zeta sqrt(m k) with k = -dF/dr = (n+1) F / r. The force is never attractive unless requested.
TEST(ContinuousLaw, Damping) {
  auto law = Continuous::make(36, 1.2, 0.5, 1.0);
  const double dashpot = std::sqrt(37.0);
  EXPECT_NEAR(normal_force(law, touch_at(1.0, 1.2, 0.1)).total, 1.0 + 0.1 * dashpot, 1e-12);
  EXPECT_EQ(normal_force(law, touch_at(1.0, 1.2, -5.0)).total, 0.0);
  law.attraction = true;
  EXPECT_NEAR(normal_force(law, touch_at(1.0, 1.2, -5.0)).total, 1.0 - 5.0 * dashpot, 1e-12);
}

TEST(HookeLaw, ClosedForm) {
  const Hooke law{500.0, 0.5};
  EXPECT_NEAR(normal_force(law, touch_at(0.98, 1.0)).elastic, 10.0, 1e-10);
  EXPECT_NEAR(normal_force(law, touch_at(0.98, 1.0, 0.2)).total, 10.0 + 0.2 * std::sqrt(500.0), 1e-10);
  EXPECT_EQ(normal_force(law, touch_at(0.98, 1.0, -20.0)).total, 0.0);
}

// The force is minus the derivative of the energy, and the stiffness minus that of the force (central differences,
// h = 1e-5).
TEST(NormalLaws, EnergyForceAndStiffnessAgree) {
  const auto check = [](const auto& law) {
    const double mass = 0.8;
    const double diameter = 0.9;
    const double h = 1e-5;
    for (const double r : {0.7, 0.8, 0.85}) {
      const auto energy = [&](double at) { return elastic_energy(law, mass, diameter, at); };
      const auto force = [&](double at) {
        return normal_force(law, touch_at(at, reach(law), 0.0, mass, diameter)).elastic;
      };
      EXPECT_NEAR(-(energy(r + h) - energy(r - h)) / (2 * h) / force(r), 1.0, 1e-6);
      EXPECT_NEAR(-(force(r + h) - force(r - h)) / (2 * h) / stiffness_at(law, mass, diameter, energy(r)), 1.0, 1e-6);
    }
  };
  check(Continuous::make(36, 1.2, 0.5, 1.0));
  check(Hooke{500.0, 0.5});
  check(Hertz{700.0, 0.5});
}

// (5): half the limit at |delta|/d_max = 1 - 0.5^(2/3), opposite to the displacement; (8): C_T = sqrt(m k_T).
TEST(CumulativeLaw, ClosedForm) {
  const Cumulative law{0.4, 1.214};
  const auto touch = touch_at(1.0, 1.2);
  const NormalForce<double> normal{1.0, 1.0};
  const double furthest = 1.214 * 0.4 * 0.2;
  double delta = furthest * (1.0 - std::pow(0.5, 2.0 / 3.0));
  const double kept = delta;
  EXPECT_NEAR(tangential_force(law, touch, normal, 0.0, 0.0, delta), -0.2, 1e-12);
  EXPECT_EQ(delta, kept);
  delta = 0.0;
  const double stiffness = 1.5 * 0.4 / furthest;
  EXPECT_NEAR(tangential_force(law, touch, normal, 0.01, 0.0, delta), -0.01 * std::sqrt(stiffness), 1e-12);
}

TEST(CumulativeLaw, WithoutFrictionThereIsNoForce) {
  double delta = 0.1;
  EXPECT_EQ(tangential_force(Cumulative{0.0, 1.214}, touch_at(1.0, 1.2), {1.0, 1.0}, 1.0, 0.001, delta), 0.0);
  EXPECT_EQ(delta, 0.0);
}

// Below the cap the law is a spring. At the cap the slip displacement keeps the value that gives the capped force, so
// that a reversed slip reduces the force immediately.
TEST(LinearLaw, SpringThenSlip) {
  const Linear law{0.5, 100.0, 0.0};
  const NormalForce<double> normal{1.0, 1.0};
  const auto touch = touch_at(0.99, 1.0);
  double delta = 0.0;
  EXPECT_NEAR(tangential_force(law, touch, normal, 1.0, 0.002, delta), -0.2, 1e-12);
  for (int k = 0; k < 100; ++k) tangential_force(law, touch, normal, 1.0, 0.002, delta);
  EXPECT_NEAR(delta, 0.005, 1e-15);
  EXPECT_NEAR(tangential_force(law, touch, normal, -1.0, 0.001, delta), -0.4, 1e-12);
}

// Friction falls linearly with the speed of slip from 0.5 to 0.2 at 0.1, and stays there. While the contact slides, the
// displacement keeps the value that gives the capped force; a contact that stops holds again up to the static limit.
TEST(WeakeningLaw, FrictionFallsWithTheSlip) {
  const Weakening law{0.5, 100.0, 0.0, 0.2, 0.1};
  const NormalForce<double> normal{2.0, 2.0};
  const auto touch = touch_at(0.99, 1.0);
  for (const auto& [speed, friction] :
       {std::pair{0.0, 0.5}, std::pair{0.05, 0.35}, std::pair{0.1, 0.2}, std::pair{3.0, 0.2}}) {
    EXPECT_NEAR(law.friction_at(speed), friction, 1e-15);
    double delta = 1.0;
    EXPECT_NEAR(tangential_force(law, touch, normal, speed, 0.001, delta), -2.0 * friction, 1e-12);
    EXPECT_NEAR(delta, 0.02 * friction, 1e-15);
    EXPECT_NEAR(coulomb_limit(law, normal, speed), 2.0 * friction, 1e-15);
  }
  EXPECT_NEAR(coulomb_limit(law, normal), 1.0, 1e-15);
}

// Frequencies: n = 36 and a fall of 100 give w dt = 0.458 at dt = 0.001, n = 144 gives 1.54; Hooke has sqrt(k).
TEST(TimeStep, StiffestContactOfAFall) {
  const auto frequency = [](const NormalLaw& normal, const TangentialLaw& tangential, const GrainSize& mover = {}) {
    return stiffest_contact({normal, tangential, {}, {}}, mover, {}, 1.0, 100.0).frequency;
  };
  EXPECT_NEAR(frequency(Continuous::make(36, 1.2, 0.5, 1.0), Cumulative{}), 458.1, 0.5);
  EXPECT_NEAR(frequency(Continuous::make(144, 1.047, 0.5, 1.0), Cumulative{}), 1544, 5);
  EXPECT_NEAR(frequency(Hooke{500.0, 0.5}, Cumulative{}), std::sqrt(500.0), 1e-9);
  // The effective mass at the rim of a disc is a third of its mass.
  EXPECT_NEAR(frequency(Hooke{500.0, 0.5}, Linear{0.5, 500.0, 0.0}), std::sqrt(1500.0), 1e-9);
  EXPECT_NEAR(frequency(Hooke{500.0, 0.5}, Cumulative{}, {0.5, 0.25}), std::sqrt(2000.0), 1e-9);
  // k = 1.5 K sqrt(overlap), 0.4 K overlap^2.5 = 100.
  EXPECT_NEAR(frequency(Hertz{1e4, 0.5}, Mindlin{0.5, 0.2}), std::sqrt(1.5e4 * std::pow(100.0 / 4e3, 0.2)), 1e-9);
}

// Hooke k = 500, C = sqrt(k); surface k_t = 100, c_t = 10. The mode in which all grains spin in the same sense becomes
// unstable first, at K dt^2 + 2 C dt = 4 with K = 24 * 100, C = 24 * 10. Without dashpots the limit is 2 / sqrt(K) of
// the stiffer mode.
TEST(TimeStep, LargestOfABed) {
  const auto largest = [](double damping, double surface_stiffness, double surface_damping) {
    return largest_step_of_bed({Hooke{500.0, damping}, Linear{0.5, surface_stiffness, surface_damping}, {}, {}}, {}, {},
                               10.0);
  };
  EXPECT_NEAR(largest(0.5, 100.0, 0.5), 4.0 / (240.0 + std::sqrt(240.0 * 240.0 + 4.0 * 2400.0)), 1e-9);
  EXPECT_NEAR(largest(0.0, 100.0, 0.0), 2.0 / std::sqrt(6.0 * 600.0), 1e-9);
  EXPECT_NEAR(largest(0.0, 400.0, 0.0), 2.0 / std::sqrt(24.0 * 400.0), 1e-9);
  EXPECT_NEAR(largest(2.0, 1e-9, 0.0), 4.0 / (24.0 * std::sqrt(500.0) + std::sqrt(576.0 * 500.0 + 4.0 * 3000.0)), 1e-9);
}

// 20 grains with k = 500 and C = sqrt(k), a step of 0.007 that counts as 0.01: K dt^2 + 2 C dt = 4 M. Along its own
// face a piston feels the surface, k_t = 100 and c_t = 10, and its own spring and drag add to both.
TEST(TimeStep, LeastPistonMass) {
  const ContactLaws laws{Hooke{500.0, 0.5}, Linear{0.5, 100.0, 0.5}, {}, {}};
  EXPECT_NEAR(least_piston_mass(laws, {}, {.count = 20.0, .mass = 5.0}, 0.007),
              0.25 * (20.0 * 500.0 * 1e-4 + 2.0 * 20.0 * std::sqrt(500.0) * 0.01), 1e-9);
  EXPECT_NEAR(least_piston_mass(laws, {}, {.count = 20.0, .force = 10.0, .alignment = 0.0, .mass = 5.0}, 0.007),
              0.25 * (20.0 * 100.0 * 1e-4 + 2.0 * 20.0 * 10.0 * 0.01), 1e-6);
  EXPECT_NEAR(least_piston_mass(laws, {}, {.count = 0.0, .mass = 5.0, .stiffness = 3e4, .drag = 7.0}, 0.007),
              0.25 * (3e4 * 1e-4 + 2.0 * 7.0 * 0.01), 1e-12);
}

// The viscous law is d m_red v up to the cap.
TEST(ViscousLaw, ClosedForm) {
  double nothing = 0.0;
  const NormalForce<double> normal{1.0, 1.0};
  EXPECT_NEAR(tangential_force(Viscous{0.5, 3.0}, touch_at(0.99, 1.0, 0.0, 0.8), normal, 0.2, 1e-3, nothing), -0.24,
              1e-12);
  EXPECT_EQ(tangential_force(Viscous{0.5, 3.0}, touch_at(0.99, 1.0), normal, 7.0, 1e-3, nothing), -0.5);
  EXPECT_EQ(nothing, 0.0);
}

// The attraction is constant while grains overlap; the energy is minus its work.
TEST(Cohesion, ConstantWhereGrainsTouch) {
  const ConstantCohesion law{0.7};
  EXPECT_EQ(attraction(law, touch_at(1.01, 1.2)), 0.0);
  EXPECT_EQ(attraction(law, touch_at(0.99, 1.2)), 0.7);
  EXPECT_NEAR(cohesion_energy(law, touch_at(0.98, 1.2)) - cohesion_energy(law, touch_at(0.99, 1.2)), -0.007, 1e-15);
}

}  // namespace
}  // namespace repose
