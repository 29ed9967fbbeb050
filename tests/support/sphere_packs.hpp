// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"
#include "repose/core/random.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace repose::packs {

/// A sphere of mass 1, by default of diameter 1.
inline Grain<3> unit_sphere(const Vec<3>& position, bool fixed = false, double radius = 0.5) {
  Grain<3> grain;
  grain.position = position;
  grain.radius = radius;
  grain.mass = 1.0;
  grain.inverse_mass = fixed ? 0.0 : 1.0;
  return grain;
}

/// A contact between two spheres at their positions; the normal points from the second to the first.
inline Contact<3> sphere_contact(const Grains<3>& grains, std::size_t first, std::size_t second, double normal_force) {
  Contact<3> contact;
  contact.first = grains.id[first];
  contact.second = grains.id[second];
  const Vec<3> d = grains.line[first].position - grains.line[second].position;
  contact.normal = d * (1.0 / magnitude(d));
  const double fraction = grains.line[first].radius / (grains.line[first].radius + grains.line[second].radius);
  contact.first_lever = fraction * magnitude(d);
  contact.normal_force = normal_force;
  return contact;
}

/// A uniform random number in [0, 1).
inline double random_number(std::uint64_t index, std::uint32_t draw, std::uint64_t seed = 1) {
  return uniform(seed, Purpose::lattice_place, index, draw);
}

/// A uniform random direction.
inline Vec<3> random_direction(std::uint64_t index, std::uint64_t seed = 1) {
  const double z = 2.0 * random_number(index, 0, seed) - 1.0;
  const double turn = 2.0 * std::numbers::pi * random_number(index, 1, seed);
  const double level = std::sqrt(1.0 - z * z);
  return {{level * std::cos(turn), level * std::sin(turn), z}};
}

/// Centres of a face-centred cubic lattice of spheres of diameter 1, cells x cells x layers unit cells from the origin
/// on; the side of a unit cell is sqrt(2).
inline std::vector<Vec<3>> fcc_centres(int cells, int layers) {
  const double side = std::numbers::sqrt2;
  std::vector<Vec<3>> centres;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      for (int k = 0; k < layers; ++k) {
        for (const auto& [x, y, z] : {std::array{0.0, 0.0, 0.0}, std::array{0.5, 0.5, 0.0}, std::array{0.5, 0.0, 0.5},
                                      std::array{0.0, 0.5, 0.5}}) {
          centres.push_back({{side * (i + x), side * (j + y), side * (k + z)}});
        }
      }
    }
  }
  return centres;
}

/// A box that is periodic along both level axes, from the origin.
inline Box<3> level_periodic_box(double width, double depth) {
  Box<3> box;
  box.periodic = true;
  box.x_min = 0.0;
  box.x_max = width;
  box.periodic_y = true;
  box.y_min = 0.0;
  box.y_max = depth;
  return box;
}

/// A square pyramid of spheres of diameter 1 on a floor (wall 0, z = 0), `rows` x `rows` of them in the lowest layer:
/// each upper sphere lies on four. Weight 1 each. The normal forces and the forces of the floor are the equilibrium of
/// least squares. The apex is above the origin.
struct SquarePyramid {
  Grains<3> grains;
  Contacts<3> contacts;

  explicit SquarePyramid(int rows) {
    std::vector<std::vector<std::size_t>> place(static_cast<std::size_t>(rows));
    for (int layer = 0; layer < rows; ++layer) {
      const int side = rows - layer;
      for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
          place[static_cast<std::size_t>(layer)].push_back(grains.size());
          grains.add(unit_sphere({{i - 0.5 * (side - 1), j - 0.5 * (side - 1), 0.5 + layer * std::sqrt(0.5)}}),
                     static_cast<std::int64_t>(grains.size()));
        }
      }
    }
    const auto at = [&](int layer, int i, int j) {
      return place[static_cast<std::size_t>(layer)][static_cast<std::size_t>(i * (rows - layer) + j)];
    };
    for (int layer = 0; layer < rows; ++layer) {
      for (int i = 0; i < rows - layer; ++i) {
        for (int j = 0; j < rows - layer; ++j) {
          const auto upper = at(layer, i, j);
          if (layer == 0) {
            for (int axis = 0; axis < 3; ++axis) {
              Vec<3> direction{};
              direction[axis] = 1.0;
              unknowns_.push_back({upper, upper, direction, true});
            }
            continue;
          }
          for (int corner = 0; corner < 4; ++corner) {
            const auto lower = at(layer - 1, i + corner / 2, j + corner % 2);
            const auto contact = sphere_contact(grains, upper, lower, 0.0);
            unknowns_.push_back({upper, lower, contact.normal, false});
          }
        }
      }
    }
    const auto forces = solve();
    for (std::size_t k = 0; k < unknowns_.size(); ++k) {
      const auto& unknown = unknowns_[k];
      if (!unknown.floor) {
        contacts.list.push_back(sphere_contact(grains, unknown.upper, unknown.lower, forces[k]));
      } else if (unknown.direction[2] > 0.0) {
        Contact<3> ground;
        ground.first = grains.id[unknown.upper];
        ground.second = wall_partner(0);
        ground.normal = unknown.direction;
        ground.first_lever = 0.5;
        ground.normal_force = forces[k];
        ground.tangential_force = {{forces[k - 2], forces[k - 1], 0.0}};
        contacts.list.push_back(ground);
      }
    }
    contacts.sort();
  }

 private:
  struct Unknown {
    std::size_t upper, lower;
    Vec<3> direction;  // of the force on the upper one
    bool floor;
  };

  /// The solution of A x = b with the least sum of squares, A^T (A A^T)^-1 b, by Cholesky's method.
  std::vector<double> solve() const {
    const std::size_t n = 3 * grains.size();
    std::vector<std::vector<double>> rows(n, std::vector<double>(unknowns_.size(), 0.0));
    for (std::size_t k = 0; k < unknowns_.size(); ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double part = unknowns_[k].direction[static_cast<int>(axis)];
        rows[3 * unknowns_[k].upper + axis][k] += part;
        if (!unknowns_[k].floor) rows[3 * unknowns_[k].lower + axis][k] -= part;
      }
    }
    std::vector<double> y(n, 0.0);
    for (std::size_t k = 2; k < n; k += 3) y[k] = 1.0;  // against the weight
    std::vector<std::vector<double>> factor(n, std::vector<double>(n, 0.0));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = 0.0;
        for (std::size_t k = 0; k < unknowns_.size(); ++k) sum += rows[i][k] * rows[j][k];
        for (std::size_t k = 0; k < j; ++k) sum -= factor[i][k] * factor[j][k];
        factor[i][j] = i == j ? std::sqrt(sum) : sum / factor[j][j];
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < i; ++k) y[i] -= factor[i][k] * y[k];
      y[i] /= factor[i][i];
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < n; ++k) y[i] -= factor[k][i] * y[k];
      y[i] /= factor[i][i];
    }
    std::vector<double> x(unknowns_.size(), 0.0);
    for (std::size_t k = 0; k < unknowns_.size(); ++k) {
      for (std::size_t i = 0; i < n; ++i) x[k] += rows[i][k] * y[i];
    }
    return x;
  }

  std::vector<Unknown> unknowns_;
};

}  // namespace repose::packs
