// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/contact_problem/contact_problem.hpp"
#include "repose/contact_problem/contact_problem_checks.hpp"
#include "repose/contact_problem/contact_problem_groups.hpp"
#include "repose/core/errors.hpp"
#include "repose/core/version.hpp"
#include "repose/methods/contact_dynamics/residual.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace repose {

namespace {

constexpr auto format = "repose-contact-problem";
constexpr std::int64_t format_version = 1;

std::vector<BodyRow> bodies_of(const ContactProblem& posed) {
  constexpr auto infinity = std::numeric_limits<double>::infinity();
  std::vector<BodyRow> rows;
  for (std::size_t k = 0; k < posed.problem.free.size(); ++k) {
    const auto& body = posed.problem.free[k];
    const auto& place = posed.places[k];
    BodyRow row;
    row.id = place.id;
    row.mass = body.inverse_mass > 0.0 ? 1.0 / body.inverse_mass : infinity;
    row.inertia = std::isinf(row.mass) ? infinity : row.mass * place.radius * place.radius / inverse_inertia_factor<2>;
    row.radius = place.radius;
    row.position = place.position;
    const double spin = place.radius > 0.0 ? body.rim_velocity / place.radius : 0.0;
    row.free_velocity = {body.velocity[0], body.velocity[1], spin};
    rows.push_back(row);
  }
  return rows;
}

std::vector<ContactRow> contacts_of(const ContactProblem& posed) {
  std::vector<ContactRow> rows;
  for (const auto& c : posed.problem.contacts) {
    const double first_radius = posed.places[c.first].radius;
    ContactRow row;
    row.first = c.first;
    row.second = c.second;
    row.normal = c.normal;
    row.arms = {c.lever * first_radius, c.lever * posed.places[c.second].radius};
    row.roll_radius = c.first_turn * first_radius;
    row.normal_bias = c.normal_bias;
    row.tangential_bias = c.tangent_bias;
    row.friction = c.friction;
    row.rolling_friction = c.rolling_friction;
    row.impulse = {c.impulse.normal, c.impulse.tangent, c.impulse.roll};
    rows.push_back(row);
  }
  return rows;
}

contact_dynamics::Problem<2> problem_of(const std::vector<BodyRow>& bodies, const std::vector<ContactRow>& contacts) {
  contact_dynamics::Problem<2> problem;
  for (const auto& row : bodies) {
    const auto& velocity = row.free_velocity;
    problem.free.push_back({{{velocity[0], velocity[1]}}, velocity[2] * row.radius, 1.0 / row.mass});
  }
  problem.rolling = false;
  for (const auto& row : contacts) {
    contact_dynamics::ContactLine<2> c;
    c.first = static_cast<std::uint32_t>(row.first);
    c.second = static_cast<std::uint32_t>(row.second);
    c.normal = row.normal;
    c.impulse = {row.impulse[0], row.impulse[1], row.impulse[2]};
    c.normal_bias = row.normal_bias;
    c.tangent_bias = row.tangential_bias;
    c.friction = row.friction;
    c.rolling_friction = row.rolling_friction;
    c.lever = row.arms[0] / bodies[c.first].radius;
    c.first_turn = row.roll_radius / bodies[c.first].radius;
    set_masses(c, problem.free[c.first].inverse_mass, problem.free[c.second].inverse_mass);
    problem.rolling |= c.rolling_friction > 0.0;
    problem.contacts.push_back(c);
  }
  return problem;
}

/// Collects what a file lacks, so that all of it is reported at once.
class Attempts {
 public:
  std::vector<std::string> problems;

  template <class Action>
  void attempt(const Action& action) {
    try {
      action();
    } catch (const InputError& problem) {
      problems.insert(problems.end(), problem.problems().begin(), problem.problems().end());
    }
  }

  /// Reads a table, which has as many rows as its column `decisive`.
  template <class Row>
  void read(const Hdf5Reader& file, const Group<std::vector<Row>>& group, const std::string& decisive,
            std::vector<Row>& rows) {
    const auto shape = file.shape(group.name + "/" + decisive);
    rows.resize(shape.empty() ? 0 : shape[0]);
    for (const auto& column : group.columns) {
      const auto path = group.name + "/" + column.name;
      attempt([&] {
        const auto wanted = rows.size();
        const auto count = column.read(file, path, rows);
        if (shape.empty() || count == wanted) return;
        throw InputError(fmt::format("{}: {}: has {} rows where {}/{} has {}", file.path(), path, count, group.name,
                                     decisive, wanted));
      });
    }
  }
};

}  // namespace

void write_contact_problem(const std::string& path, const ContactProblem& posed) {
  Hdf5File file(path);
  file.attribute("/", "format", std::string(format));
  file.attribute("/", "format_version", format_version);
  file.attribute("/", "repose_version", std::string(version));
  file.attribute("/", "dimension", std::int64_t{2});
  file.attribute("/", "title", posed.title);
  file.attribute("/", "time", posed.time);
  file.attribute("/", "time_step", posed.time_step);
  file.attribute("/", "velocity_scale", contact_dynamics::velocity_scale(posed.problem));
  write_group(file, body_group(), bodies_of(posed));
  write_group(file, contact_group(), contacts_of(posed));
  file.commit();
}

ContactProblem read_contact_problem(const std::string& path) {
  const Hdf5Reader file(path, Sealing::optional);
  if (file.text_or("/", "format", "") != format || file.integer("/", "format_version") != format_version) {
    throw InputError(fmt::format("{}: is no contact problem of this version of Repose", path));
  }
  ContactProblem posed;
  Attempts attempts;
  double scale = 0.0;
  attempts.attempt([&] { posed.title = file.text_or("/", "title", ""); });
  attempts.attempt([&] { posed.time = file.number("/", "time"); });
  attempts.attempt([&] { posed.time_step = file.number("/", "time_step"); });
  attempts.attempt([&] {
    scale = file.number("/", "velocity_scale");
    if (!(scale > 0.0 && std::isfinite(scale))) {
      throw InputError(fmt::format("{}: velocity_scale: must be > 0", path));
    }
  });
  std::vector<BodyRow> bodies;
  std::vector<ContactRow> contacts;
  attempts.read(file, body_group(), "mass", bodies);
  attempts.read(file, contact_group(), "friction", contacts);
  if (attempts.problems.empty()) attempts.problems = contact_problem_mistakes(path, bodies, contacts);
  if (!attempts.problems.empty()) throw InputError(attempts.problems);
  posed.problem = problem_of(bodies, contacts);
  posed.problem.velocity_scale = scale;
  for (const auto& row : bodies) posed.places.push_back({row.id, row.radius, row.position});
  return posed;
}

}  // namespace repose
