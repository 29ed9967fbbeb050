// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"
#include "repose/laws/any_law.hpp"
#include "repose/methods/soft/pair_force.hpp"
#include "repose/neighbours/pair_list.hpp"
#include "support/spheres.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

// The resistance of spheres to twisting, the law by itself; tests/unit/spheres_test.cpp has the motions.

namespace repose {
namespace {

using testing::random_direction;
using testing::random_rotation;

Touch<double> touch_of_two() { return make_touch(0.99, 1.0 / 0.99, 1.0, 1.0, 0.0, 1.0); }
const NormalForce<double> pressed{10.0, 10.0};

// Below the cap spring and dashpot (c = 2 0.3 sqrt(2/5 k_w m) = 0.3 sqrt(320)) add up; at the cap the spring keeps what
// the dashpot leaves of it.
TEST(Twisting, SpringAndDashpotWithinTheCap) {
  const TwistingSpring law{{0.1, 200.0, 0.3}};
  const double dashpot = 0.6 * std::sqrt(80.0);
  double twist = 2e-4;
  EXPECT_NEAR(twisting_force(law, touch_of_two(), pressed, 0.005, 0.0, twist), -0.04 - 0.005 * dashpot, 1e-15);
  EXPECT_EQ(twist, 2e-4);
  EXPECT_NEAR(energy_of_twist(law, touch_of_two(), pressed, twist), 0.5 * 200.0 * 4e-8, 1e-20);
  EXPECT_NEAR(twisting_force(law, touch_of_two(), pressed, 0.0, 1e-3, twist), -0.04, 1e-15);
  EXPECT_NEAR(twisting_force(law, touch_of_two(), pressed, 10.0, 1e-3, twist), -1.0, 1e-15);
  EXPECT_NEAR(twist * 200.0, 1.0 - 10.0 * dashpot, 1e-12);
  EXPECT_NEAR(twisted(law, touch_of_two(), 0.5, 0.01, 1e-3), 6e-3, 1e-18);
}

TEST(Twisting, ViscousAndConstantTorques) {
  double nothing = 0.0;
  const TwistingViscous viscous{{0.1, 3.0}};
  EXPECT_NEAR(twisting_force(viscous, touch_of_two(), pressed, 0.05, 1e-3, nothing), -3.0 * 0.5 * 0.05, 1e-15);
  EXPECT_NEAR(twisting_force(viscous, touch_of_two(), pressed, -7.0, 1e-3, nothing), 1.0, 1e-15);
  const TwistingConstant constant{{0.1, 0.02}};
  EXPECT_NEAR(twisting_force(constant, touch_of_two(), pressed, 0.01, 1e-3, nothing), -0.5, 1e-15);
  EXPECT_NEAR(twisting_force(constant, touch_of_two(), pressed, 3.0, 1e-3, nothing), -1.0, 1e-15);
  EXPECT_EQ(twisting_force(NoTwisting{}, touch_of_two(), pressed, 3.0, 1e-3, nothing), 0.0);
  EXPECT_EQ(twisted(viscous, touch_of_two(), 0.5, 0.01, 0.0), 0.0);
  EXPECT_EQ(nothing, 0.0);
}

const AnyPairLaw springs =
    any_pair_law({Hooke{1e3, 0.0}, None{}, RollingSpring{10.0, 40.0, 0.0}, {}, TwistingSpring{{10.0, 50.0, 0.0}}});

/// The torques on two spheres at places along this normal, with these spins.
soft::Push<3, true> push_of(const Vec<3>& normal, const Vec<3>& first_spin, const Vec<3>& second_spin, Vec<3>& roll,
                            double& twist, double dt = 1e-3) {
  Grain<3> a;
  Grain<3> b;
  a.position = normal * 0.99;
  a.rim_velocity = first_spin * 0.5;
  b.rim_velocity = second_spin * 0.5;
  a.radius = b.radius = 0.5;
  a.mass = b.mass = a.inverse_mass = b.inverse_mass = 1.0;
  soft::Push<3, true> push;
  Vec<3> slip{};
  std::uint8_t bonded = 0;
  EXPECT_TRUE(soft::pair_force<false>(springs, a, b, Box<3>{}, dt, slip, roll, twist, bonded, push));
  return push;
}

// The torque over the radius is -k_w times the displacement, along the normal, and opposite on the second sphere.
// Rolling has the rest of the relative spin.
TEST(Twisting, TakesThePartOfTheSpinAboutTheNormal) {
  for (std::uint64_t seed = 1; seed < 5; ++seed) {
    const Vec<3> n = random_direction(seed);
    const Vec<3> first = random_direction(seed, 2) * 3.0;
    const Vec<3> second = random_direction(seed, 4) * 2.0;
    Vec<3> roll{};
    double twist = 0.0;
    const auto push = push_of(n, first, second, roll, twist);
    const Vec<3> turned = (first - second) * (0.5 * 1e-3);
    EXPECT_NEAR(twist, dot(turned, n), 1e-16);
    EXPECT_LT(magnitude(roll - tangential(turned, n)), 1e-16);
    EXPECT_LT(magnitude(push.rim_torque + tangential(turned, n) * 40.0 + n * (50.0 * dot(turned, n))), 1e-14);
    EXPECT_LT(magnitude(push.rim_torque + push.back_rim_torque), 1e-14);
  }
}

// A pair that turns as one body keeps its torque about the normal, to the bit, and none of its rolling displacement
// becomes twisting. With both stored in one vector they would mix.
TEST(Twisting, IsKeptWhileThePairTurns) {
  Vec<3> roll{{0.002, -0.001, 0.0}};
  double twist = 0.003;
  Vec<3> n{{0.0, 0.0, 1.0}};
  const double rolled = magnitude(roll);
  for (std::uint64_t step = 0; step < 200; ++step) {
    const Vec<3> spin = random_direction(step) * 20.0;
    n += cross(spin, n) * 1e-3;
    n *= 1.0 / magnitude(n);
    const auto push = push_of(n, spin, spin, roll, twist);
    EXPECT_EQ(twist, 0.003);
    EXPECT_NEAR(dot(push.rim_torque, n), -50.0 * 0.003, 1e-14);
  }
  EXPECT_LT(n[2], 0.999);  // it has turned
  EXPECT_NEAR(magnitude(roll), rolled, 1e-15);
}

// Displacements stay with their pair through new lists, in either order of its two spheres.
TEST(Twisting, StaysWithItsPair) {
  Grains<3> grains;
  for (int k = 0; k < 150; ++k) {
    Grain<3> grain;
    for (int axis = 0; axis < 3; ++axis) {
      const auto draw = static_cast<std::uint32_t>(axis);
      const auto index = static_cast<std::uint64_t>(k);
      grain.position[axis] = 5.0 * uniform(5, Purpose::release_position, index, draw);
      grain.velocity[axis] = 4.0 * uniform(5, Purpose::release_position, index, 10 + draw) - 2.0;
    }
    grain.radius = 0.4;
    grain.mass = grain.inverse_mass = 1.0;
    grains.add(grain, k);
  }
  PairList<3> pairs({.cutoff = 1.2, .skin = 0.3, .twisting = true});
  Team team(2);
  pairs.build(grains, Box<3>{}, team);
  const auto by_pair = [&] {
    std::map<std::pair<std::int64_t, std::int64_t>, double> all;
    for (std::uint32_t i = 0; i < pairs.rows(); ++i) {
      for (auto k = pairs.row_start[i]; k < pairs.row_start[i + 1]; ++k) {
        all[std::minmax(grains.id[i], grains.id[pairs.partner[k]])] = pairs.twist[k];
      }
    }
    return all;
  };
  for (std::size_t k = 0; k < pairs.pairs(); ++k) pairs.twist[k] = static_cast<double>(k + 1);
  auto known = by_pair();
  std::size_t kept = 0;
  for (int round = 0; round < 5; ++round) {
    for (auto& grain : grains.line) grain.position += grain.velocity * 0.03;
    pairs.build(grains, Box<3>{}, team);
    const auto now = by_pair();
    for (const auto& [pair, twist] : now) {
      const auto before = known.find(pair);
      EXPECT_EQ(twist, before == known.end() ? 0.0 : before->second);
      kept += twist != 0.0 ? 1 : 0;
    }
    known = now;
  }
  EXPECT_GT(kept, 300U);
}

// A bond beyond the reach of the normal law has the force of its attraction alone. Hooke's law with an attractive
// dashpot would continue as a spring there.
TEST(Cohesion, ABondBeyondReachHasNoNormalForce) {
  const Jkr adhesion{0.5, 1e4};
  const double stretched = 0.5 * at_radius(adhesion, 0.25).overlap_at_pull_off();
  ASSERT_LT(stretched, 0.0);
  const double distance = 1.0 - stretched;
  const auto far = make_touch(distance, 1.0 / distance, 1.0, 1.0, 0.3, 1.0);
  for (const auto& normal : {NormalLaw{Hooke{1e4, 0.5, true}}, NormalLaw{ElasticHertz{1e4, 0.5}}}) {
    ContactHistory<double> history{.slip = 0.1, .bonded = true};
    const auto law = any_pair_law({normal, Linear{}, {}, adhesion});
    const auto force = contact_force(law, far, 0.2, 0.0, 1e-3, history);
    bool bonded = true;
    EXPECT_EQ(force.normal.total, 0.0);
    EXPECT_EQ(force.normal.elastic, 0.0);
    EXPECT_EQ(force.tangential, 0.0);
    EXPECT_EQ(force.attraction, attraction(adhesion, far, bonded));
    EXPECT_GT(force.attraction, 0.0);
    EXPECT_TRUE(history.bonded);
    EXPECT_EQ(history.slip, 0.0);
  }
}

/// Calls the laws of a contact of Hertz and Mindlin at this overlap.
struct Shear {
  ContactLaws laws;
  Vec<3> along{};
  ContactHistory<Vec<3>> history{};

