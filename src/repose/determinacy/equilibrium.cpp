// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/determinacy/equilibrium.hpp"

#include "repose/laws/impulse_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace repose {

namespace {

using Impulse = contact_dynamics::Impulse<2>;
using Line = contact_dynamics::ContactLine<2>;
using Column = LinearProgramme::Column;
using Entry = LinearProgramme::Entry;

constexpr auto none = std::numeric_limits<std::size_t>::max();

Vec<2> tangent_of(const Vec<2>& normal) { return {{-normal[1], normal[0]}}; }

/// What a force of a contact adds to the rows of one of its bodies: force along x and y, torque over the radius.
std::array<double, 3> on_body(const Line& c, const Impulse& force, bool first) {
  const Vec<2> push = c.normal * force.normal + tangent_of(c.normal) * force.tangent;
  // Both centres lie on opposite sides of the contact point, so that friction turns both the same way.
  const double turn = -c.lever * force.tangent;
  if (first) return {push[0], push[1], turn + c.first_turn * force.roll};
  return {-push[0], -push[1], turn - (2.0 - c.first_turn) * force.roll};
}

}  // namespace

void ForceSum::add(const ForceSum& other, double factor) {
  for (const auto& term : other.terms) terms.push_back({term.contact, factor * term.normal, factor * term.tangent});
}

double ForceSum::operator()(const ContactForces& forces) const {
  double sum = 0.0;
  for (const auto& term : terms) {
    sum += term.normal * forces[term.contact].normal + term.tangent * forces[term.contact].tangent;
  }
  return sum;
}

ForceSum force_on_body(const contact_dynamics::Problem<2>& problem, std::size_t body, const Vec<2>& direction) {
  ForceSum sum;
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
    const auto& c = problem.contacts[k];
    if (c.first == body || c.second == body) sum.terms.push_back(force_on_body(problem, k, body, direction));
  }
  return sum;
}

ForceSum::Term force_on_body(const contact_dynamics::Problem<2>& problem, std::size_t contact, std::size_t body,
                             const Vec<2>& direction) {
  const auto& c = problem.contacts[contact];
  const double side = c.first == body ? 1.0 : -1.0;
  return {contact, side * dot(c.normal, direction), side * dot(tangent_of(c.normal), direction)};
}

Equilibrium::Equilibrium(const EquilibriumInput& input, const ContactForces& recorded) : input_(input) {
  for (const auto contact : input_.touching) add_edges(contact);
  number_rows();
  for (const auto& edge : edges_) {
    columns_.push_back({entries_of(edge), edge.both_ways ? -LinearProgramme::infinity : 0.0});
  }
  take_recorded(recorded);
  const auto miss = missed(recorded_);
  for (std::size_t row = 0; row < load_.size(); ++row) {
    unbalanced_ = std::max(unbalanced_, std::fabs(miss[row]));
    const double slack = std::fabs(miss[row]) + input_.margin;
    rows_.push_back({-load_[row] - slack, -load_[row] + slack});
  }
  programme_ = std::make_unique<LinearProgramme>(columns_, rows_);
}

/// The edges of N >= 0, |T| <= mu N, |S| <= mu_r N. Infinite friction frees a force from the normal one.
void Equilibrium::add_edges(std::size_t contact) {
  const auto& c = input_.problem.contacts[contact];
  unknowns_ += 1 + (c.friction > 0.0 ? 1 : 0) + (c.rolling_friction > 0.0 ? 1 : 0);
  const auto sides = [](double limit) {
    if (limit > 0.0 && std::isfinite(limit)) return std::vector<double>{limit, -limit};
    return std::vector<double>{0.0};
  };
  for (const double tangent : sides(c.friction)) {
    for (const double roll : sides(c.rolling_friction)) edges_.push_back({contact, {1.0, tangent, roll}});
  }
  if (std::isinf(c.friction)) edges_.push_back({contact, {0.0, 1.0, 0.0}, true});
  if (std::isinf(c.rolling_friction)) edges_.push_back({contact, {0.0, 0.0, 1.0}, true});
}

/// Three rows for each grain that moves and touches something. A torque without friction is balanced by itself, and is
/// not counted.
void Equilibrium::number_rows() {
  const auto bodies = input_.problem.free.size();
  first_row_.assign(bodies, none);
  std::vector<char> turned(bodies, 0);
  for (const auto contact : input_.touching) {
    const auto& c = input_.problem.contacts[contact];
    for (const auto body : {c.first, c.second}) {
      if (body >= input_.problem.first_wall || input_.problem.free[body].inverse_mass == 0.0) continue;
      first_row_[body] = 0;
      if (c.friction > 0.0 || c.rolling_friction > 0.0) turned[body] = 1;
    }
  }
  for (std::size_t body = 0; body < bodies; ++body) {
    if (first_row_[body] == none) continue;
    first_row_[body] = load_.size();
    load_.insert(load_.end(), {input_.outer[body][0], input_.outer[body][1], 0.0});
    equations_ += turned[body] ? 3 : 2;
  }
}

