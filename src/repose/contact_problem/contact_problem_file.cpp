// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/contact_problem/contact_problem.hpp"
#include "repose/core/errors.hpp"
#include "repose/core/version.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"
#include "repose/methods/contact_dynamics/residual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace repose {

namespace {

constexpr auto infinity = std::numeric_limits<double>::infinity();
constexpr auto format = "repose-contact-problem";
constexpr std::int64_t format_version = 1;

/// Numbers that go with each other may differ by so much, of their own size.
constexpr double rounding = 1e-9;

/// A file, column by column.
struct Tables {
  std::vector<std::int64_t> id;
  std::vector<double> mass;
  std::vector<double> inertia;
  std::vector<double> radius;
  std::vector<double> position;
  std::vector<double> free_velocity;
  std::vector<std::int64_t> bodies;
  std::vector<double> normal;
  std::vector<double> arms;
  std::vector<double> roll_radius;
  std::vector<double> normal_bias;
  std::vector<double> tangential_bias;
  std::vector<double> friction;
  std::vector<double> rolling_friction;
  std::vector<double> impulse;
};

/// The one list of the tables: `table(name, values, columns, unit, meaning)` writes or reads each.
template <class AnyTables, class Action>
void for_each_table(AnyTables& t, const Action& table) {
  table("bodies/id", t.id, 1, "", "id of the grain; -1 - k: wall k");
  table("bodies/mass", t.mass, 1, "M", "infinite: contacts do not move the body");
  table("bodies/inertia", t.inertia, 1, "M L^2", "moment of inertia, m r^2 / 2 of a disc; infinite as the mass is");
  table("bodies/radius", t.radius, 1, "L", "0 of a wall");
  table("bodies/position", t.position, 2, "L", "centre, or a point of the wall");
  table("bodies/free_velocity", t.free_velocity, 3, "L/T, L/T, 1/T",
        "vx, vy and angular velocity after the step if no contact acted");
  table("contacts/bodies", t.bodies, 2, "", "rows of the first and the second body");
  table("contacts/normal", t.normal, 2, "", "unit normal from the second to the first; the tangent is (-ny, nx)");
  table("contacts/arms", t.arms, 2, "L", "from the centre of the first and of the second to the contact point");
  table("contacts/roll_radius", t.roll_radius, 1, "L", "torque impulse over rolling impulse");
  table("contacts/normal_bias", t.normal_bias, 1, "L/T", "added to the normal velocity after the step");
  table("contacts/tangential_bias", t.tangential_bias, 1, "L/T", "added to the tangential velocity after the step");
  table("contacts/friction", t.friction, 1, "", "tangential over normal impulse at most; may be infinite");
  table("contacts/rolling_friction", t.rolling_friction, 1, "", "rolling over normal impulse at most; may be infinite");
  table("contacts/impulse", t.impulse, 3, "M L/T",
        "normal, tangential and rolling impulse on the first body to start from, those of the step before");
}

Tables tables_of(const ContactProblem& posed) {
  Tables t;
  const auto& problem = posed.problem;
  for (std::size_t k = 0; k < problem.free.size(); ++k) {
    const auto& body = problem.free[k];
    const auto& place = posed.places[k];
    const double mass = body.inverse_mass > 0.0 ? 1.0 / body.inverse_mass : infinity;
    t.id.push_back(place.id);
    t.mass.push_back(mass);
    t.inertia.push_back(std::isinf(mass) ? infinity : mass * place.radius * place.radius / inverse_inertia_factor<2>);
    t.radius.push_back(place.radius);
    t.position.insert(t.position.end(), {place.position[0], place.position[1]});
    const double spin = place.radius > 0.0 ? body.rim_velocity / place.radius : 0.0;
    t.free_velocity.insert(t.free_velocity.end(), {body.velocity[0], body.velocity[1], spin});
  }
  for (const auto& c : problem.contacts) {
    const double first_radius = posed.places[c.first].radius;
    t.bodies.insert(t.bodies.end(), {c.first, c.second});
    t.normal.insert(t.normal.end(), {c.normal[0], c.normal[1]});
    t.arms.insert(t.arms.end(), {c.lever * first_radius, c.lever * posed.places[c.second].radius});
    t.roll_radius.push_back(c.first_turn * first_radius);
    t.normal_bias.push_back(c.normal_bias);
    t.tangential_bias.push_back(c.tangent_bias);
    t.friction.push_back(c.friction);
    t.rolling_friction.push_back(c.rolling_friction);
    t.impulse.insert(t.impulse.end(), {c.impulse.normal, c.impulse.tangent, c.impulse.roll});
  }
  return t;
}

bool near(double a, double b) { return std::fabs(a - b) <= rounding * std::max(std::fabs(a), std::fabs(b)); }

/// Says what is wrong with the tables of a file, of each kind of mistake the first row and how many there are.
class Checks {
 public:
  Checks(const std::string& path, const Tables& tables) : path_(path), t_(tables) {}

