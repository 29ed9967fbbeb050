// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/aligned.hpp"
#include "repose/methods/contact_dynamics/kernels.hpp"
#include "repose/methods/contact_dynamics/pack_groups.hpp"
#include "repose/methods/contact_dynamics/packs.hpp"
#include "repose/methods/contact_dynamics/relax.hpp"
#include "repose/methods/contact_dynamics/solver.hpp"
#include "support/random_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <string>
#include <vector>

namespace repose::contact_dynamics {
namespace {

/// The indices of the contacts in the order of their packs.
std::vector<std::size_t> order_of(const Packs& packs) {
  std::vector<std::size_t> order;
  for (std::size_t pack = 0; pack < packs.size(); ++pack) {
    for (std::size_t lane = 0; lane < pack_lanes; ++lane) {
      if (packs.contact(pack, lane) != Packs::none) order.push_back(packs.contact(pack, lane));
    }
  }
  return order;
}

/// Does the same as Packs::sweep_both_ways, one contact after the other. `fractions` is by index in the problem.
void sweep_one_by_one(Problem<2>& problem, const std::vector<std::size_t>& order, const std::vector<double>& fractions,
                      std::vector<Impulse<2>>& changes) {
  const FreeBodies among;
  auto& bodies = problem.bodies;
  changes.assign(problem.contacts.size(), {});
  for (const auto k : order) {
    auto& c = problem.contacts[k];
    relax_translation(among, fractions[k], c, bodies[c.first], bodies[c.second], changes[k]);
    if (problem.rolling) relax_roll(among, c, bodies[c.first], bodies[c.second], changes[k]);
  }
  for (auto k = order.rbegin(); k != order.rend(); ++k) {
    auto& c = problem.contacts[*k];
    if (problem.rolling) relax_roll(among, c, bodies[c.first], bodies[c.second], changes[*k]);
    relax_translation(among, fractions[*k], c, bodies[c.first], bodies[c.second], changes[*k]);
  }
}

void expect_same_bits(double a, double b, const std::string& what) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b)) << what << ": " << a << ", " << b;
}

void expect_same_bits(const Impulse<2>& a, const Impulse<2>& b, const std::string& what) {
  expect_same_bits(a.normal, b.normal, what + ", normal");
  expect_same_bits(a.tangent, b.tangent, what + ", tangent");
  expect_same_bits(a.roll, b.roll, what + ", roll");
}

void expect_same_bits(const Body<2>& a, const Body<2>& b, const std::string& what) {
  expect_same_bits(a.velocity[0], b.velocity[0], what + ", velocity x");
  expect_same_bits(a.velocity[1], b.velocity[1], what + ", velocity y");
  expect_same_bits(a.rim_velocity, b.rim_velocity, what + ", rim velocity");
  expect_same_bits(a.inverse_mass, b.inverse_mass, what + ", inverse mass");
}

/// Sweeps the packs three times and compares with sweeps over single contacts.
void compare_sweeps(const Problem<2>& problem, bool partly, InstructionSet set, std::size_t parts = 1) {
  Packs packs;
  packs.build(problem, parts);
  std::vector<double> fraction_of(problem.contacts.size(), 1.0);
  AlignedDoubles fractions(packs.size() * pack_lanes);
  for (std::size_t pack = 0; pack < packs.size(); ++pack) {
    for (std::size_t lane = 0; lane < pack_lanes; ++lane) {
      const auto k = packs.contact(pack, lane);
      if (k == Packs::none) continue;
      if (partly) fraction_of[k] = 0.3 + 0.1 * static_cast<double>(k % 7);
      fractions[pack * pack_lanes + lane] = fraction_of[k];
    }
  }
  auto expected = problem;
  std::vector<Impulse<2>> expected_changes;
  auto found = problem;
  packs.add_bodies(found.bodies);
  AlignedDoubles impulses(packs.size() * packs.numbers());
  AlignedDoubles changes(impulses.size());
  packs.load(found.contacts, impulses.data());
  Team alone(1);
  PackSweep sweep;
  sweep.impulses = impulses.data();
  sweep.bodies = found.bodies.data();
  sweep.fractions = partly ? fractions.data() : nullptr;
  sweep.history.change = changes.data();
  for (int k = 0; k < 3; ++k) {
    sweep_one_by_one(expected, order_of(packs), fraction_of, expected_changes);
    packs.sweep_both_ways(sweep, kernels_of(set), alone);
  }
  packs.store(impulses.data(), found.contacts);
  auto found_changes = problem.contacts;
  for (auto& c : found_changes) c.impulse = {};
  packs.store(changes.data(), found_changes);
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
    expect_same_bits(expected.contacts[k].impulse, found.contacts[k].impulse, "impulse " + std::to_string(k));
    expect_same_bits(expected_changes[k], found_changes[k].impulse, "change " + std::to_string(k));
  }
  for (std::size_t k = 0; k < problem.free.size(); ++k) {
    expect_same_bits(expected.bodies[k], found.bodies[k], "body " + std::to_string(k));
  }
  if (parts == 1) expect_same_bits(found.bodies.back(), Body<2>(), "body of the unused lanes");
}

