// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bed.hpp"
#include "bed_method.hpp"

#include <fmt/format.h>

#include <set>
#include <string>

// Runs a bed for a number of steps and prints the numbers that are compared with LAMMPS: kinetic energy without that of
// rotation, height of the centre of mass, vertical force on the fixed grains, weight of the moving ones.

namespace repose::bench {
namespace {

template <int D>
int measure(const std::string& path, long steps) {
  auto bed = read_bed<D>(path, 1);
  const auto method = bed_method<D>("hooke", bed.box);
  Team team(1);
  method->grains_added(bed.grains);
  method->advance(bed.grains, method->time_steps().after(steps), team);
  double mass = 0.0;
  double height = 0.0;
  double energy = 0.0;
  std::set<std::int64_t> fixed;
  for (std::size_t k = 0; k < bed.grains.size(); ++k) {
    const auto& grain = bed.grains.line[k];
    if (grain.fixed()) {
      fixed.insert(bed.grains.id[k]);
      continue;
    }
    mass += grain.mass;
    height += grain.mass * grain.position[up<D>];
    energy += 0.5 * grain.mass * squared(grain.velocity);
  }
  double force = 0.0;
  for (const auto& contact : method->contacts(bed.grains).list) {
    if (fixed.contains(contact.first)) force -= force_of(contact)[up<D>];
    if (fixed.contains(contact.second)) force += force_of(contact)[up<D>];
  }
  fmt::print("{} {} {} {}\n", energy, height / mass, force, mass);
  return 0;
}

}  // namespace
}  // namespace repose::bench

int main(int argc, char** argv) {
  using namespace repose::bench;
  if (argc != 4) {
    fmt::print(stderr, "usage: repose_bed_physics 2|3 BED STEPS\n");
    return 2;
  }
  const long steps = std::stol(argv[3]);
  return argv[1] == std::string("3") ? measure<3>(argv[2], steps) : measure<2>(argv[2], steps);
}
