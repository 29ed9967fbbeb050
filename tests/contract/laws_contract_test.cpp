// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"
#include "repose/methods/soft/pair_force.hpp"
#include "support/every_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Contracts that every normal law must meet with every tangential, rolling and cohesion law.

namespace repose {
namespace {

using testing::for_all_laws;

double number(std::uint64_t index, std::uint32_t draw) {
  return 2.0 * uniform(3, Purpose::release_position, index, draw) - 1.0;
}

/// Two grains near each other, with different properties.
template <int D>
std::pair<Grain<D>, Grain<D>> random_pair(std::uint64_t index) {
  Grain<D> a;
  Grain<D> b;
  for (int k = 0; k < D; ++k) {
    const auto draw = static_cast<std::uint32_t>(k);
    b.position[k] = 0.6 * number(index, draw);
    a.velocity[k] = number(index, 10 + draw);
    b.velocity[k] = number(index, 20 + draw);
    if constexpr (D == 3) {
      a.rim_velocity[k] = number(index, 30 + draw);
      b.rim_velocity[k] = number(index, 40 + draw);
    }
  }
  if constexpr (D == 2) {
    a.rim_velocity = number(index, 30);
    b.rim_velocity = number(index, 40);
  }
  a.radius = 0.4 + 0.1 * number(index, 50);
  b.radius = 0.4 + 0.1 * number(index, 51);
  a.mass = 4.0 * a.radius * a.radius;
  b.mass = 4.0 * b.radius * b.radius;
  a.inverse_mass = 1.0 / a.mass;
  b.inverse_mass = 1.0 / b.mass;
  return {a, b};
}

template <int D>
double distance_of(const Grain<D>& a, const Grain<D>& b) {
  return magnitude(a.position - b.position);
}

/// The number of the first `count` random pairs in 2D that are in reach of a law.
int pairs_in_reach(const AnyPairLaw& law, std::uint64_t count) {
  int number_in_reach = 0;
  for (std::uint64_t index = 0; index < count; ++index) {
    const auto [a, b] = random_pair<2>(index);
    number_in_reach += distance_of(a, b) < reach(law.normal) * (a.radius + b.radius) ? 1 : 0;
  }
  EXPECT_GT(number_in_reach, 50);
  return number_in_reach;
}

template <int D>
bool push_of(const AnyPairLaw& law, const Grain<D>& a, const Grain<D>& b, ContactHistory<Tangent<D>>& history,
             soft::Push<D, true>& push) {
  return soft::pair_force<false>(law, a, b, Box<D>{}, 1e-3, history.slip, history.roll, push);
}

template <int D>
void check_apart_and_symmetry() {
  for_all_laws([](const auto& law) {
    int touching = 0;
    for (std::uint64_t index = 0; index < 200; ++index) {
      const auto [a, b] = random_pair<D>(index);
      ContactHistory<Tangent<D>> history;
      ContactHistory<Tangent<D>> history_back;
      soft::Push<D, true> push;
      soft::Push<D, true> back;
      const bool touches = push_of(law, a, b, history, push);
      EXPECT_EQ(touches, distance_of(a, b) < reach(law.normal) * (a.radius + b.radius));
      EXPECT_EQ(push_of(law, b, a, history_back, back), touches);
      if (!touches) {
        EXPECT_EQ(magnitude(history.slip), 0.0);
        EXPECT_EQ(magnitude(history.roll), 0.0);
        continue;
      }
      ++touching;
      const double size = 1e-12 * (1.0 + magnitude(push.force));
      EXPECT_LT(magnitude(push.force + back.force), size);
      EXPECT_LT(magnitude(push.rim_torque - back.back_rim_torque), size);
      EXPECT_LT(magnitude(push.back_rim_torque - back.rim_torque), size);
      EXPECT_LT(magnitude(push.damping + back.damping), size);
      EXPECT_LT(magnitude(push.friction + back.friction), size);
      EXPECT_LT(magnitude(history.slip - swapped(history_back.slip)), 1e-15);
      EXPECT_LT(magnitude(history.roll + history_back.roll), 1e-15);
    }
    EXPECT_GT(touching, 50);
  });
}

TEST(LawContract, ZeroApartAndSymmetric2D) { check_apart_and_symmetry<2>(); }
TEST(LawContract, ZeroApartAndSymmetric3D) { check_apart_and_symmetry<3>(); }

TEST(LawContract, RotationInvariance) {
  for_all_laws([](const auto& law) {
    int touching = 0;
    for (std::uint64_t index = 0; index < 100; ++index) {
      auto [a, b] = random_pair<2>(index);
      ContactHistory<double> history{0.01 * number(index, 60), 0.01 * number(index, 62)};
      ContactHistory<double> history_turned = history;
      soft::Push<2, true> push;
      soft::Push<2, true> turned_push;
      if (!push_of(law, a, b, history, push)) continue;
      ++touching;
      const double angle = 3.0 * number(index, 61);
      const auto turn = [&](const Vec<2>& v) {
        return Vec<2>{
            {std::cos(angle) * v[0] - std::sin(angle) * v[1], std::sin(angle) * v[0] + std::cos(angle) * v[1]}};
      };
      for (auto* grain : {&a, &b}) {
        grain->position = turn(grain->position);
        grain->velocity = turn(grain->velocity);
      }
      EXPECT_TRUE(push_of(law, a, b, history_turned, turned_push));
      const double size = 1e-10 * (1.0 + magnitude(push.force));
      EXPECT_LT(magnitude(turn(push.force) - turned_push.force), size);
      EXPECT_NEAR(push.rim_torque, turned_push.rim_torque, size);
    }
    EXPECT_EQ(touching, pairs_in_reach(law, 100));
  });
}

// The rolling law of the list has mu_r = 0.1. Friction and rolling resistance reach their limits in some of the cases.
TEST(LawContract, CoulombLimit) {
  for_all_laws([](const auto& law) {
    int sliding = 0;
    int rolling = 0;
    for (std::uint64_t index = 0; index < 500; ++index) {
      const double distance = reach(law.normal) * (0.9 + 0.0999 * number(index, 0));
      const auto touch = make_touch(distance, 1.0 / distance, 1.0, reach(law.normal), 3.0 * number(index, 1), 1.0);
      ContactHistory<double> history{0.3 * number(index, 2), 0.3 * number(index, 4)};
      const double slip_speed = 50.0 * number(index, 3);
      const auto force = contact_force(law, touch, slip_speed, 5.0 * number(index, 5), 1e-3, history);
      const double limit = coulomb_limit(law.tangential, force.normal, slip_speed);
      EXPECT_LE(std::fabs(force.tangential), limit * (1.0 + 1e-12));
      EXPECT_LE(std::fabs(force.rolling), 0.1 * force.normal.total * (1.0 + 1e-12));
      sliding += limit > 0.0 && std::fabs(force.tangential) > limit * (1.0 - 1e-9) ? 1 : 0;
      rolling += std::fabs(force.rolling) > 0.1 * force.normal.total * (1.0 - 1e-9) && force.rolling != 0.0 ? 1 : 0;
      EXPECT_GE(force.normal.total, 0.0);
      EXPECT_GE(force.attraction, 0.0);
    }
    if (!std::holds_alternative<None>(law.tangential.law)) {
      EXPECT_GT(sliding, 20);
    }
    if (std::holds_alternative<RollingSpring>(law.rolling.law)) {
      EXPECT_GT(rolling, 20);
    }
  });
}

bool is_hertz(const NormalLaw& law) {
  return std::holds_alternative<Hertz>(law) || std::holds_alternative<ElasticHertz>(law);
}

// A closed path of the contact point gains no energy. The contact slips back and forth while the grains are pressed
// together and released, at any phase between the two, without dashpots in the normal direction. The work of the
// tangential force over the tenth cycle, at whose ends the stored energy is equal, is not positive. The cumulative law
// is not conservative (docs/physics/soft.md): it may return up to 2 % of the friction work.
TEST(LawContract, NoEnergyFromACycle) {
  for (const auto& normal : testing::every_normal_law()) {
    for (const auto& tangential : testing::every_tangential_law()) {
      if (std::holds_alternative<Mindlin>(tangential) && !is_hertz(normal)) continue;
      for (const double phase : {0.0, 0.7, 1.6, 3.1, 4.5}) {
        const auto law = any_pair_law({normal, tangential, {}, {}});
        ContactHistory<double> history;
        const double dt = 1e-4;
        double work = 0.0;
        double most = 0.0;
        for (int step = 0; step < 100000; ++step) {
          const double turn = 2.0 * std::numbers::pi * step / 10000.0;
          const double distance = 0.985 + 0.01 * std::sin(turn + phase);
          const double slip_speed = 0.004 * 2.0 * std::numbers::pi * std::cos(turn);
          const double closing = -0.01 * 2.0 * std::numbers::pi * std::cos(turn + phase);
          const auto touch = make_touch(distance, 1.0 / distance, 1.0, reach(law.normal), closing, 1.0);
          const auto force = contact_force(law, touch, slip_speed, 0.0, dt, history);
          if (step < 90000) continue;
          work += force.tangential * slip_speed * dt;
          most += std::fabs(force.tangential * slip_speed * dt);
        }
        EXPECT_LE(work, (std::holds_alternative<Cumulative>(tangential) ? 0.02 : 1e-3) * most) << phase;
      }
    }
  }
}

/// The law that damps the rolling of spheres as this one damps that of discs: damping is a fraction of the critical
/// one, and spheres have less inertia, 2/5 m R^2 instead of 1/2.
AnyPairLaw of_spheres(AnyPairLaw law) {
  if (auto* spring = std::get_if<RollingSpring>(&law.rolling.law)) spring->damping *= std::sqrt(0.5 / 0.4);
  return law;
}

// A contact in the plane z = 0 of 3D has the forces of 2D (tangent t = z x n).
TEST(LawContract, PlanarContactIn3DIsThatOf2D) {
  for_all_laws([](const auto& law) {
    int touching = 0;
    for (std::uint64_t index = 0; index < 100; ++index) {
      const auto [a, b] = random_pair<2>(index);
      const auto lifted = [](const Grain<2>& grain) {
        Grain<3> up;
        for (int k = 0; k < 2; ++k) {
          up.position[k] = grain.position[k];
          up.velocity[k] = grain.velocity[k];
        }
        up.rim_velocity[2] = grain.rim_velocity;
        up.radius = grain.radius;
        up.mass = grain.mass;
        up.inverse_mass = grain.inverse_mass;
        return up;
      };
      ContactHistory<double> history;
      ContactHistory<Vec<3>> history_3d;
      soft::Push<2, true> push;
      soft::Push<3, true> push_3d;
      for (int step = 0; step < 5; ++step) {
        const bool touches = push_of(law, a, b, history, push);
        ASSERT_EQ(push_of(of_spheres(law), lifted(a), lifted(b), history_3d, push_3d), touches);
        if (!touches) break;
        if (step == 0) ++touching;
      }
      const double size = 1e-10 * (1.0 + magnitude(push.force));
      EXPECT_NEAR(push.force[0], push_3d.force[0], size);
      EXPECT_NEAR(push.force[1], push_3d.force[1], size);
      EXPECT_NEAR(push.rim_torque, push_3d.rim_torque[2], size);
      EXPECT_NEAR(push.back_rim_torque, push_3d.back_rim_torque[2], size);
    }
    EXPECT_EQ(touching, pairs_in_reach(law, 100));
  });
}

}  // namespace
}  // namespace repose