class PackedSweeps : public testing::TestWithParam<InstructionSet> {};

TEST_P(PackedSweeps, GiveTheBitsOfContactsOneByOne) {
  if (!has(GetParam())) GTEST_SKIP() << "this machine lacks the instructions";
  unsigned seed = 0;
  for (const std::size_t contacts : {1u, 2u, 7u, 8u, 9u, 50u, 333u, 2000u}) {
    for (const bool rolling : {false, true}) {
      for (const bool partly : {false, true}) {
        SCOPED_TRACE(std::to_string(contacts) + (rolling ? " rolling" : "") + (partly ? " partly" : ""));
        compare_sweeps(random_problem(3 + contacts / 2, contacts, rolling, ++seed), partly, GetParam());
      }
    }
  }
}

TEST_P(PackedSweeps, InPartsToo) {
  if (!has(GetParam())) GTEST_SKIP() << "this machine lacks the instructions";
  for (const std::size_t parts : {2u, 5u, 32u}) {
    compare_sweeps(random_problem(400, 900, true, 17), true, GetParam(), parts);
  }
}

/// The solution of a random problem after some sweeps, of each kind of sweep.
Problem<2> solved(bool packed, bool accelerated, bool rolling, InstructionSet set) {
  auto problem = random_problem(160, 300, rolling, 11);
  for (std::size_t k = 0; k < problem.contacts.size(); k += 5) {
    problem.contacts[k].friction = std::numeric_limits<double>::infinity();
  }
  SolverSettings settings;
  settings.tolerance = 0.0;
  settings.most_sweeps = 230;
  settings.packed = packed;
  settings.accelerated = accelerated;
  settings.instructions = set;
  Solver<2>(settings).solve(problem);
  return problem;
}

TEST_P(PackedSweeps, TheWholeSolverHasTheSameBits) {
  if (!has(GetParam())) GTEST_SKIP() << "this machine lacks the instructions";
  for (const bool packed : {false, true}) {
    for (const bool accelerated : {false, true}) {
      for (const bool rolling : {false, true}) {
        const auto expected = solved(packed, accelerated, rolling, InstructionSet::baseline);
        const auto found = solved(packed, accelerated, rolling, GetParam());
        for (std::size_t k = 0; k < expected.contacts.size(); ++k) {
          expect_same_bits(expected.contacts[k].impulse, found.contacts[k].impulse, "impulse " + std::to_string(k));
        }
        for (std::size_t k = 0; k < expected.bodies.size(); ++k) {
          expect_same_bits(expected.bodies[k], found.bodies[k], "body " + std::to_string(k));
        }
      }
    }
  }
}

std::string name_of(const testing::TestParamInfo<InstructionSet>& set) {
  if (set.param == InstructionSet::avx512) return "avx512";
  return set.param == InstructionSet::avx2 ? "avx2" : "baseline";
}

INSTANTIATE_TEST_SUITE_P(Every, PackedSweeps,
                         testing::Values(InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512),
                         name_of);

TEST(ContactPacks, NoMovingBodyTwiceAndEveryContactOnce) {
  Packs packs;  // reused, as in a run
  for (const std::size_t contacts : {0u, 1u, 9u, 100u, 3000u, 40u}) {
    const auto problem = random_problem(3 + contacts / 2, contacts, false, 7);
    packs.build(problem);
    std::vector<int> times(contacts, 0);
    for (std::size_t pack = 0; pack < packs.size(); ++pack) {
      std::vector<std::uint32_t> moving;
      for (std::size_t lane = 0; lane < pack_lanes; ++lane) {
        const auto k = packs.contact(pack, lane);
        if (k == Packs::none) {
          EXPECT_EQ(packs[pack].first[lane], problem.free.size());
          EXPECT_EQ(packs[pack].second[lane], problem.free.size());
          continue;
        }
        ++times[k];
        const auto& c = problem.contacts[k];
        EXPECT_EQ(packs[pack].first[lane], c.first);
        EXPECT_EQ(packs[pack].second[lane], c.second);
        for (const auto body : {c.first, c.second}) {
          if (problem.free[body].inverse_mass > 0.0) moving.push_back(body);
        }
      }
      std::sort(moving.begin(), moving.end());
      EXPECT_EQ(std::adjacent_find(moving.begin(), moving.end()), moving.end()) << "pack " << pack;
    }
    EXPECT_EQ(times, std::vector<int>(contacts, 1));
  }
}

