// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/exports.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

/// The bounds of a snapshot: in x those of a periodic box, otherwise those of the grains.
struct Bounds2 {
  double low[2];
  double high[2];
};
Bounds2 bounds_of(const Grains<2>& grains, const Box<2>& box) {
  Bounds2 bounds{{0.0, 0.0}, {0.0, 0.0}};
  for (int axis = 0; axis < 2; ++axis) {
    bool first = true;
    for (const auto& grain : grains.line) {
      const double low = grain.position[axis] - grain.radius;
      const double high = grain.position[axis] + grain.radius;
      bounds.low[axis] = first ? low : std::min(bounds.low[axis], low);
      bounds.high[axis] = first ? high : std::max(bounds.high[axis], high);
      first = false;
    }
  }
  if (box.periodic) {
    bounds.low[0] = box.x_min;
    bounds.high[0] = box.x_max;
  }
  return bounds;
}

/// Radii of a grain that a bond with the mean force is wide.
constexpr double width_at_mean = 0.3;

// All numbers are printed with the fewest digits that read back as the same bits.

void print_header(WholeFile& file, const Moment& moment, const Box<2>& box, const char* what, std::size_t count) {
  const auto bounds = bounds_of(*moment.grains, box);
  file.print(
      "ITEM: TIME\n{}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\nITEM: BOX BOUNDS {} ff pp\n{} {}\n{} {}\n-0.5 0.5\n",
      moment.time, moment.step, what, count, box.periodic ? "pp" : "ff", bounds.low[0], bounds.high[0], bounds.low[1],
      bounds.high[1]);
}

}  // namespace

VtkPolyData grains_for_vtk(const Moment& moment) {
  const auto& grains = *moment.grains;
  VtkPolyData data;
  std::vector<std::int64_t> coordination(grains.size(), 0);
  for (const auto& contact : moment.contacts.list) {
    if (!(contact.normal_force > 0.0)) continue;
    ++coordination[moment.grains.find(contact.first).value()];
    if (contact.second >= 0) ++coordination[moment.grains.find(contact.second).value()];
  }
  std::vector<double> radius, diameter, mass, velocity, spin, energy;
  std::vector<std::int64_t> material;
  std::vector<std::uint8_t> fixed, base;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    data.points.insert(data.points.end(), {grain.position[0], grain.position[1], 0.0});
    velocity.insert(velocity.end(), {grain.velocity[0], grain.velocity[1], 0.0});
    radius.push_back(grain.radius);
    diameter.push_back(2.0 * grain.radius);
    mass.push_back(grain.mass);
    spin.push_back(grain.rim_velocity / grain.radius);
    energy.push_back(grain.fixed() ? 0.0 : kinetic_energy(grain));
    material.push_back(grains.material[k]);
    fixed.push_back(grain.fixed() ? 1 : 0);
    base.push_back(grains.base[k]);
  }
  data.point_data = {{"id", 1, grains.id},         {"diameter", 1, diameter},
                     {"radius", 1, radius},        {"mass", 1, mass},
                     {"velocity", 3, velocity},    {"spin", 1, spin},
                     {"fixed", 1, fixed},          {"base", 1, base},
                     {"material", 1, material},    {"contacts", 1, coordination},
                     {"kinetic_energy", 1, energy}};
  if (moment.stress.empty()) return data;
  std::vector<double> stress;
  for (const auto& s : moment.stress) stress.insert(stress.end(), {s[0], s[1], 0.0, s[2], s[3], 0.0, 0.0, 0.0, 0.0});
  data.point_data.push_back({"stress", 9, stress});
  data.point_data.push_back({"stress_area", 1, moment.area});
  return data;
}

