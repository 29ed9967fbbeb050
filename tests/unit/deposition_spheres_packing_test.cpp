// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Packings of many spheres by the critical-angle rule.
#include "repose/core/numbers.hpp"
#include "repose/methods/deposition/spheres_columns.hpp"
#include "support/deposited_spheres.hpp"
#include "support/memory_archive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace repose {
namespace {

using namespace testing;

/// The unit vectors to a sphere from what it touched when it came to rest: earlier spheres, found among all, floor and
/// walls. Adds to `deepest` any overlap found.
std::vector<Vec<3>> supports_of(const Grains<3>& grains, std::size_t k, const SphereDepositionSettings& settings,
                                double& deepest) {
  constexpr double gap = 1e-9;  // rounding is 1e-14; two spheres come as near by chance once in 1e8
  std::vector<Vec<3>> normals;
  const auto& grain = grains.line[k];
  const auto touch = [&](const Vec<3>& normal, double distance) {
    deepest = std::max(deepest, -distance);
    if (distance < gap) normals.push_back(normal);
  };
  for (std::size_t other = 0; other < k; ++other) {
    const Vec<3> apart = separation(grain.position, grains.line[other].position, settings.box);
    const double distance = magnitude(apart);
    touch(apart * (1.0 / distance), distance - grain.radius - grains.line[other].radius);
  }
  const auto& box = settings.box;
  touch({{0.0, 0.0, 1.0}}, grain.position[2] - grain.radius - settings.floor);
  if (!box.periodic) {
    touch({{1.0, 0.0, 0.0}}, grain.position[0] - grain.radius - box.x_min);
    touch({{-1.0, 0.0, 0.0}}, box.x_max - grain.position[0] - grain.radius);
    touch({{0.0, 1.0, 0.0}}, grain.position[1] - grain.radius - box.y_min);
    touch({{0.0, -1.0, 0.0}}, box.y_max - grain.position[1] - grain.radius);
  }
  return normals;
}

/// The slope of the steepest path down that enters no support: the length of gravity plus the pushes that turn it away
/// from all, by relaxation of one push after the other.
double steepest_slope(const std::vector<Vec<3>>& normals) {
  Vec<3> path{{0.0, 0.0, -1.0}};
  std::vector<double> push(normals.size(), 0.0);
  for (int sweep = 0; sweep < 20'000; ++sweep) {
    double change = 0.0;
    for (std::size_t k = 0; k < normals.size(); ++k) {
      const double next = std::max(0.0, push[k] - dot(normals[k], path));
      change = std::max(change, std::abs(next - push[k]));
      path += normals[k] * (next - push[k]);
      push[k] = next;
    }
    if (change < 1e-12) break;
  }
  return magnitude(path);
}

/// The part of the volume between two heights that spheres fill.
double solid_fraction(const Grains<3>& grains, double low, double high, double area) {
  double volume = 0.0;
  for (const auto& grain : grains.line) {
    const double r = grain.radius;
    const double a = std::max(-r, low - grain.position[2]);
    const double b = std::min(r, high - grain.position[2]);
    if (b > a) volume += std::numbers::pi * (r * r * (b - a) - (b * b * b - a * a * a) / 3.0);
  }
  return volume / (area * (high - low));
}

// Both searches find the same touches, so their packings are the same to the bit.
TEST(SphereDepositionPacking, ColumnsEqualBruteForce) {
  for (const double spread : {0.0, 0.4, 0.85}) {
    for (const double angle : {0.0, 5.0, 30.0, 50.0, 90.0}) {
      for (const bool periodic : {true, false}) {
        const SpherePacker packer{.width = periodic ? 2.0 : 3.3,  // as narrow as a periodic box may be
                                  .count = 120,
                                  .angle_deg = angle,
                                  .spread = spread,
                                  .periodic = periodic,
                                  .seed = 7};
        const auto fast = packer.pack();
        const auto slow = packer.pack(true);
        ASSERT_EQ(fast.size(), slow.size());
        for (std::size_t k = 0; k < fast.size(); ++k) {
          ASSERT_EQ(fast.line[k].position, slow.line[k].position)
              << "sphere " << k << " spread " << spread << " angle " << angle << " periodic " << periodic;
        }
      }
    }
  }
}

// Every sphere rests by the rule, checked by code that shares nothing with the method: its steepest path down slopes by
// less than the critical angle; at 0 degrees there is none (relaxation of pushes ends within 1e-6 of the slope). No
// overlap is larger than rounding.
TEST(SphereDepositionPacking, EverySphereRestsWithoutOverlap) {
  for (const double spread : {0.0, 0.4, 0.85}) {
    for (const double angle : {0.0, 10.0, 30.0, 60.0, 90.0}) {
      for (const bool periodic : {true, false}) {
        const SpherePacker packer{
            .width = 5.0, .count = 1200, .angle_deg = angle, .spread = spread, .periodic = periodic};
        const auto grains = packer.pack();
        double deepest = 0.0;
        for (std::size_t k = 0; k < grains.size(); ++k) {
          const auto normals = supports_of(grains, k, packer.settings(), deepest);
          ASSERT_FALSE(normals.empty()) << k;
          ASSERT_LT(steepest_slope(normals), std::sin(radians(angle)) + 1e-6) << k << " " << spread << " " << angle;
        }
        EXPECT_LT(deepest, 1e-11) << spread << " " << angle << " " << periodic;
      }
    }
  }
}

// At 0 degrees each sphere on no floor or wall has exactly three supports, so each has six contacts in the mean; the
// vertical through its centre passes through their triangle, and every small motion along two of them raises it.
TEST(SphereDepositionPacking, SteepestDescentEndsOnThree) {
  const SpherePacker packer{.width = 6.0, .count = 1500, .spread = 0.3};
  const auto grains = packer.pack();
  const auto method = make_sphere_deposition(packer.settings());
  double deepest = 0.0;
  int inside = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto n = supports_of(grains, k, packer.settings(), deepest);
    if (std::any_of(n.begin(), n.end(), [](const auto& normal) { return normal[2] == 1.0; })) continue;
    ASSERT_EQ(n.size(), 3U) << k;
    ++inside;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& one = n[a];
      const auto& two = n[(a + 1) % 3];
      const auto& third = n[(a + 2) % 3];
      Vec<3> along = cross(one, two);
      along *= 1.0 / magnitude(along);
      if (dot(along, third) < 0.0) along = -along;
      EXPECT_GT(along[2], -1e-9) << k;  // the path that leaves the third leads up
      // The contact with the third and the centre lie on the same side of the upright plane through the other two.
      const Vec<3> line = one - two;
      const auto side = [&](const Vec<3>& point) { return line[0] * point[1] - line[1] * point[0]; };
      EXPECT_GE(side(two) * side(two - third), -1e-9) << k;
    }
  }
  EXPECT_GT(inside, 1300);  // all but the lowest layer
}