  std::vector<std::string> problems() {
    if (!lengths()) return problems_;
    bodies();
    if (contact_bodies()) contacts();
    return problems_;
  }

 private:
  /// `is_wrong(row)` for all rows; `why` is what a right one does.
  template <class IsWrong>
  bool rows(const char* name, std::size_t count, const char* why, const IsWrong& is_wrong) {
    std::size_t wrong = 0;
    std::size_t first = 0;
    for (std::size_t k = count; k-- > 0;) {
      if (!is_wrong(k)) continue;
      first = k;
      ++wrong;
    }
    if (wrong == 0) return true;
    const auto more = wrong > 1 ? fmt::format(" (and {} more rows)", wrong - 1) : std::string();
    problems_.push_back(fmt::format("{}: {}: row {}{}: {}", path_, name, first, more, why));
    return false;
  }

  bool lengths() {
    for_each_table(t_, [&](const std::string& name, const auto& values, std::size_t columns, auto&&...) {
      const bool of_body = name.starts_with("bodies/");
      const auto wanted = of_body ? t_.mass.size() : t_.friction.size();
      if (values.size() == wanted * columns) return;
      problems_.push_back(fmt::format("{}: {}: has {} rows where {} has {}", path_, name, values.size() / columns,
                                      of_body ? "bodies/mass" : "contacts/friction", wanted));
    });
    return problems_.empty();
  }

  void finite(const char* name, const std::vector<double>& values, std::size_t columns) {
    rows(name, values.size() / columns, "must be finite", [&](std::size_t k) {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(k * columns);
      return !std::all_of(begin, begin + static_cast<std::ptrdiff_t>(columns),
                          [](double x) { return std::isfinite(x); });
    });
  }

  void bodies() {
    const auto count = t_.mass.size();
    const auto moves = [&](std::size_t k) { return std::isfinite(t_.mass[k]); };
    rows("bodies/mass", count, "must be > 0", [&](std::size_t k) { return !(t_.mass[k] > 0.0); });
    rows("bodies/radius", count, "must be finite, and > 0 where the mass is finite", [&](std::size_t k) {
      return !std::isfinite(t_.radius[k]) || t_.radius[k] < 0.0 || (moves(k) && t_.radius[k] == 0.0);
    });
    rows("bodies/inertia", count, "must be mass radius^2 / 2, that of a disc, or infinite where the mass is",
         [&](std::size_t k) {
           const double disc = t_.mass[k] * t_.radius[k] * t_.radius[k] / inverse_inertia_factor<2>;
           return moves(k) ? !near(t_.inertia[k], disc) : t_.inertia[k] != infinity;
         });
    finite("bodies/position", t_.position, 2);
    finite("bodies/free_velocity", t_.free_velocity, 3);
    rows("bodies/free_velocity", count, "what has no radius cannot turn",
         [&](std::size_t k) { return t_.radius[k] == 0.0 && t_.free_velocity[3 * k + 2] != 0.0; });
  }

  bool contact_bodies() {
    const auto bodies = static_cast<std::int64_t>(t_.mass.size());
    const auto out = [&](std::int64_t body) { return body < 0 || body >= bodies; };
    const bool there = rows("contacts/bodies", t_.friction.size(), "must be rows of bodies",
                            [&](std::size_t k) { return out(t_.bodies[2 * k]) || out(t_.bodies[2 * k + 1]); });
    return there &&
           rows("contacts/bodies", t_.friction.size(),
                "must be two bodies, one of finite mass, and the first must have a radius", [&](std::size_t k) {
                  const bool held = std::isinf(t_.mass[first(k)]) && std::isinf(t_.mass[second(k)]);
                  return first(k) == second(k) || held || !(t_.radius[first(k)] > 0.0);
                });
  }

  std::size_t first(std::size_t k) const { return static_cast<std::size_t>(t_.bodies[2 * k]); }
  std::size_t second(std::size_t k) const { return static_cast<std::size_t>(t_.bodies[2 * k + 1]); }

