// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/stability/stiffness_matrix.hpp"

#include <cmath>

namespace repose {

namespace {

using Freedom = StiffnessMatrix::Freedom;

/// A grain that is held along two directions that differ by more than this cannot move.
constexpr double parallel = 1e-9;

/// What is left of the freedom of a grain that may move along this direction alone.
std::vector<Vec<2>> restricted(const std::vector<Vec<2>>& directions, const Vec<2>& along) {
  if (directions.size() == 2) return {along};
  if (directions.empty()) return {};
  const auto& only = directions.front();
  const double sine = only[0] * along[1] - only[1] * along[0];
  return std::fabs(sine) < parallel ? directions : std::vector<Vec<2>>{};
}

std::vector<Freedom> freedom_of(std::size_t grains, const std::vector<ContactSpring>& springs) {
  std::vector<Freedom> all(grains);
  const std::vector<Vec<2>> plane{Vec<2>{{1.0, 0.0}}, Vec<2>{{0.0, 1.0}}};
  for (const auto& spring : springs) {
    all[spring.first].directions = plane;
    if (spring.second != ContactSpring::nothing) all[spring.second].directions = plane;
  }
  for (const auto& spring : springs) {
    auto& directions = all[spring.first].directions;
    if (spring.holds) directions = restricted(directions, spring.normal);
  }
  std::size_t unknowns = 0;
  for (auto& one : all) {
    one.first = unknowns;
    unknowns += one.directions.size();
  }
  return all;
}

}  // namespace

StiffnessMatrix stiffness_matrix(std::size_t grains, const std::vector<ContactSpring>& springs) {
  StiffnessMatrix made{{}, freedom_of(grains, springs)};
  for (const auto& one : made.freedom) made.matrix.size += one.directions.size();
  for (const auto& spring : springs) {
    const Vec<2> tangent{{-spring.normal[1], spring.normal[0]}};
    const double turning = spring.force / spring.distance;
    const auto add = [&](std::size_t a, std::size_t b, double sign) {
      const auto& rows = made.freedom[a];
      const auto& columns = made.freedom[b];
      for (std::size_t i = 0; i < rows.directions.size(); ++i) {
        for (std::size_t j = 0; j < columns.directions.size(); ++j) {
          const auto row = rows.first + i;
          const auto column = columns.first + j;
          if (column > row) continue;
          const auto& u = rows.directions[i];
          const auto& v = columns.directions[j];
          const double value = spring.stiffness * dot(u, spring.normal) * dot(v, spring.normal) -
                               turning * dot(u, tangent) * dot(v, tangent);
          made.matrix.lower.push_back({row, column, sign * value});
        }
      }
    };
    add(spring.first, spring.first, 1.0);
    if (spring.second == ContactSpring::nothing) continue;
    add(spring.second, spring.second, 1.0);
    add(spring.first, spring.second, -1.0);
    add(spring.second, spring.first, -1.0);
  }
  return made;
}

}  // namespace repose
