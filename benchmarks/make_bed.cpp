// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bed.hpp"
#include "bed_method.hpp"
#include "repose/core/random.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

// Settles a bed as beds/README.md describes it and writes it in the format of LAMMPS.

namespace repose::bench {
namespace {

constexpr double largest = 1.2;   // diameter
constexpr double spacing = 1.22;  // of the lattice from which grains fall

template <int D>
void add_fixed(Bed<D>& bed, const Vec<D>& place) {
  Grain<D> grain;
  grain.radius = 0.5;
  grain.mass = 1.0;
  grain.position = place;
  bed.grains.add(grain, static_cast<std::int64_t>(bed.grains.size()), true);
}

/// The shape of a bed: its periodic length and, for spheres, the width between its sides.
struct Shape {
  int length = 0;
  int width = 1;
};

/// A row of discs, or a floor and two sides of spheres, as high as the grains at the start.
void add_base(Bed<2>& bed, const Shape& shape, double /*height*/) {
  for (int x = 0; x < shape.length; ++x) add_fixed(bed, Vec<2>{{x + 0.5, 0.0}});
}
void add_base(Bed<3>& bed, const Shape& shape, double height) {
  for (int x = 0; x < shape.length; ++x) {
    for (int y = 0; y <= shape.width + 1; ++y) add_fixed(bed, Vec<3>{{x + 0.5, y - 0.5, 0.0}});
    for (int z = 1; z <= height; ++z) {
      add_fixed(bed, Vec<3>{{x + 0.5, -0.5, 1.0 * z}});
      add_fixed(bed, Vec<3>{{x + 0.5, shape.width + 0.5, 1.0 * z}});
    }
  }
}

/// Grains on a loose lattice whose every second layer stands over the gaps of the first.
template <int D>
Bed<D> loose_bed(const Shape& shape, int count) {
  Bed<D> bed;
  bed.box.periodic = true;
  bed.box.x_min = 0.0;
  bed.box.x_max = shape.length;
  const int along = static_cast<int>(shape.length / spacing);
  const int across = D == 3 ? static_cast<int>((shape.width - largest) / spacing + 0.5) : 1;
  const int layer = along * across;
  const double rise = spacing * (D == 3 ? 0.71 : 0.87);
  add_base(bed, shape, rise * (2.0 + static_cast<double>(count) / layer));
  for (int k = 0; k < count; ++k) {
    Grain<D> grain;
    const double diameter = 0.8 + 0.4 * uniform(1, Purpose::grain_size, static_cast<std::uint64_t>(k));
    grain.radius = 0.5 * diameter;
    grain.mass = mass_of<D>(diameter);
    grain.inverse_mass = 1.0 / grain.mass;
    const double shift = k / layer % 2 == 0 ? 0.0 : 0.5;
    grain.position[0] = (k % along + 0.25 + shift) * shape.length / along;
    if (D == 3) grain.position[1] = 0.5 * largest + (k / along % across + shift) * spacing;
    grain.position[up<D>] = largest + rise * (k / layer);
    bed.grains.add(grain, static_cast<std::int64_t>(bed.grains.size()));
  }
  return bed;
}

/// Moves the grains until their energy of motion is small. Once they have fallen they are slowed down now and then, or
/// a deep bed would swing for long.
template <int D>
void settle(Bed<D>& bed, Method<D>& method) {
  constexpr double little = 1e-4;  // [m g d] for each grain
  constexpr double slower = 0.1;
  Team team(1);
  method.grains_added(bed.grains);
  const auto moving = static_cast<double>(moving_count(bed.grains));
  double before = 0.0;
  for (double energy = moving; energy > little * moving;) {
    const auto until = method.time_steps().later(method.time(), 1.0);
    if (method.advance(bed.grains, until, team).trouble) throw std::runtime_error("the bed has exploded");
    energy = kinetic_energy(bed.grains);
    if (energy < before) {
      for (auto& grain : bed.grains.line) {
        grain.velocity *= slower;
        grain.rim_velocity = grain.rim_velocity * slower;
      }
    }
    before = energy;
  }
}

template <int D>
int make(const std::string& law, const Shape& shape, int count, const std::string& path) {
  auto bed = loose_bed<D>(shape, count);
  // The file has no slip displacements. Grains settle again without them, so that they move little when it is read.
  constexpr int times = 2;
  for (int k = 0; k < times; ++k) settle(bed, *bed_method<D>(law, bed.box));
  write_bed(bed, path);
  return 0;
}

}  // namespace
}  // namespace repose::bench

int main(int argc, char** argv) {
  using namespace repose::bench;
  if (argc != 7) {
    fmt::print(stderr, "usage: repose_make_bed 2|3 LAW LENGTH WIDTH GRAINS FILE\n");
    return 2;
  }
  try {
    const std::string law = argv[2];
    const Shape shape{std::stoi(argv[3]), std::stoi(argv[4])};
    const int count = std::stoi(argv[5]);
    return argv[1] == std::string("3") ? make<3>(law, shape, count, argv[6]) : make<2>(law, shape, count, argv[6]);
  } catch (const std::exception& failure) {
    fmt::print(stderr, "repose_make_bed: {}\n", failure.what());
    return 1;
  }
}
