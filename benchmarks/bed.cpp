// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bed.hpp"

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace repose::bench {

Bed read_bed(const std::string& path, int copies) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot read");
  std::map<std::int64_t, Grain<2>> read;
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
      int type = 0;
      double diameter = 0.0;
      double density = 0.0;
      Grain<2> grain;
      if (!(words >> type >> diameter >> density >> grain.position[0] >> grain.position[1]) || diameter <= 0.0) {
        throw std::runtime_error(path + ": not an atom of style sphere: " + line);
      }
      grain.radius = 0.5 * diameter;
      grain.mass = diameter * diameter;
      grain.inverse_mass = type == 2 ? 0.0 : 1.0 / grain.mass;
      read[std::stoll(first)] = grain;
    } else if (section == "Velocities") {
      double z = 0.0;
      double wx = 0.0;
      double wy = 0.0;
      double wz = 0.0;
      auto& grain = read.at(std::stoll(first));
      if (!(words >> grain.velocity[0] >> grain.velocity[1] >> z >> wx >> wy >> wz)) {
        throw std::runtime_error(path + ": not a velocity of style sphere: " + line);
      }
      grain.rim_velocity = wz * grain.radius;
    }
  }
  if (read.empty() || !(high > low)) throw std::runtime_error(path + ": no atoms or no box");
  Bed bed;
  bed.box.periodic = true;
  bed.box.x_min = low;
  bed.box.x_max = low + copies * (high - low);
  for (int copy = 0; copy < copies; ++copy) {
    for (auto [id, grain] : read) {
      grain.position[0] += copy * (high - low);
      const auto stable = static_cast<std::int64_t>(copy) * static_cast<std::int64_t>(read.size()) + id - 1;
      bed.grains.add(grain, stable, grain.fixed());
    }
  }
  return bed;
}

}  // namespace repose::bench