// One layer on a plane, where spheres that end on three others are taken away: the coverage at which nothing more
// reaches the plane is 0.61056 (Jullien & Meakin 1992). Layers of 30 x 30 scatter by 0.0073, their mean by 0.0026;
// eight layers of 120 x 120 have 0.6106 +- 0.0005.
TEST(SphereDepositionPacking, JammingCoverageOfOneLayer) {
  constexpr int layers = 8;
  constexpr double width = 30.0;
  double mean = 0.0;
  for (int layer = 0; layer < layers; ++layer) {
    auto settings = SpherePacker{.width = width}.settings();
    Grains<3> grains;
    grains.reserve(2000);
    deposition::spheres::Columns columns(settings, grains);
    const deposition::spheres::Roller roller(settings, columns);
    const auto seed = static_cast<std::uint64_t>(layer);
    for (std::uint64_t k = 0; k < 60'000; ++k) {
      const auto rest = roller.drop(width * uniform(seed, Purpose::release_position, k),
                                    width * uniform(seed, Purpose::release_position, k, 1), 0.5);
      ASSERT_EQ(rest.kind, deposition::spheres::Rest::Kind::rest);
      if (rest.position[2] != 0.5) continue;
      grains.add(fixed_sphere(settings.box.wrapped(rest.position)), static_cast<std::int64_t>(grains.size()));
      columns.add(static_cast<std::int32_t>(grains.size() - 1));
    }
    mean += static_cast<double>(grains.size()) * std::numbers::pi / 4.0 / (width * width) / layers;
  }
  EXPECT_NEAR(mean, 0.61056, 0.005);
}

