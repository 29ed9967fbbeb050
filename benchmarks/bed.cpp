// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bed.hpp"

#include <fmt/os.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace repose::bench {

namespace {

template <int D>
void read_atom(std::istringstream& words, Grain<D>& grain) {
  int type = 0;
  double diameter = 0.0;
  double density = 0.0;
  words >> type >> diameter >> density;
  for (int k = 0; k < D; ++k) words >> grain.position[k];
  if (!words || diameter <= 0.0) throw std::runtime_error("not an atom of style sphere");
  grain.radius = 0.5 * diameter;
  grain.mass = mass_of<D>(diameter);
  grain.inverse_mass = type == 2 ? 0.0 : 1.0 / grain.mass;
}

template <int D>
void read_velocity(std::istringstream& words, Grain<D>& grain) {
  Vec<3> velocity;
  Vec<3> spin;
  for (int k = 0; k < 3; ++k) words >> velocity[k];
  for (int k = 0; k < 3; ++k) words >> spin[k];
  if (!words) throw std::runtime_error("not a velocity of style sphere");
  for (int k = 0; k < D; ++k) grain.velocity[k] = velocity[k];
  if constexpr (D == 2) {
    grain.rim_velocity = spin[2] * grain.radius;
  } else {
    grain.rim_velocity = spin * grain.radius;
  }
}

}  // namespace

template <int D>
Bed<D> read_bed(const std::string& path, int copies) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot read");
  std::map<std::int64_t, Grain<D>> read;
  double low = 0.0;
  double high = 0.0;
  std::string section;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string first;
    if (!(words >> first)) continue;
    if (first == "Atoms" || first == "Velocities") {
      section = first;
    } else if (section.empty() && line.find("xlo xhi") != std::string::npos) {
      low = std::stod(first);
      words >> high;
    } else if (section == "Atoms") {
      read_atom(words, read[std::stoll(first)]);
    } else if (section == "Velocities") {
      read_velocity(words, read.at(std::stoll(first)));
    }
  }
  if (read.empty() || !(high > low)) throw std::runtime_error(path + ": no atoms or no box");
  Bed<D> bed;
  bed.box.periodic = true;
  bed.box.x_min = low;
  bed.box.x_max = low + copies * (high - low);
  bed.grains.reserve(read.size() * static_cast<std::size_t>(copies));
  for (int copy = 0; copy < copies; ++copy) {
    for (auto [id, grain] : read) {
      grain.position[0] += copy * (high - low);
      const auto stable = static_cast<std::int64_t>(copy) * static_cast<std::int64_t>(read.size()) + id - 1;
      bed.grains.add(grain, stable, grain.fixed());
    }
  }
  return bed;
}

template <int D>
void write_bed(const Bed<D>& bed, const std::string& path) {
  Vec<3> low{};
  Vec<3> high{};
  for (const auto& grain : bed.grains.line) {
    for (int k = 1; k < D; ++k) {
      low[k] = std::min(low[k], grain.position[k] - 1.0);
      high[k] = std::max(high[k], grain.position[k] + 1.0);
    }
  }
  if (D == 2) {
    low[2] = -0.5;
    high[2] = 0.5;
  }
  auto file = fmt::output_file(path);
  file.print("LAMMPS data file: a bed of beds/README.md\n\n{} atoms\n2 atom types\n\n", bed.grains.size());
  file.print("{} {} xlo xhi\n{} {} ylo yhi\n{} {} zlo zhi\n", bed.box.x_min, bed.box.x_max, low[1], high[1], low[2],
             high[2]);
  file.print("\nAtoms # sphere\n\n");
  const double density = D == 2 ? 4.0 / std::numbers::pi : 6.0 / std::numbers::pi;
  for (std::size_t k = 0; k < bed.grains.size(); ++k) {
    const auto& grain = bed.grains.line[k];
    const auto place = bed.box.wrapped(grain.position);
    double z = 0.0;
    if constexpr (D == 3) z = place[2];
    file.print("{} {} {} {} {} {} {}\n", bed.grains.id[k] + 1, grain.fixed() ? 2 : 1, 2.0 * grain.radius, density,
               place[0], place[1], z);
  }
  file.print("\nVelocities\n\n");
  for (std::size_t k = 0; k < bed.grains.size(); ++k) {
    const auto& grain = bed.grains.line[k];
    const auto& v = grain.velocity;
    if constexpr (D == 2) {
      file.print("{} {} {} 0 0 0 {}\n", bed.grains.id[k] + 1, v[0], v[1], grain.rim_velocity / grain.radius);
    } else {
      const Vec<3> spin = grain.rim_velocity * (1.0 / grain.radius);
      file.print("{} {} {} {} {} {} {}\n", bed.grains.id[k] + 1, v[0], v[1], v[2], spin[0], spin[1], spin[2]);
    }
  }
}

template Bed<2> read_bed(const std::string&, int);
template Bed<3> read_bed(const std::string&, int);
template void write_bed(const Bed<2>&, const std::string&);
template void write_bed(const Bed<3>&, const std::string&);

}  // namespace repose::bench