std::vector<Entry> Equilibrium::entries_of(const Edge& edge) const {
  std::vector<Entry> entries;
  const auto& c = input_.problem.contacts[edge.contact];
  for (const bool first : {true, false}) {
    const auto row = first_row_[first ? c.first : c.second];
    if (row == none) continue;
    const auto parts = on_body(c, edge.direction, first);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (parts[k] != 0.0) entries.push_back({row + k, parts[k]});
    }
  }
  return entries;
}

/// The net force or torque of each row.
std::vector<double> Equilibrium::missed(const ContactForces& forces) const {
  auto net = load_;
  for (const auto contact : input_.touching) {
    for (const auto& entry : entries_of({contact, forces[contact]})) net[entry.row] += entry.value;
  }
  return net;
}

void Equilibrium::take_recorded(const ContactForces& recorded) {
  recorded_.assign(input_.problem.contacts.size(), {});
  bool rolls = false;
  for (const auto contact : input_.touching) {
    const auto& c = input_.problem.contacts[contact];
    auto& force = recorded_[contact];
    force.normal = std::max(0.0, recorded[contact].normal);
    force.tangent = project(recorded[contact].tangent, friction_limit(c.friction, force.normal));
    rolls |= c.rolling_friction > 0.0;
  }
  if (rolls) find_torques();
}

/// Sets the rolling parts of the recorded forces: within their limits, those with the least sum of net torques.
void Equilibrium::find_torques() {
  const auto net = missed(recorded_);
  std::vector<Column> columns;
  std::vector<double> cost;
  std::vector<std::size_t> contact_of;
  for (const auto contact : input_.touching) {
    const auto& c = input_.problem.contacts[contact];
    const double limit = friction_limit(c.rolling_friction, recorded_[contact].normal);
    if (!(limit > 0.0)) continue;
    columns.push_back({entries_of({contact, {0.0, 0.0, 1.0}}), -limit, limit});
    contact_of.push_back(contact);
    cost.push_back(0.0);
  }
  std::vector<LinearProgramme::Row> rows;
  for (std::size_t row = 0; row < net.size(); ++row) {
    if (row % 3 != 2) {  // a torque moves no centre
      rows.emplace_back();
      continue;
    }
    rows.push_back({-net[row], -net[row]});
    for (const double side : {1.0, -1.0}) {
      columns.push_back({{{row, side}}});
      cost.push_back(1.0);
    }
  }
  const auto found = LinearProgramme(columns, rows).least(cost);
  if (found.end != LinearProgramme::End::found) return;
  for (std::size_t k = 0; k < contact_of.size(); ++k) recorded_[contact_of[k]].roll = found.x[k];
}

std::vector<double> Equilibrium::costs_of(const ForceSum& sum) const {
  std::vector<double> normal(input_.problem.contacts.size()), tangent(input_.problem.contacts.size());
  for (const auto& term : sum.terms) {
    normal[term.contact] += term.normal;
    tangent[term.contact] += term.tangent;
  }
  std::vector<double> costs;
  for (const auto& edge : edges_) {
    costs.push_back(normal[edge.contact] * edge.direction.normal + tangent[edge.contact] * edge.direction.tangent);
  }
  return costs;
}

bool Equilibrium::never_negative(const ForceSum& sum) const {
  const auto costs = costs_of(sum);
  for (std::size_t k = 0; k < costs.size(); ++k) {
    if (costs[k] < 0.0 || (edges_[k].both_ways && costs[k] != 0.0)) return false;
  }
  return true;
}

ContactForces Equilibrium::forces_of(const std::vector<double>& factors) const {
  ContactForces forces(input_.problem.contacts.size());
  for (std::size_t k = 0; k < edges_.size(); ++k) forces[edges_[k].contact] += edges_[k].direction * factors[k];
  return forces;
}

Equilibrium::Extreme Equilibrium::extreme(const ForceSum& sum, bool largest) {
  const auto costs = costs_of(sum);
  const auto found = largest ? programme_->most(costs) : programme_->least(costs);
  if (found.end != LinearProgramme::End::found) return {found.end, 0.0, {}};
  return {found.end, found.value, forces_of(found.x)};
}

/// A further unknown t >= each sum; t is made least.
Equilibrium::Extreme Equilibrium::least_of_largest(const std::vector<ForceSum>& sums) const {
  auto columns = columns_;
  auto rows = rows_;
  Column bound;
  bound.lower = -LinearProgramme::infinity;
  for (const auto& sum : sums) {
    const auto row = rows.size();
    rows.push_back({0.0, LinearProgramme::infinity});
    bound.entries.push_back({row, 1.0});
    const auto costs = costs_of(sum);
    for (std::size_t k = 0; k < costs.size(); ++k) {
      if (costs[k] != 0.0) columns[k].entries.push_back({row, -costs[k]});
    }
  }
  columns.push_back(std::move(bound));
  std::vector<double> cost(columns.size(), 0.0);
  cost.back() = 1.0;
  const auto found = LinearProgramme(columns, rows).least(cost);
  if (found.end != LinearProgramme::End::found) return {found.end, 0.0, {}};
  auto factors = found.x;
  factors.pop_back();
  return {found.end, found.value, forces_of(factors)};
}

}  // namespace repose
