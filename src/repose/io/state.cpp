// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/state.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/hash.hpp"

namespace repose {

namespace {

void append(std::vector<double>& values, double x) { values.push_back(x); }
template <int D>
void append(std::vector<double>& values, const Vec<D>& x) {
  for (int k = 0; k < D; ++k) values.push_back(x[k]);
}

template <int D>
constexpr std::size_t tangent_columns = D == 2 ? 1 : 3;

}  // namespace

template <int D>
void write_grains(Hdf5File& file, const OrderedGrains<D>& ordered) {
  const auto& grains = *ordered;
  std::vector<std::int64_t> id;
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> spin;
  std::vector<double> radius;
  std::vector<double> mass;
  std::vector<std::uint8_t> fixed;
  std::vector<std::uint8_t> base;
  std::vector<std::uint16_t> material;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    id.push_back(grains.id[k]);
    append(position, grain.position);
    append(velocity, grain.velocity);
    append(spin, grain.rim_velocity * (1.0 / grain.radius));
    radius.push_back(grain.radius);
    mass.push_back(grain.mass);
    fixed.push_back(grain.fixed() ? 1 : 0);
    base.push_back(grains.base[k]);
    material.push_back(grains.material[k]);
  }
  file.group("grains");
  file.dataset("grains/id", id, 1, "", "stable id");
  file.dataset("grains/position", position, D, "L", "centre");
  file.dataset("grains/velocity", velocity, D, "L/T",
               "half a step before the stated time; at it where velocities are synchronised");
  file.dataset("grains/spin", spin, tangent_columns<D>, "1/T", "angular velocity, counter-clockwise");
  file.dataset("grains/radius", radius, 1, "L", "radius");
  file.dataset("grains/mass", mass, 1, "M", "nominal mass, of fixed grains too");
  file.dataset("grains/fixed", fixed, 1, "", "1: never moves nor turns");
  file.dataset("grains/base", base, 1, "", "1: belongs to the base");
  file.dataset("grains/material", material, 1, "", "material number");
}

template <int D>
void write_contacts(Hdf5File& file, const Contacts<D>& contacts) {
  std::vector<std::int64_t> partners;
  std::vector<double> normal;
  std::vector<double> overlap;
  std::vector<double> relative_overlap;
  std::vector<double> lever;
  std::vector<double> normal_force;
  std::vector<double> tangential_force;
  std::vector<double> history;
  std::vector<std::uint8_t> sliding;
  for (const auto& contact : contacts.list) {
    partners.push_back(contact.first);
    partners.push_back(contact.second);
    append(normal, contact.normal);
    overlap.push_back(contact.overlap);
    relative_overlap.push_back(contact.relative_overlap);
    lever.push_back(contact.first_lever);
    normal_force.push_back(contact.normal_force);
    append(tangential_force, contact.tangential_force);
    append(history, contact.history);
    sliding.push_back(contact.sliding ? 1 : 0);
  }
  file.group("contacts");
  file.dataset("contacts/grains", partners, 2, "", "ids of the partners; second = -1 - k means wall k");
  file.dataset("contacts/normal", normal, D, "", "unit vector from the second to the first");
  file.dataset("contacts/overlap", overlap, 1, "L", "mean diameter less distance");
  file.dataset("contacts/relative_overlap", relative_overlap, 1, "", "overlap over the mean diameter of the pair");
  file.dataset("contacts/lever", lever, 1, "L", "from the centre of the first to the contact point");
  file.dataset("contacts/normal_force", normal_force, 1, "M L/T^2", "on the first, positive pushes apart");
  file.dataset("contacts/tangential_force", tangential_force, tangent_columns<D>, "M L/T^2",
               "on the first, along the normal turned by +90 degrees");
  file.dataset("contacts/history", history, tangent_columns<D>, "L", "accumulated tangential displacement");
  file.dataset("contacts/sliding", sliding, 1, "", "1: at the Coulomb limit");
}

