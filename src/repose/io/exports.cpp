// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/exports.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

/// The bounds of a snapshot: those of a periodic box where it wraps, otherwise those of the grains.
template <int D>
struct Bounds {
  Vec<D> low{};
  Vec<D> high{};
};
template <int D>
Bounds<D> bounds_of(const Grains<D>& grains, const Box<D>& box) {
  Bounds<D> bounds;
  for (int axis = 0; axis < D; ++axis) {
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
  if constexpr (D == 3) {
    if (box.periodic_y) {
      bounds.low[1] = box.y_min;
      bounds.high[1] = box.y_max;
    }
  }
  return bounds;
}

/// Three numbers for a vector, of which the third is 0 in the plane.
template <int D>
void add_vector(std::vector<double>& values, const Vec<D>& vector) {
  values.push_back(vector[0]);
  values.push_back(vector[1]);
  values.push_back(D == 3 ? double{vector[D - 1]} : 0.0);
}

/// A spin or tangent: one number in the plane, three in space.
template <int D>
constexpr std::size_t spin_width = D == 2 ? 1 : 3;
void add_spin(std::vector<double>& values, double number) { values.push_back(number); }
void add_spin(std::vector<double>& values, const Vec<3>& vector) { add_vector(values, vector); }

double spin_of(const Grain<2>& grain) { return grain.rim_velocity / grain.radius; }
Vec<3> spin_of(const Grain<3>& grain) {
  const auto& rim = grain.rim_velocity;
  return {{rim[0] / grain.radius, rim[1] / grain.radius, rim[2] / grain.radius}};
}

double signed_size(double tangent) { return tangent; }
double signed_size(const Vec<3>& tangent) { return magnitude(tangent); }

/// The components of a tensor in the plane, row by row, with those of the third axis, which are 0.
std::array<double, 9> in_three(const std::array<double, 4>& s) {
  return {s[0], s[1], 0.0, s[2], s[3], 0.0, 0.0, 0.0, 0.0};
}
std::array<double, 9> in_three(const std::array<double, 9>& s) { return s; }

/// Radii of a grain that a bond with the mean force is wide.
constexpr double width_at_mean = 0.3;

// All numbers are printed with the fewest digits that read back as the same bits.

void print_sides(WholeFile& file, const Box<2>& box) {
  file.print("ITEM: BOX BOUNDS {} ff pp\n", box.periodic ? "pp" : "ff");
}
void print_sides(WholeFile& file, const Box<3>& box) {
  file.print("ITEM: BOX BOUNDS {} {} ff\n", box.periodic ? "pp" : "ff", box.periodic_y ? "pp" : "ff");
}

template <int D>
void print_header(WholeFile& file, const Moment<D>& moment, const Box<D>& box, const char* what, std::size_t count) {
  const auto bounds = bounds_of(*moment.grains, box);
  file.print("ITEM: TIME\n{}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\n", moment.time, moment.step, what, count);
  print_sides(file, box);
  for (int axis = 0; axis < D; ++axis) file.print("{} {}\n", double{bounds.low[axis]}, double{bounds.high[axis]});
  if (D == 2) file.print("-0.5 0.5\n");
}

void print_motion(WholeFile& file, const Grain<2>& grain) {
  file.print("{} {} 0 {} {} 0 {}", grain.position[0], grain.position[1], grain.velocity[0], grain.velocity[1],
             spin_of(grain));
}
void print_motion(WholeFile& file, const Grain<3>& grain) {
  const auto spin = spin_of(grain);
  file.print("{} {} {} {} {} {} {} {} {}", grain.position[0], grain.position[1], grain.position[2], grain.velocity[0],
             grain.velocity[1], grain.velocity[2], spin[0], spin[1], spin[2]);
}

/// The names of the columns of a stress.
template <int D>
std::string stress_names() {
  std::string names;
  for (int a = 0; a < D; ++a) {
    for (int b = 0; b < D; ++b) names += fmt::format(" stress_{}{}", "xyz"[a], "xyz"[b]);
  }
  return names + (D == 2 ? " stress_area" : " stress_volume");
}

}  // namespace

template <int D>
VtkPolyData grains_for_vtk(const Moment<D>& moment) {
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
    add_vector(data.points, grain.position);
    add_vector(velocity, grain.velocity);
    radius.push_back(grain.radius);
    diameter.push_back(2.0 * grain.radius);
    mass.push_back(grain.mass);
    add_spin(spin, spin_of(grain));
    energy.push_back(grain.fixed() ? 0.0 : kinetic_energy(grain));
    material.push_back(grains.material[k]);
    fixed.push_back(grain.fixed() ? 1 : 0);
    base.push_back(grains.base[k]);
  }
  data.point_data = {
      {"id", 1, grains.id},      {"diameter", 1, diameter},     {"radius", 1, radius},        {"mass", 1, mass},
      {"velocity", 3, velocity}, {"spin", spin_width<D>, spin}, {"fixed", 1, fixed},          {"base", 1, base},
      {"material", 1, material}, {"contacts", 1, coordination}, {"kinetic_energy", 1, energy}};
  if (moment.stress.empty()) return data;
  std::vector<double> stress;
  for (const auto& of_grain : moment.stress) {
    for (const double component : in_three(of_grain)) stress.push_back(component);
  }
  data.point_data.push_back({"stress", 9, stress});
  data.point_data.push_back({D == 2 ? "stress_area" : "stress_volume", 1, moment.extent});
  return data;
}