VtkPolyData contacts_for_vtk(const Moment& moment, const Box<2>& box, bool forces) {
  VtkPolyData data;
  data.vertices = false;
  std::vector<double> normal_force, tangential_force, overlap, force;
  std::vector<std::int64_t> partners;
  std::vector<std::uint8_t> sliding;
  for (const auto& contact : moment.contacts.list) {
    const auto& first = moment.grains->line[moment.grains.find(contact.first).value()];
    Vec<2> end = first.position - contact.normal * first.radius;
    if (contact.second >= 0) {
      const auto& second = moment.grains->line[moment.grains.find(contact.second).value()];
      end = first.position - separation(first.position, second.position, box);
    }
    const auto point = static_cast<std::int64_t>(data.points.size() / 3);
    data.lines.insert(data.lines.end(), {point, point + 1});
    data.points.insert(data.points.end(), {first.position[0], first.position[1], 0.0, end[0], end[1], 0.0});
    const auto on_first = force_of(contact);
    force.insert(force.end(), {on_first[0], on_first[1], 0.0});
    normal_force.push_back(contact.normal_force);
    tangential_force.push_back(contact.tangential_force);
    overlap.push_back(contact.overlap);
    partners.insert(partners.end(), {contact.first, contact.second});
    sliding.push_back(contact.sliding ? 1 : 0);
  }
  if (!forces) {
    data.cell_data = {{"grains", 2, partners}, {"overlap", 1, overlap}};
    return data;
  }
  data.cell_data = {
      {"grains", 2, partners}, {"normal_force", 1, normal_force}, {"tangential_force", 1, tangential_force},
      {"force", 3, force},     {"overlap", 1, overlap},           {"sliding", 1, sliding}};
  // The filter Tube takes its radius from points.
  const auto twice = [](const std::vector<double>& values) {
    std::vector<double> both;
    for (const double value : values) both.insert(both.end(), {value, value});
    return both;
  };
  data.point_data = {{"normal_force", 1, twice(normal_force)},
                     {"tangential_force", 1, twice(tangential_force)},
                     {"overlap", 1, twice(overlap)}};
  return data;
}

VtkPolyData walls_for_vtk(const std::vector<WallLine>& walls) {
  VtkPolyData data;
  data.vertices = false;
  std::vector<std::int64_t> numbers;
  for (const auto& wall : walls) {
    const auto point = static_cast<std::int64_t>(data.points.size() / 3);
    data.lines.insert(data.lines.end(), {point, point + 1});
    for (const auto& end : {wall.from, wall.to}) data.points.insert(data.points.end(), {end[0], end[1], 0.0});
    numbers.push_back(wall.number);
  }
  data.cell_data = {{"wall", 1, numbers}};
  return data;
}

void add_grains_for_lammps(WholeFile& file, const Moment& moment, const Box<2>& box) {
  const auto& grains = *moment.grains;
  print_header(file, moment, box, "ATOMS", grains.size());
  const bool with_stress = !moment.stress.empty();
  file.print("ITEM: ATOMS id type x y z vx vy vz omegaz radius mass fixed base{}\n",
             with_stress ? " stress_xx stress_xy stress_yx stress_yy stress_area" : "");
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    // LAMMPS numbers atoms and types from 1.
    file.print("{} {} {} {} 0 {} {} 0 {} {} {} {} {}", grains.id[k] + 1, grains.material[k] + 1, grain.position[0],
               grain.position[1], grain.velocity[0], grain.velocity[1], grain.rim_velocity / grain.radius, grain.radius,
               grain.mass, grain.fixed() ? 1 : 0, grains.base[k]);
    if (with_stress) {
      for (const double component : moment.stress[k]) file.print(" {}", component);
      file.print(" {}", moment.area[k]);
    }
    file.print("\n");
  }
}

void add_contacts_for_lammps(WholeFile& file, const Moment& moment, const Box<2>& box) {
  const auto between_grains = [](const auto& contact) { return contact.second >= 0; };
  const auto& list = moment.contacts.list;
  const auto count = static_cast<std::size_t>(std::count_if(list.begin(), list.end(), between_grains));
  print_header(file, moment, box, "ENTRIES", count);
  file.print("ITEM: ENTRIES index batom1 batom2 force tangential overlap sliding Width\n");
  double mean = 0.0;
  for (const auto& contact : list) mean += between_grains(contact) ? std::fabs(contact.normal_force) : 0.0;
  mean /= static_cast<double>(std::max<std::size_t>(count, 1));
  std::size_t index = 0;
  for (const auto& contact : list) {
    if (!between_grains(contact)) continue;
    const double radius = moment.grains->line[moment.grains.find(contact.first).value()].radius;
    const double width = mean > 0.0 ? width_at_mean * radius * std::fabs(contact.normal_force) / mean : 0.0;
    file.print("{} {} {} {} {} {} {} {}\n", ++index, contact.first + 1, contact.second + 1, contact.normal_force,
               contact.tangential_force, contact.overlap, contact.sliding ? 1 : 0, width);
  }
}

}  // namespace repose