namespace {

template <int D>
Vec<D> vector_at(const std::vector<double>& values, std::size_t k) {
  Vec<D> x;
  for (int m = 0; m < D; ++m) x[m] = values[k * D + static_cast<std::size_t>(m)];
  return x;
}

}  // namespace

template <>
Grains<2> read_grains(const Hdf5Reader& file) {
  const auto id = file.dataset<std::int64_t>("grains/id");
  const auto position = file.dataset<double>("grains/position", 2);
  const auto velocity = file.dataset<double>("grains/velocity", 2);
  const auto spin = file.dataset<double>("grains/spin");
  const auto radius = file.dataset<double>("grains/radius");
  const auto mass = file.dataset<double>("grains/mass");
  const auto fixed = file.dataset<std::uint8_t>("grains/fixed");
  const auto base = file.dataset<std::uint8_t>("grains/base");
  const auto material = file.dataset<std::uint16_t>("grains/material");
  const auto n = id.size();
  for (const auto size : {position.size() / 2, velocity.size() / 2, spin.size(), radius.size(), mass.size(),
                          fixed.size(), base.size(), material.size()}) {
    if (size != n) throw InputError(file.path() + ": grains: the datasets differ in length");
  }
  Grains<2> grains;
  for (std::size_t k = 0; k < n; ++k) {
    Grain<2> grain;
    grain.position = vector_at<2>(position, k);
    grain.velocity = vector_at<2>(velocity, k);
    grain.radius = radius[k];
    grain.rim_velocity = spin[k] * radius[k];
    grain.mass = mass[k];
    grain.inverse_mass = fixed[k] != 0 ? 0.0 : 1.0 / mass[k];
    grains.add(grain, id[k], base[k] != 0, material[k]);
  }
  return grains;
}

template <>
Contacts<2> read_contacts(const Hdf5Reader& file) {
  const auto partners = file.dataset<std::int64_t>("contacts/grains", 2);
  const auto normal = file.dataset<double>("contacts/normal", 2);
  const auto overlap = file.dataset<double>("contacts/overlap");
  const auto relative_overlap = file.dataset<double>("contacts/relative_overlap");
  const auto lever = file.dataset<double>("contacts/lever");
  const auto normal_force = file.dataset<double>("contacts/normal_force");
  const auto tangential_force = file.dataset<double>("contacts/tangential_force");
  const auto history = file.dataset<double>("contacts/history");
  const auto sliding = file.dataset<std::uint8_t>("contacts/sliding");
  const auto n = overlap.size();
  for (const auto size : {partners.size() / 2, normal.size() / 2, relative_overlap.size(), lever.size(),
                          normal_force.size(), tangential_force.size(), history.size(), sliding.size()}) {
    if (size != n) throw InputError(file.path() + ": contacts: the datasets differ in length");
  }
  Contacts<2> contacts;
  for (std::size_t k = 0; k < n; ++k) {
    contacts.list.push_back({partners[2 * k], partners[2 * k + 1], vector_at<2>(normal, k), overlap[k],
                             relative_overlap[k], normal_force[k], tangential_force[k], history[k], lever[k],
                             sliding[k] != 0});
  }
  return contacts;
}

std::string state_hash(const Grains<2>& grains, const Contacts<2>& contacts) {
  Hash hash;
  const auto add = [&](const auto& value) { hash.add(&value, sizeof value); };
  hash.add(grains.id);
  for (const auto& grain : grains.line) {
    for (const double number : {grain.position[0], grain.position[1], grain.velocity[0], grain.velocity[1],
                                grain.rim_velocity, grain.radius, grain.mass}) {
      add(number);
    }
  }
  for (const auto& half : grains.half_step) {
    for (const double number : {half.velocity[0], half.velocity[1], half.rim_velocity}) add(number);
  }
  for (const auto& contact : contacts.list) {
    add(contact.first);
    add(contact.second);
    add(contact.history);
  }
  return hash.text();
}

template void write_grains(Hdf5File&, const OrderedGrains<2>&);
template void write_contacts(Hdf5File&, const Contacts<2>&);

}  // namespace repose
