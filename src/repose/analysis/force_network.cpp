// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/force_network.hpp"

#include "repose/analysis/principal_axes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <unordered_map>

namespace repose {

namespace {

template <int D>
std::unordered_map<std::int64_t, std::size_t> places(const Grains<D>& grains) {
  std::unordered_map<std::int64_t, std::size_t> place;
  place.reserve(grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k) place.emplace(grains.id[k], k);
  return place;
}

/// The sum of n n over contacts in the plane.
struct PlaneFabric {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;

  void add_square(const Vec<2>& n) {
    xx += n[0] * n[0];
    yy += n[1] * n[1];
    xy += n[0] * n[1];
  }
};

void set_fabric(ForceNetwork& network, const PlaneFabric& sum, double count) {
  const double xx = sum.xx;
  const double yy = sum.yy;
  const double xy = sum.xy;
  network.anisotropy = 2.0 * std::hypot(xx - yy, 2.0 * xy) / count;
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy) * 180.0 / std::numbers::pi;
  network.direction_deg = angle > -90.0 ? angle : 90.0;  // rounding may put a vertical axis at -90
}

void set_fabric(NetworkOfForces<3>& network, SymmetricTensor sum, double count) {
  sum *= 1.0 / count;
  network.anisotropy = deviator(sum);
  network.direction_deg = inclination_deg(principal_axes(sum).axis[0]);
}

}  // namespace

template <int D>
NetworkOfForces<D> measure_force_network(const Grains<D>& grains, const Contacts<D>& contacts,
                                         const std::vector<bool>& in_heap, double threshold) {
  NetworkOfForces<D> network;
  const auto place = places(grains);
  std::vector<std::size_t> partners(grains.size(), 0);
  std::conditional_t<D == 2, PlaneFabric, SymmetricTensor> fabric;
  for (const auto& contact : contacts.list) {
    if (!(std::fabs(contact.normal_force) > threshold)) continue;
    ++network.contacts;
    ++partners[place.at(contact.first)];
    if (contact.second >= 0) ++partners[place.at(contact.second)];
    fabric.add_square(contact.normal);
  }
  std::size_t grains_counted = 0;
  std::size_t ends = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!in_heap[k]) continue;
    ++grains_counted;
    ends += partners[k];
    network.connectivity[std::min(partners[k], most_contacts<D>)] += 1.0;
  }
  if (grains_counted > 0) {
    const auto count = static_cast<double>(grains_counted);
    network.coordination = static_cast<double>(ends) / count;
    for (auto& fraction : network.connectivity) fraction /= count;
  }
  if (network.contacts > 0) set_fabric(network, fabric, static_cast<double>(network.contacts));
  return network;
}

template <int D>
std::vector<Vec<D>> net_forces(const Grains<D>& grains, const Contacts<D>& contacts, const Vec<D>& gravity) {
  const auto place = places(grains);
  std::vector<Vec<D>> net(grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k) net[k] = gravity * grains.line[k].mass;
  for (const auto& contact : contacts.list) {
    const Vec<D> force = force_of(contact);
    net[place.at(contact.first)] += force;
    if (contact.second >= 0) net[place.at(contact.second)] -= force;
  }
  return net;
}

template <int D>
double mean_normal_force(const Contacts<D>& contacts) {
  double sum = 0.0;
  double count = 0.0;
  for (const auto& contact : contacts.list) {
    const double size = std::fabs(contact.normal_force);
    if (!(size > 0.0) || !std::isfinite(size)) continue;
    sum += size;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

template <int D>
double force_residual(const Grains<D>& grains, const Contacts<D>& contacts, const Vec<D>& gravity) {
  const double strength = magnitude(gravity);
  const double mean = strength > 0.0 ? 0.0 : mean_normal_force(contacts);
  if (!(strength > 0.0) && !(mean > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  const auto net = net_forces(grains, contacts, gravity);
  double sum = 0.0;
  double count = 0.0;
  for (const auto k : by_id(grains)) {
    if (grains.line[k].fixed()) continue;
    sum += magnitude(net[k]) / (strength > 0.0 ? grains.line[k].mass * strength : mean);
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

template <int D>
double max_overlap(const Contacts<D>& contacts) {
  double deepest = 0.0;
  for (const auto& contact : contacts.list) deepest = std::max(deepest, contact.relative_overlap);
  return deepest;
}

template ForceNetwork measure_force_network(const Grains<2>&, const Contacts<2>&, const std::vector<bool>&, double);
template NetworkOfForces<3> measure_force_network(const Grains<3>&, const Contacts<3>&, const std::vector<bool>&,
                                                  double);
template std::vector<Vec<2>> net_forces(const Grains<2>&, const Contacts<2>&, const Vec<2>&);
template std::vector<Vec<3>> net_forces(const Grains<3>&, const Contacts<3>&, const Vec<3>&);
template double mean_normal_force(const Contacts<2>&);
template double mean_normal_force(const Contacts<3>&);
template double force_residual(const Grains<2>&, const Contacts<2>&, const Vec<2>&);
template double force_residual(const Grains<3>&, const Contacts<3>&, const Vec<3>&);
template double max_overlap(const Contacts<2>&);
template double max_overlap(const Contacts<3>&);

}  // namespace repose