  void contacts() {
    const auto count = t_.friction.size();
    rows("contacts/normal", count, "must have length 1",
         [&](std::size_t k) { return !near(std::hypot(t_.normal[2 * k], t_.normal[2 * k + 1]), 1.0); });
    rows("contacts/arms", count, "must be the same share of both radii, > 0", [&](std::size_t k) {
      const double share = t_.arms[2 * k] / t_.radius[first(k)];
      const double other = share * t_.radius[second(k)];
      return !(share > 0.0) || std::isinf(share) || !(other == t_.arms[2 * k + 1] || near(other, t_.arms[2 * k + 1]));
    });
    rows("contacts/roll_radius", count,
         "must be 2 r1 r2 / (r1 + r2), or the radius of the first where the second has none", [&](std::size_t k) {
           const double r1 = t_.radius[first(k)];
           const double r2 = t_.radius[second(k)];
           return !near(t_.roll_radius[k], r2 > 0.0 ? 2.0 * r1 * r2 / (r1 + r2) : r1);
         });
    finite("contacts/normal_bias", t_.normal_bias, 1);
    finite("contacts/tangential_bias", t_.tangential_bias, 1);
    rows("contacts/friction", count, "must be >= 0", [&](std::size_t k) { return !(t_.friction[k] >= 0.0); });
    rows("contacts/rolling_friction", count, "must be >= 0",
         [&](std::size_t k) { return !(t_.rolling_friction[k] >= 0.0); });
    finite("contacts/impulse", t_.impulse, 3);
  }

  const std::string& path_;
  const Tables& t_;
  std::vector<std::string> problems_;
};

contact_dynamics::Problem<2> problem_of(const Tables& t) {
  contact_dynamics::Problem<2> problem;
  for (std::size_t k = 0; k < t.mass.size(); ++k) {
    const auto* velocity = &t.free_velocity[3 * k];
    problem.free.push_back({{{velocity[0], velocity[1]}}, velocity[2] * t.radius[k], 1.0 / t.mass[k]});
  }
  problem.rolling = false;
  for (std::size_t k = 0; k < t.friction.size(); ++k) {
    contact_dynamics::ContactLine<2> c;
    c.first = static_cast<std::uint32_t>(t.bodies[2 * k]);
    c.second = static_cast<std::uint32_t>(t.bodies[2 * k + 1]);
    c.normal = {{t.normal[2 * k], t.normal[2 * k + 1]}};
    c.impulse = {t.impulse[3 * k], t.impulse[3 * k + 1], t.impulse[3 * k + 2]};
    c.normal_bias = t.normal_bias[k];
    c.tangent_bias = t.tangential_bias[k];
    c.friction = t.friction[k];
    c.rolling_friction = t.rolling_friction[k];
    c.lever = t.arms[2 * k] / t.radius[c.first];
    c.first_turn = t.roll_radius[k] / t.radius[c.first];
    set_masses(c, problem.free[c.first].inverse_mass, problem.free[c.second].inverse_mass);
    problem.rolling |= c.rolling_friction > 0.0;
    problem.contacts.push_back(c);
  }
  return problem;
}

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
  file.group("bodies");
  file.group("contacts");
  const auto tables = tables_of(posed);
  for_each_table(tables, [&](const char* name, const auto& values, std::size_t columns, const char* unit,
                             const char* meaning) { file.dataset(name, values, columns, unit, meaning); });
  file.commit();
}

ContactProblem read_contact_problem(const std::string& path) {
  const Hdf5Reader file(path, Sealing::optional);
  std::vector<std::string> problems;
  const auto attempt = [&](const auto& results) {
    try {
      results();
    } catch (const InputError& problem) {
      problems.insert(problems.end(), problem.problems().begin(), problem.problems().end());
    }
  };
  if (file.text_or("/", "format", "") != format || file.integer("/", "format_version") != format_version) {
    throw InputError(fmt::format("{}: is no contact problem of this version of Repose", path));
  }
  ContactProblem posed;
  Tables tables;
  attempt([&] { posed.title = file.text_or("/", "title", ""); });
  attempt([&] { posed.time = file.number("/", "time"); });
  attempt([&] { posed.time_step = file.number("/", "time_step"); });
  attempt([&] {
    posed.problem.velocity_scale = file.number("/", "velocity_scale");
    const bool sound = posed.problem.velocity_scale > 0.0 && std::isfinite(posed.problem.velocity_scale);
    if (!sound) throw InputError(fmt::format("{}: velocity_scale: must be > 0", path));
  });
  for_each_table(tables, [&](const char* name, auto& values, std::size_t columns, auto&&...) {
    attempt([&] { values = file.dataset<typename std::decay_t<decltype(values)>::value_type>(name, columns); });
  });
  if (problems.empty()) problems = Checks(path, tables).problems();
  if (!problems.empty()) throw InputError(problems);
  const double scale = posed.problem.velocity_scale;
  posed.problem = problem_of(tables);
  posed.problem.velocity_scale = scale;
  for (std::size_t k = 0; k < tables.id.size(); ++k) {
    posed.places.push_back({tables.id[k], tables.radius[k], {{tables.position[2 * k], tables.position[2 * k + 1]}}});
  }
  return posed;
}

}  // namespace repose
