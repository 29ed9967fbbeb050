// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/state.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/hash.hpp"

#include <fmt/format.h>

#include <cmath>
#include <tuple>

namespace repose {

namespace {

/// The meaning of a column in the plane or in space.
template <int D>
std::string meaning(const char* in_the_plane, const char* in_space) {
  return D == 2 ? in_the_plane : in_space;
}

/// The numbers of a vector, or the one of a spin or tangent in the plane, in their order.
template <int D, class Use>
void for_each_number(const Vec<D>& vector, const Use& use) {
  for (int k = 0; k < D; ++k) use(double{vector[k]});
}
template <class Use>
void for_each_number(double number, const Use& use) {
  use(number);
}

}  // namespace

template <int D>
const Columns<std::vector<GrainState<D>>>& grain_state_columns() {
  using Row = GrainState<D>;
  static const Columns<std::vector<Row>> columns{
      column("id", &Row::id, "", "stable id; base grains come first"),
      column("position", &Row::position, "L", "centre"),
      column("velocity", &Row::velocity, "L/T",
             "half a step before the stated time; at it where velocities are synchronised"),
      column("spin", &Row::spin, "1/T",
             meaning<D>("angular velocity, counter-clockwise", "angular velocity, along its axis")),
      column("radius", &Row::radius, "L", "radius"),
      column("mass", &Row::mass, "M", "nominal mass, of fixed grains too"),
      column("fixed", &Row::fixed, "", "1: never moves nor turns"),
      column("base", &Row::base, "", "1: belongs to the base"),
      column("material", &Row::material, "", "material number"),
  };
  return columns;
}

template <int D>
const Columns<std::vector<Contact<D>>>& contact_columns() {
  using Row = Contact<D>;
  static const Columns<std::vector<Row>> columns{
      column<Row>(
          "grains", [](auto& row) { return std::tie(row.first, row.second); }, "",
          "ids of the partners; second = -1 - k means wall k"),
      column("normal", &Row::normal, "", "unit vector from the second to the first"),
      column("overlap", &Row::overlap, "L", "mean diameter less distance; negative in the tail of the continuous law"),
      column("relative_overlap", &Row::relative_overlap, "", "overlap over the mean diameter of the pair"),
      column("lever", &Row::first_lever, "L", "from the centre of the first to the contact point"),
      optional(column("normal_force", &Row::normal_force, "M L/T^2", "on the first, positive pushes apart")),
      optional(column(
          "tangential_force", &Row::tangential_force, "M L/T^2",
          meaning<D>("on the first, along the normal turned by +90 degrees", "on the first, in the tangent plane"))),
      optional(column("history", &Row::slip, "L",
                      "slip displacement: the relative tangential displacement since the contact closed, kept within "
                      "the Coulomb limit")),
      optional(column("rolling", &Row::rolling, "M L/T^2",
                      meaning<D>("rolling torque on the first over the roll radius 2 r_i r_j / (r_i + r_j)",
                                 "torque on the first that resists rolling, and along the normal twisting, over the "
                                 "roll radius 2 r_i r_j / (r_i + r_j)"))),
      optional(column("sliding", &Row::sliding, "", "1: at the Coulomb limit")),
  };
  return columns;
}

template <int D>
void write_grains(Hdf5File& file, const OrderedGrains<D>& grains) {
  constexpr std::size_t most = 65536;
  file.group("grains");
  write_columns_in_blocks(file, "grains", grain_state_columns<D>(), grains.size(), [&](const auto& use) {
    std::vector<GrainState<D>> rows;
    for (std::size_t k = 0; k < grains.size(); ++k) {
      if (rows.size() == most) {
        use(rows);
        rows.clear();
      }
      const auto& grain = grains->line[k];
      rows.push_back({grains->id[k], grain.position, grain.velocity, grain.rim_velocity * (1.0 / grain.radius),
                      grain.radius, grain.mass, grain.fixed(), grains->base[k] != 0, grains->material[k]});
    }
    use(rows);
  });
}

template <int D>
void write_contacts(Hdf5File& file, const ContactBlocks<D>& contacts, const OrderedGrains<D>& grains, bool forces) {
  auto columns = contact_columns<D>();
  if (!forces) std::erase_if(columns, [](const auto& column) { return column.optional; });
  const auto point = [&](const Contact<D>& contact) {
    return Vec<D>(grains->line[grains.find(contact.first).value()].position - contact.normal * contact.first_lever);
  };
  columns.push_back(column<Contact<D>>("point", point, "L", "where the contact is, beside its first partner"));
  file.group("contacts");
  write_columns_in_blocks(file, "contacts", columns, contacts.size, contacts.for_each);
}

template <int D>
Grains<D> read_grains(const Hdf5Reader& file) {
  std::vector<GrainState<D>> rows;
  read_columns(file, "grains", grain_state_columns<D>(), rows);
  Grains<D> grains;
  grains.reserve(rows.size());
  constexpr double farthest = 1e15;  // times its radius: cells of a grid up to there can be counted
  for (const auto& row : rows) {
    bool sound = std::isfinite(row.radius) && row.radius > 0.0 && std::isfinite(row.mass) && row.mass > 0.0;
    for (int k = 0; k < D; ++k) sound = sound && std::fabs(row.position[k]) < farthest * row.radius;
    if (!sound) {
      throw InputError(fmt::format("{}: grains: {} has no place, or no radius and mass > 0", file.path(), row.id));
    }
    Grain<D> grain;
    grain.position = row.position;
    grain.velocity = row.velocity;
    grain.radius = row.radius;
    grain.rim_velocity = row.spin * row.radius;
    grain.mass = row.mass;
    grain.inverse_mass = row.fixed ? 0.0 : 1.0 / row.mass;
    grains.add(grain, row.id, row.base, row.material);
  }
  return grains;
}

template <int D>
Contacts<D> read_contacts(const Hdf5Reader& file) {
  Contacts<D> contacts;
  read_columns(file, "contacts", contact_columns<D>(), contacts.list);
  return contacts;
}

std::int64_t dimension_of_state(const Hdf5Reader& file) {
  const auto shape = file.shape("grains/position");
  const bool sound = shape.size() == 2 && (shape[1] == 2 || shape[1] == 3);
  if (!sound) throw InputError(fmt::format("{}: grains/position: has neither two nor three columns", file.path()));
  return static_cast<std::int64_t>(shape[1]);
}

template <int D>
std::string state_hash(const Grains<D>& grains, const ContactBlocks<D>& contacts) {
  Hash hash;
  const auto add = [&](const auto& value) { hash.add(&value, sizeof value); };
  hash.add(grains.id);
  for (const auto& grain : grains.line) {
    for_each_number(grain.position, add);
    for_each_number(grain.velocity, add);
    for_each_number(grain.rim_velocity, add);
    add(grain.radius);
    add(grain.mass);
  }
  for (const auto& half : grains.half_step) {
    for_each_number(half.velocity, add);
    for_each_number(half.rim_velocity, add);
  }
  contacts.for_each([&](const auto& block) {
    for (const auto& contact : block) {
      add(contact.first);
      add(contact.second);
      for_each_number(contact.slip, add);
    }
  });
  return hash.text();
}

template const Columns<std::vector<GrainState<2>>>& grain_state_columns();
template const Columns<std::vector<Contact<2>>>& contact_columns();
template void write_grains(Hdf5File&, const OrderedGrains<2>&);
template void write_contacts(Hdf5File&, const ContactBlocks<2>&, const OrderedGrains<2>&, bool);
template Grains<2> read_grains(const Hdf5Reader&);
template Contacts<2> read_contacts(const Hdf5Reader&);
template std::string state_hash(const Grains<2>&, const ContactBlocks<2>&);
template const Columns<std::vector<GrainState<3>>>& grain_state_columns();
template const Columns<std::vector<Contact<3>>>& contact_columns();
template void write_grains(Hdf5File&, const OrderedGrains<3>&);
template void write_contacts(Hdf5File&, const ContactBlocks<3>&, const OrderedGrains<3>&, bool);
template Grains<3> read_grains(const Hdf5Reader&);
template Contacts<3> read_contacts(const Hdf5Reader&);
template std::string state_hash(const Grains<3>&, const ContactBlocks<3>&);

}  // namespace repose