  /// The force along `along` after the contact has moved by this much at these overlaps.
  double move(double displacement, double before, double overlap) {
    const double dt = 1e-3;
    const double distance = 1.0 - overlap;
    const auto touch = make_touch(distance, 1.0 / distance, 1.0, 1.0, (overlap - before) / dt, 1.0);
    const auto force =
        contact_force(any_pair_law(laws), touch, Vec<3>(along * (displacement / dt)), Vec<3>{}, dt, history);
    EXPECT_LT(magnitude(tangential(force.tangential, along)), 1e-12);
    return dot(force.tangential, along);
  }
};

// The loop of force and displacement. At a constant overlap the law is a spring of k_t = ratio 3/2 k sqrt(overlap) that
// slides at mu N, so that the loop has parallel sides: from the load to +d the force falls back by k_t times the way,
// to -mu N. Pressed together the force stays; released it falls as k_t does, while the displacement stays. 2D and 3D
// have one law, in any direction of the tangent plane.
TEST(Mindlin, HasTheLoopOfItsLaw) {
  for (const bool elastic : {false, true}) {
    const double k = elastic ? 4.0 / 3.0 * 3e4 * std::sqrt(0.25) : 2e4;
    const NormalLaw normal = elastic ? NormalLaw{ElasticHertz{3e4, 0.0}} : NormalLaw{Hertz{2e4, 0.0}};
    Shear shear{{normal, Mindlin{0.4, 0.8, 0.0}, {}, {}}, random_direction(11)};
    const double overlap = 0.01;
    const double stiffness = 0.8 * 1.5 * k * std::sqrt(overlap);
    const double limit = 0.4 * k * std::pow(overlap, 1.5);
    double displacement = 0.0;
    double expected = 0.0;
    const double step = 0.02 * limit / stiffness;
    double slid = 0.0;
    for (const auto& [sign, steps] : {std::pair{1.0, 75}, std::pair{-1.0, 130}, std::pair{1.0, 130}}) {
      for (int n = 0; n < steps; ++n) {
        displacement += sign * step;
        const double free = expected - stiffness * sign * step;
        expected = std::clamp(free, -limit, limit);
        slid += free != expected ? 1 : 0;
        EXPECT_NEAR(shear.move(sign * step, overlap, overlap), expected, 1e-9 * limit);
      }
    }
    EXPECT_GT(slid, 50);
    EXPECT_NEAR(expected, -limit, 1e-12);
    shear.move(-80 * step, overlap, overlap);
    const double loaded = shear.move(0.0, overlap, overlap);
    EXPECT_NEAR(loaded, 0.6 * limit, 1e-9 * limit);
    EXPECT_NEAR(shear.move(0.0, overlap, 0.02), loaded, 1e-9 * limit);
    EXPECT_NEAR(shear.move(0.0, 0.02, 0.03), loaded, 1e-9 * limit);
    EXPECT_NEAR(shear.move(0.0, 0.03, 0.015), loaded * std::sqrt(0.5), 1e-9 * limit);
  }
}

}  // namespace
}  // namespace repose
