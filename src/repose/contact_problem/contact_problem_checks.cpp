// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/contact_problem/contact_problem_checks.hpp"

#include "repose/core/grains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

namespace {

constexpr auto infinity = std::numeric_limits<double>::infinity();

/// Numbers that belong together may differ by so much, relative to their own size.
constexpr double rounding = 1e-9;

bool near(double a, double b) { return std::fabs(a - b) <= rounding * std::max(std::fabs(a), std::fabs(b)); }

template <std::size_t N>
bool finite(const std::array<double, N>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

class Checks {
 public:
  explicit Checks(const std::string& path) : path_(path) {}

  std::vector<std::string> problems;

  /// `is_right(row)` for all rows; `rule` is what a right one obeys.
  template <class Row, class IsRight>
  bool rows(const char* name, const std::vector<Row>& all, const char* rule, const IsRight& is_right) {
    const auto wrong = [&](const Row& row) { return !is_right(row); };
    const auto first = std::find_if(all.begin(), all.end(), wrong);
    if (first == all.end()) return true;
    const auto count = std::count_if(first, all.end(), wrong);
    const auto more = count > 1 ? fmt::format(" (and {} more rows)", count - 1) : std::string();
    problems.push_back(fmt::format("{}: {}: row {}{}: {}", path_, name, first - all.begin(), more, rule));
    return false;
  }

 private:
  const std::string& path_;
};

void check_bodies(Checks& checks, const std::vector<BodyRow>& bodies) {
  const auto moves = [](const BodyRow& body) { return std::isfinite(body.mass); };
  checks.rows("bodies/mass", bodies, "must be > 0", [](const auto& body) { return body.mass > 0.0; });
  checks.rows("bodies/radius", bodies, "must be finite, and > 0 where the mass is finite", [&](const auto& body) {
    return std::isfinite(body.radius) && body.radius >= 0.0 && !(moves(body) && body.radius == 0.0);
  });
  checks.rows("bodies/inertia", bodies, "must be mass radius^2 / 2, that of a disc, or infinite where the mass is",
              [&](const auto& body) {
                const double disc = body.mass * body.radius * body.radius / inverse_inertia_factor<2>;
                return moves(body) ? near(body.inertia, disc) : body.inertia == infinity;
              });
  checks.rows("bodies/position", bodies, "must be finite",
              [](const auto& body) { return std::isfinite(body.position[0]) && std::isfinite(body.position[1]); });
  checks.rows("bodies/free_velocity", bodies, "must be finite",
              [](const auto& body) { return finite(body.free_velocity); });
  checks.rows("bodies/free_velocity", bodies, "what has no radius cannot turn",
              [](const auto& body) { return body.radius != 0.0 || body.free_velocity[2] == 0.0; });
}

bool check_partners(Checks& checks, const std::vector<BodyRow>& bodies, const std::vector<ContactRow>& contacts) {
  const auto exists = [&](std::int64_t body) { return body >= 0 && body < static_cast<std::int64_t>(bodies.size()); };
  const auto body = [&](std::int64_t row) -> const BodyRow& { return bodies[static_cast<std::size_t>(row)]; };
  return checks.rows("contacts/bodies", contacts, "must be rows of bodies",
                     [&](const auto& row) { return exists(row.first) && exists(row.second); }) &&
         checks.rows("contacts/bodies", contacts,
                     "must be two bodies, one of finite mass, and the first must have a radius", [&](const auto& row) {
                       const bool held = std::isinf(body(row.first).mass) && std::isinf(body(row.second).mass);
                       return row.first != row.second && !held && body(row.first).radius > 0.0;
                     });
}

void check_contacts(Checks& checks, const std::vector<BodyRow>& bodies, const std::vector<ContactRow>& contacts) {
  const auto radius = [&](std::int64_t row) { return bodies[static_cast<std::size_t>(row)].radius; };
  checks.rows("contacts/normal", contacts, "must have length 1",
              [](const auto& row) { return near(std::hypot(row.normal[0], row.normal[1]), 1.0); });
  checks.rows("contacts/arms", contacts, "must be the same fraction of both radii, > 0", [&](const auto& row) {
    const double fraction = row.arms[0] / radius(row.first);
    const double other = fraction * radius(row.second);
    return fraction > 0.0 && !std::isinf(fraction) && (other == row.arms[1] || near(other, row.arms[1]));
  });
  checks.rows("contacts/roll_radius", contacts,
              "must be 2 r1 r2 / (r1 + r2), or the radius of the first where the second has none",
              [&](const auto& row) {
                const double r1 = radius(row.first);
                const double r2 = radius(row.second);
                return near(row.roll_radius, r2 > 0.0 ? 2.0 * r1 * r2 / (r1 + r2) : r1);
              });
  checks.rows("contacts/normal_bias", contacts, "must be finite",
              [](const auto& row) { return std::isfinite(row.normal_bias); });
  checks.rows("contacts/tangential_bias", contacts, "must be finite",
              [](const auto& row) { return std::isfinite(row.tangential_bias); });
  checks.rows("contacts/friction", contacts, "must be >= 0", [](const auto& row) { return row.friction >= 0.0; });
  checks.rows("contacts/rolling_friction", contacts, "must be >= 0",
              [](const auto& row) { return row.rolling_friction >= 0.0; });
  checks.rows("contacts/impulse", contacts, "must be finite", [](const auto& row) { return finite(row.impulse); });
}

}  // namespace

std::vector<std::string> contact_problem_mistakes(const std::string& path, const std::vector<BodyRow>& bodies,
                                                  const std::vector<ContactRow>& contacts) {
  Checks checks(path);
  check_bodies(checks, bodies);
  if (check_partners(checks, bodies, contacts)) check_contacts(checks, bodies, contacts);
  return checks.problems;
}

}  // namespace repose