// Equal spheres by steepest descent fill 0.582 (Visscher & Bolsterli 1972); sticking at first touch they fill about
// 0.15 (Lubachevsky, Privman & Roy 1992), here 0.1469 in a bed of 30 x 30 x 4000. Means of three beds of 20 x 20 have
// standard errors of 0.0003 and 0.0018.
TEST(SphereDepositionPacking, SolidFractions) {
  const auto fraction = [](double angle, std::int64_t count, double height) {
    double mean = 0.0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto grains = SpherePacker{.width = 20.0, .count = count, .angle_deg = angle, .seed = seed}.pack();
      mean += solid_fraction(grains, 0.25 * height, 0.75 * height, 400.0) / 3.0;
    }
    return mean;
  };
  EXPECT_NEAR(fraction(0.0, 20'000, 45.0), 0.582, 0.0015);
  EXPECT_NEAR(fraction(90.0, 40'000, 355.0), 0.1469, 0.005);
}

// Steepest descent on a square base with snapped positions gives the face-centred cubic lattice, in layers sqrt(1/2)
// apart; rounding by 2^-42 adds up over 30 layers.
TEST(SphereDepositionPacking, SquareBaseGrowsCubicLattice) {
  auto settings = SpherePacker{.width = 8.0, .count = 64 * 30, .snapped = true}.settings();
  settings.floor = -0.5;
  auto grains = square_base(8);
  const auto method = make_sphere_deposition(settings);
  method->grains_added(grains);
  Team team(1);
  ASSERT_FALSE(method->advance(grains, 1e9, team).trouble);
  for (const auto& grain : grains.line) {
    const double layer = grain.position[2] / std::sqrt(0.5);
    ASSERT_NEAR(layer, std::round(layer), 1e-11);
    const double shift = 0.5 * static_cast<double>((std::lround(layer) + 1) % 2);
    for (const int k : {0, 1}) ASSERT_NEAR(grain.position[k] - shift, std::round(grain.position[k] - shift), 1e-11);
  }
  EXPECT_LT(deepest_overlap(grains, settings.box), 1e-11);
}

// The packing does not depend on where the periodic box begins, nor on the names of its axes.
TEST(SphereDepositionPacking, ShiftedAndMirrored) {
  const SpherePacker packer{.width = 5.0, .count = 150, .angle_deg = 20.0, .spread = 0.3};
  auto shifted = packer;
  shifted.origin = {-1.7, 40.3};
  auto mirrored = packer;
  mirrored.mirrored = true;
  const auto a = packer.pack();
  const auto b = shifted.pack();
  const auto c = mirrored.pack();
  for (std::size_t k = 0; k < a.size(); ++k) {
    const auto& at = a.line[k].position;
    const Vec<3> moved = separation(b.line[k].position - Vec<3>{{-1.7, 40.3, 0.0}}, at, packer.settings().box);
    ASSERT_LT(magnitude(moved), 1e-8) << k;
    expect_position(c.line[k].position, {{at[1], at[0], at[2]}}, 1e-8, k);
  }
}

// Stopped and stored after any number of spheres, a run ends with the same bits as in one piece.
TEST(SphereDepositionPacking, ResumesWithTheSameBits) {
  const SpherePacker packer{.width = 4.0, .count = 150, .angle_deg = 15.0, .spread = 0.5};
  const auto whole = packer.pack();
  Team team(1);
  for (const double stop : {0.0, 1.0, 17.0, 80.0, 149.0, 150.0}) {
    MemoryArchive archive;
    {
      Grains<3> grains;
      const auto method = make_sphere_deposition(packer.settings());
      method->grains_added(grains);
      method->advance(grains, stop, team);
      EXPECT_EQ(method->made(), static_cast<std::int64_t>(stop));
      grains.exchange(archive);
      method->exchange(archive);
    }
    archive.restore = true;
    Grains<3> grains;
    const auto method = make_sphere_deposition(packer.settings());
    grains.exchange(archive);
    method->exchange(archive);
    method->restored(grains, team);
    for (double until = stop; until < 173.0; until += 23.0) method->advance(grains, until, team);
    EXPECT_TRUE(method->complete());
    ASSERT_EQ(grains.size(), whole.size());
    for (std::size_t k = 0; k < whole.size(); ++k) ASSERT_EQ(grains.line[k].position, whole.line[k].position) << k;
    EXPECT_GT(method->contacts(grains).size(), 150U);  // what they rest on is restored too
  }
}

// Contacts follow from supports: in the order of ids, without forces, closed to rounding, with normals to the later
// one.
TEST(SphereDepositionPacking, ContactsAreThoseOfRest) {
  const SpherePacker packer{.count = 600, .spread = 0.4};
  Grains<3> grains;
  const auto method = make_sphere_deposition(packer.settings());
  method->grains_added(grains);
  Team team(1);
  ASSERT_FALSE(method->advance(grains, 1e9, team).trouble);
  auto contacts = method->contacts(grains);
  const auto listed = contacts.list;
  contacts.sort();
  ASSERT_EQ(listed.size(), contacts.size());
  double deepest = 0.0;
  std::size_t by_search = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    for (const auto& normal : supports_of(grains, k, packer.settings(), deepest)) by_search += normal[2] == 1.0 ? 0 : 1;
  }
  EXPECT_EQ(listed.size(), by_search);
  for (std::size_t k = 0; k < listed.size(); ++k) {
    EXPECT_EQ(listed[k].first, contacts.list[k].first);
    EXPECT_EQ(listed[k].second, contacts.list[k].second);
    EXPECT_GT(listed[k].first, listed[k].second);
    EXPECT_NEAR(listed[k].overlap, 0.0, 1e-12);
    EXPECT_EQ(listed[k].normal_force, 0.0);
  }
}

}  // namespace
}  // namespace repose
