// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/core/instruction_set.hpp"
#include "repose/core/random.hpp"
#include "repose/methods/soft/kernels.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <tuple>
#include <vector>

// A fused kernel computes several pairs at once. Its results must be those of the general kernel, which computes one
// pair after the other, to the bit: for every law, instruction set and number of threads.

namespace repose {
namespace {

/// Sets the instruction set of kernels made from now on.
class ChosenSet {
 public:
  explicit ChosenSet(const std::string& set) { ::setenv("REPOSE_INSTRUCTION_SET", set.c_str(), 1); }
  ~ChosenSet() { ::unsetenv("REPOSE_INSTRUCTION_SET"); }
  ChosenSet(const ChosenSet&) = delete;
  ChosenSet& operator=(const ChosenSet&) = delete;
};

struct Case {
  bool periodic = false;
  bool periodic_y = false;  ///< in 3D
  bool synchronised = false;
  std::size_t materials = 1;
};

/// Overlapping grains of many sizes on a lattice with random velocities; some are fixed, one is large.
template <int D>
Grains<D> crowd(std::size_t materials) {
  Grains<D> grains;
  const int side = D == 2 ? 24 : 8;
  const int count = D == 2 ? side * side : side * side * side;
  for (int k = 0; k < count; ++k) {
    const auto number = [&](std::uint32_t draw) {
      return uniform(7, Purpose::release_position, static_cast<std::uint64_t>(k), draw);
    };
    Grain<D> grain;
    int rest = k;
    for (int axis = 0; axis < D; ++axis) {
      const auto a = static_cast<std::uint32_t>(axis);
      grain.position[axis] = rest % side + 0.05 * number(a);
      grain.velocity[axis] = 0.3 * (number(10 + a) - 0.5);
      rest /= side;
      if constexpr (D == 3) grain.rim_velocity[axis] = 0.3 * (number(30 + a) - 0.5);
    }
    if constexpr (D == 2) grain.rim_velocity = 0.3 * (number(30) - 0.5);
    grain.radius = 0.42 + 0.1 * number(20);
    if (k == count - 1) {  // a large one above the others
      grain.radius = 3.0;
      for (int axis = 0; axis < D; ++axis) grain.position[axis] = axis == D - 1 ? side + 2.5 : 0.5 * side;
    }
    grain.mass = grain.radius * grain.radius;
    grain.inverse_mass = number(21) < 0.05 ? 0.0 : 1.0 / grain.mass;
    if (grain.fixed()) {
      grain.velocity = {};
      grain.rim_velocity = {};
    }
    grains.add(grain, k, false, static_cast<std::uint16_t>(static_cast<std::size_t>(k / 3) % materials));
  }
  return grains;
}

template <int D>
SoftSettings<D> settings_of(const Case& of) {
  SoftSettings<D> settings;
  settings.time_step = 1e-3;
  settings.gravity[D - 1] = -1.0;
  settings.box.periodic = of.periodic;
  settings.box.x_min = of.periodic ? -0.4 : -100.0;
  settings.box.x_max = of.periodic ? (D == 2 ? 23.6 : 7.6) : 100.0;
  settings.box.periodic_y = of.periodic_y;
  settings.box.y_min = of.periodic_y ? -0.4 : -100.0;
  settings.box.y_max = of.periodic_y ? 7.6 : 100.0;
  settings.skin = 0.05;
  settings.synchronised = of.synchronised;
  Wall<D> floor;
  floor.point[D - 1] = -0.3;
  floor.normal[D - 1] = 1.0;
  settings.walls = {floor};
  return settings;
}

/// The numbers of a state after some steps, in the order of ids, and the slip displacements.
template <int D>
std::vector<double> numbers_after(Method<D>& method, const Case& of, int threads) {
  Team team(threads);
  auto grains = crowd<D>(of.materials);
  method.grains_added(grains);
  method.set_loads({Load<D>{5, {}}, Load<D>{200, settings_of<D>(of).gravity * 3.0}});
  EXPECT_FALSE(method.advance(grains, 0.06, team).trouble);
  std::vector<double> numbers;
  for (const auto k : by_id(grains)) {
    const auto& grain = grains.line[k];
    for (int axis = 0; axis < D; ++axis) {
      numbers.push_back(grain.position[axis]);
      numbers.push_back(grain.velocity[axis]);
      if constexpr (D == 3) numbers.push_back(grain.rim_velocity[axis]);
    }
    if constexpr (D == 2) numbers.push_back(grain.rim_velocity);
  }
  for (const auto& contact : method.contacts(grains).list) numbers.push_back(magnitude(contact.slip));
  return numbers;
}

/// Laws of every pair of materials. Pairs of different materials have less friction.
template <class Law>
MaterialTable<Law> table_of(const Law& law, std::size_t materials) {
  std::vector<Law> laws(materials * materials, law);
  for (std::size_t k = 0; k < laws.size(); ++k) {
    if (k % (materials + 1) != 0) laws[k].tangential.friction = 0.2;
  }
  return MaterialTable<Law>(std::move(laws), materials);
}

template <int D, class Law>
std::unique_ptr<Method<D>> general(const MaterialTable<Law>& laws, const Case& of) {
  std::vector<AnyPairLaw> any;
  for (const auto& law : laws.all()) any.push_back({{law.normal}, {law.tangential}, {}, {}});
  return make_kernel<D>(MaterialTable<AnyPairLaw>(std::move(any), laws.materials()), settings_of<D>(of));
}

template <int D, class Law>
void compare(const Law& law, const Case& of) {
  const auto laws = table_of(law, of.materials);
  const auto expected = numbers_after(*general<D>(laws, of), of, 1);
  ASSERT_GT(expected.size(), 1000U);
  for (const auto set :
       {InstructionSet::scalar, InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!has(set)) continue;
    const ChosenSet chosen{std::string(name_of(set))};
    const int threads = set == InstructionSet::baseline || set == InstructionSet::avx512 ? 3 : 1;
    const auto numbers = numbers_after(*make_kernel<D>(laws, settings_of<D>(of)), of, threads);
    EXPECT_EQ(numbers, expected) << name_of(set) << ", " << threads << " threads";
  }
}

const HookeLinear hooke_linear{Hooke{2000.0, 0.3}, Linear{0.5, 600.0, 0.2}};
const HookeLinear hooke_restitution{{2000.0, 0.2, true, DampingKind::restitution, 0.5}, Linear{0.5, 600.0, 0.2}};
const HookeLinear hooke_viscosity{{2000.0, 8.0, false, DampingKind::viscosity}, Linear{0.5, 600.0, 0.0}};
const HookeCumulative hooke_cumulative{Hooke{2000.0, 0.15}, Cumulative{0.5, 1.214}};
const HertzMindlin hertz_mindlin{Hertz{5000.0, 0.3}, Mindlin{0.5, 0.82, 0.2}};
const ElasticHertzMindlin elastic_mindlin{ElasticHertz{8000.0, 0.3}, Mindlin{0.5, 0.82, 0.2}};
const ContinuousCumulative continuous{Continuous::make(36.0, 1.2, 0.5, 1.0), Cumulative{0.5, 1.214}};
const ContinuousCumulative broken_power{Continuous::make(11.5, 1.2, 0.5, 1.0), Cumulative{0.5, 1.214}};

template <int D>
void compare_all(const Case& of) {
  compare<D>(hooke_linear, of);
  compare<D>(hooke_restitution, of);
  compare<D>(hooke_viscosity, of);
  compare<D>(hooke_cumulative, of);
  compare<D>(hertz_mindlin, of);
  compare<D>(elastic_mindlin, of);
  compare<D>(continuous, of);
  compare<D>(broken_power, of);
}

TEST(SoftKernels, HaveTheBitsOfTheGeneralKernel) { compare_all<2>({}); }
TEST(SoftKernels, HaveTheBitsOfTheGeneralKernelIn3D) { compare_all<3>({}); }
TEST(SoftKernels, ReachAcrossAPeriodicBox) {
  compare_all<2>({.periodic = true});
  compare_all<3>({.periodic = true});
  compare_all<3>({.periodic_y = true});
  compare_all<3>({.periodic = true, .periodic_y = true});
}
TEST(SoftKernels, TakeSynchronisedVelocities) {
  compare_all<2>({.synchronised = true});
  compare_all<3>({.synchronised = true});
}
TEST(SoftKernels, KeepTheLawsOfMaterialsApart) {
  compare_all<2>({.materials = 2});
  compare_all<3>({.materials = 3});
}

TEST(InstructionSets, AreNamedByTheEnvironment) {
  for (const auto set : {InstructionSet::scalar, InstructionSet::baseline}) {
    const ChosenSet chosen{std::string(name_of(set))};
    EXPECT_EQ(chosen_instruction_set(), set);
  }
  const ChosenSet wrong("sse9");
  EXPECT_THROW(chosen_instruction_set(), InputError);
}

}  // namespace
}  // namespace repose