TEST(ContactPacks, GroupsOfAColourShareNoMovingBody) {
  for (const std::size_t parts : {1u, 2u, 7u, 32u}) {
    SCOPED_TRACE(parts);
    const auto problem = random_problem(500, 1100, false, 23);
    const auto groups = group_contacts(problem, parts);
    ASSERT_EQ(groups.colour_start.front(), 0u);
    ASSERT_EQ(groups.colour_start.back(), groups.contacts.size());
    std::vector<int> times(problem.contacts.size(), 0);
    for (std::size_t colour = 0; colour + 1 < groups.colour_start.size(); ++colour) {
      constexpr auto none = std::numeric_limits<std::size_t>::max();
      std::vector<std::size_t> group_of(problem.free.size(), none);
      for (auto group = groups.colour_start[colour]; group < groups.colour_start[colour + 1]; ++group) {
        for (const auto k : groups.contacts[group]) {
          ++times[k];
          for (const auto body : {problem.contacts[k].first, problem.contacts[k].second}) {
            if (!(problem.free[body].inverse_mass > 0.0)) continue;
            EXPECT_TRUE(group_of[body] == none || group_of[body] == group) << "body " << body;
            group_of[body] = group;
          }
        }
      }
    }
    EXPECT_EQ(times, std::vector<int>(problem.contacts.size(), 1));
  }
}

// A row of discs, each on the next: a pack is filled before a disc occurs again.
TEST(ContactPacks, OfALongRowAreFull) {
  Problem<2> problem;
  for (std::uint32_t k = 0; k < 4001; ++k) {
    Body<2> body;
    body.inverse_mass = 1.0;
    problem.free.push_back(body);
    if (k == 0) continue;
    ContactLine<2> c;
    c.first = k - 1;
    c.second = k;
    problem.contacts.push_back(c);
  }
  Packs packs;
  packs.build(problem);
  EXPECT_LE(packs.size(), 510u);
}

TEST(ContactPacks, ImpulsesThereAndBack) {
  const auto problem = random_problem(60, 101, true, 3);
  Packs packs;
  packs.build(problem);
  AlignedDoubles impulses(packs.size() * packs.numbers());
  packs.load(problem.contacts, impulses.data());
  auto back = problem.contacts;
  for (auto& c : back) c.impulse = {-1.0, -1.0, -1.0};
  packs.store(impulses.data(), back);
  for (std::size_t k = 0; k < back.size(); ++k) {
    expect_same_bits(problem.contacts[k].impulse, back[k].impulse, "impulse " + std::to_string(k));
  }
}

// The whole solver, with acceleration and yielding: single contacts in the order of the packs give the same result.
// They do not give the same bits, because velocities are computed from impulses in the order of the problem, which
// differs.
TEST(ContactPacks, SolverAgreesWithSingleContactsInTheirOrder) {
  for (const bool rolling : {false, true}) {
    auto packed = random_problem(160, 200, rolling, 5);
    Packs packs;
    packs.build(packed);
    auto single = packed;
    const auto order = order_of(packs);
    for (std::size_t k = 0; k < order.size(); ++k) single.contacts[k] = packed.contacts[order[k]];
    SolverSettings settings;
    settings.tolerance = 0.0;
    settings.most_sweeps = 230;
    const auto fast = Solver<2>(settings).solve(packed);
    settings.packed = false;
    const auto simple = Solver<2>(settings).solve(single);
    EXPECT_NEAR(fast.residual, simple.residual, 1e-10);
    for (std::size_t k = 0; k < order.size(); ++k) {
      EXPECT_NEAR(packed.contacts[order[k]].impulse.normal, single.contacts[k].impulse.normal, 1e-10) << k;
      EXPECT_NEAR(packed.contacts[order[k]].impulse.tangent, single.contacts[k].impulse.tangent, 1e-10) << k;
      EXPECT_NEAR(packed.contacts[order[k]].impulse.roll, single.contacts[k].impulse.roll, 1e-10) << k;
    }
  }
}

}  // namespace
}  // namespace repose::contact_dynamics
