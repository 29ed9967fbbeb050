// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/state.hpp"

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
void write_grains(Hdf5File& file, const Grains<D>& grains) {
  std::vector<std::int64_t> id;
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> spin;
  std::vector<double> radius;
  std::vector<double> mass;
  std::vector<std::uint8_t> fixed;
  std::vector<std::uint8_t> base;
  std::vector<std::uint16_t> material;
  for (const auto k : by_id(grains)) {
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
  std::vector<double> normal_force;
  std::vector<double> tangential_force;
  std::vector<double> history;
  std::vector<std::uint8_t> sliding;
  for (const auto& contact : contacts.list) {
    partners.push_back(contact.first);
    partners.push_back(contact.second);
    append(normal, contact.normal);
    overlap.push_back(contact.overlap);
    normal_force.push_back(contact.normal_force);
    append(tangential_force, contact.tangential_force);
    append(history, contact.history);
    sliding.push_back(contact.sliding ? 1 : 0);
  }
  file.group("contacts");
  file.dataset("contacts/grains", partners, 2, "", "ids of the partners; second = -1 - k means plane k");
  file.dataset("contacts/normal", normal, D, "", "unit vector from the second to the first");
  file.dataset("contacts/overlap", overlap, 1, "L", "mean diameter less distance");
  file.dataset("contacts/normal_force", normal_force, 1, "M L/T^2", "on the first, positive pushes apart");
  file.dataset("contacts/tangential_force", tangential_force, tangent_columns<D>, "M L/T^2",
               "on the first, along the normal turned by +90 degrees");
  file.dataset("contacts/history", history, tangent_columns<D>, "L", "accumulated tangential displacement");
  file.dataset("contacts/sliding", sliding, 1, "", "1: at the Coulomb limit");
}

template void write_grains(Hdf5File&, const Grains<2>&);
template void write_contacts(Hdf5File&, const Contacts<2>&);

}  // namespace repose