template <int D>
VtkPolyData contacts_for_vtk(const Moment<D>& moment, const Box<D>& box, bool forces) {
  VtkPolyData data;
  data.vertices = false;
  std::vector<double> normal_force, tangential_force, overlap, force;
  std::vector<std::int64_t> partners;
  std::vector<std::uint8_t> sliding;
  for (const auto& contact : moment.contacts.list) {
    const auto& first = moment.grains->line[moment.grains.find(contact.first).value()];
    Vec<D> end = first.position - contact.normal * first.radius;
    if (contact.second >= 0) {
      const auto& second = moment.grains->line[moment.grains.find(contact.second).value()];
      end = first.position - separation(first.position, second.position, box);
    }
    const auto point = static_cast<std::int64_t>(data.points.size() / 3);
    data.lines.insert(data.lines.end(), {point, point + 1});
    add_vector(data.points, first.position);
    add_vector(data.points, end);
    add_vector(force, force_of(contact));
    normal_force.push_back(contact.normal_force);
    add_spin(tangential_force, contact.tangential_force);
    overlap.push_back(contact.overlap);
    partners.insert(partners.end(), {contact.first, contact.second});
    sliding.push_back(contact.sliding ? 1 : 0);
  }
  if (!forces) {
    data.cell_data = {{"grains", 2, partners}, {"overlap", 1, overlap}};
    return data;
  }
  data.cell_data = {
      {"grains", 2, partners}, {"normal_force", 1, normal_force}, {"tangential_force", spin_width<D>, tangential_force},
      {"force", 3, force},     {"overlap", 1, overlap},           {"sliding", 1, sliding}};
  // The filter Tube takes its radius from points.
  const auto twice = [](const std::vector<double>& values, std::size_t width = 1) {
    std::vector<double> both;
    for (std::size_t k = 0; k < values.size(); k += width) {
      for (int end = 0; end < 2; ++end) both.insert(both.end(), &values[k], &values[k] + width);
    }
    return both;
  };
  data.point_data = {{"normal_force", 1, twice(normal_force)},
                     {"tangential_force", spin_width<D>, twice(tangential_force, spin_width<D>)},
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

VtkPolyData walls_for_vtk(const std::vector<WallSurface>& walls) {
  VtkPolyData data;
  data.vertices = false;
  std::vector<std::int64_t> numbers;
  for (const auto& wall : walls) {
    const auto first = data.points.size() / 3;
    for (const auto& point : wall.points) add_vector(data.points, point);
    for (const auto& triangle : wall.triangles) {
      for (const auto corner : triangle) data.triangles.push_back(static_cast<std::int64_t>(first + corner));
      numbers.push_back(wall.number);
    }
  }
  data.cell_data = {{"wall", 1, numbers}};
  return data;
}

template <int D>
void add_grains_for_lammps(WholeFile& file, const Moment<D>& moment, const Box<D>& box) {
  const auto& grains = *moment.grains;
  print_header(file, moment, box, "ATOMS", grains.size());
  const bool with_stress = !moment.stress.empty();
  file.print("ITEM: ATOMS id type x y z vx vy vz {} radius mass fixed base{}\n",
             D == 2 ? "omegaz" : "omegax omegay omegaz", with_stress ? stress_names<D>() : "");
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    // LAMMPS numbers atoms and types from 1.
    file.print("{} {} ", grains.id[k] + 1, grains.material[k] + 1);
    print_motion(file, grain);
    file.print(" {} {} {} {}", grain.radius, grain.mass, grain.fixed() ? 1 : 0, grains.base[k]);
    if (with_stress) {
      for (const double component : moment.stress[k]) file.print(" {}", component);
      file.print(" {}", moment.extent[k]);
    }
    file.print("\n");
  }
}

template <int D>
void add_contacts_for_lammps(WholeFile& file, const Moment<D>& moment, const Box<D>& box) {
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
               signed_size(contact.tangential_force), contact.overlap, contact.sliding ? 1 : 0, width);
  }
}

template VtkPolyData grains_for_vtk(const Moment<2>&);
template VtkPolyData contacts_for_vtk(const Moment<2>&, const Box<2>&, bool);
template void add_grains_for_lammps(WholeFile&, const Moment<2>&, const Box<2>&);
template void add_contacts_for_lammps(WholeFile&, const Moment<2>&, const Box<2>&);
template VtkPolyData grains_for_vtk(const Moment<3>&);
template VtkPolyData contacts_for_vtk(const Moment<3>&, const Box<3>&, bool);
template void add_grains_for_lammps(WholeFile&, const Moment<3>&, const Box<3>&);
template void add_contacts_for_lammps(WholeFile&, const Moment<3>&, const Box<3>&);

}  // namespace repose
