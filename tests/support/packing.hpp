// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <cmath>

namespace repose {

/// A disc of diameter 1 and mass 1.
inline Grain<2> unit_disc(double x, double y, bool fixed = false) {
  Grain<2> grain;
  grain.position = {{x, y}};
  grain.radius = 0.5;
  grain.mass = 1.0;
  grain.inverse_mass = fixed ? 0.0 : 1.0;
  return grain;
}

/// A contact between two grains at their positions; the normal points from the second to the first.
inline Contact<2> contact_between(const Grains<2>& grains, std::size_t first, std::size_t second, double normal_force,
                                  bool sliding = false) {
  Contact<2> contact;
  contact.first = grains.id[first];
  contact.second = grains.id[second];
  const Vec<2> d = grains.line[first].position - grains.line[second].position;
  contact.normal = d * (1.0 / magnitude(d));
  contact.first_lever = 0.5 * magnitude(d);
  contact.normal_force = normal_force;
  contact.sliding = sliding;
  return contact;
}

/// The equilateral lattice pile of Liffman et al. (1992): `rows` discs on a wall (number 0, through the lowest points
/// of the discs) and one less in each row above, with contacts along the two diagonals only. Every disc puts half of
/// its weight on each diagonal below it, so a contact with n discs above it on its diagonal (the upper partner
/// included) carries n m g / (2 sin 60 deg).
struct LatticePile {
  Grains<2> grains;
  Contacts<2> contacts;
};
inline LatticePile lattice_pile(int rows) {
  LatticePile pile;
  const double rise = std::sqrt(3.0) / 2.0;
  std::vector<std::vector<std::size_t>> place(static_cast<std::size_t>(rows));
  std::int64_t id = 0;
  for (int r = 0; r < rows; ++r) {
    for (int j = 0; j < rows - r; ++j) {
      place[static_cast<std::size_t>(r)].push_back(pile.grains.size());
      pile.grains.add(unit_disc(j + 0.5 * r, r * rise), id++);
    }
  }
  const auto at = [&](int r, int j) { return place[static_cast<std::size_t>(r)][static_cast<std::size_t>(j)]; };
  for (int r = 0; r < rows; ++r) {
    for (int j = 0; j < rows - r; ++j) {
      const int on_left = j + 1;          // discs on the diagonal up to the left, this one included
      const int on_right = rows - r - j;  // discs on the diagonal up to the right
      if (r > 0) {
        // Normals point up from the lower partner, so the upper one is the first.
        pile.contacts.list.push_back(
            contact_between(pile.grains, at(r, j), at(r - 1, j + 1), on_left / std::sqrt(3.0)));
        pile.contacts.list.push_back(contact_between(pile.grains, at(r, j), at(r - 1, j), on_right / std::sqrt(3.0)));
      } else {
        Contact<2> ground;
        ground.first = pile.grains.id[at(r, j)];
        ground.second = wall_partner(0);
        ground.normal = {{0.0, 1.0}};
        ground.first_lever = 0.5;
        ground.normal_force = 0.5 * (on_left + on_right);
        // The tangent of an upward normal points to the left; the ground pushes inward.
        ground.tangential_force = (on_left - on_right) / (2.0 * std::sqrt(3.0));
        pile.contacts.list.push_back(ground);
      }
    }
  }
  return pile;
}

}  // namespace repose
