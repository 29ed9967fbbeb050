// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/eigen.hpp"
#include "repose/core/random.hpp"
#include "repose/laws/time_step.hpp"
#include "repose/methods/soft/soft.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

// The largest stable step of a bed of spheres, against the fastest motion of a close packing of equal spheres, of which
// each touches twelve others. Masses and diameters are 1.

namespace repose {
namespace {

/// The stiffnesses [M/T^2] of a contact: normal, tangential, against rolling and against twisting.
struct Stiffness {
  double normal = 0.0;
  double tangential = 0.0;
  double rolling = 0.0;
  double twisting = 0.0;
};

ContactLaws laws_of(const Stiffness& k) {
  ContactLaws laws{Hooke{k.normal, 0.0}, None{}, {}, {}};
  if (k.tangential > 0.0) laws.tangential = Linear{1e6, k.tangential, 0.0};
  if (k.rolling > 0.0) laws.rolling = RollingSpring{1e6, k.rolling, 0.0};
  if (k.twisting > 0.0) laws.twisting = TwistingSpring{{1e6, k.twisting, 0.0}};
  return laws;
}

double largest_step(const Stiffness& k) { return largest_step_of_bed(laws_of(k), {}, {}, 1e-6, 3); }

using Matrix = Eigen::Matrix<std::complex<double>, 6, 6>;
using Rows = Eigen::Matrix<std::complex<double>, 3, 6>;

Eigen::Matrix3d crossed_with(const Eigen::Vector3d& n) {  // a x n as a matrix on a
  Eigen::Matrix3d of;
  of << 0.0, n.z(), -n.y(), -n.z(), 0.0, n.x(), n.y(), -n.x(), 0.0;
  return of;
}

/// The largest K = w^2 [1/T^2] of motions exp(i q.r) of a face-centred cubic packing, from displacements u and rim
/// velocities R w of its one grain a cell. A contact has the slip P (u_i - u_j) - R (w_i + w_j) x n, P = 1 - n n.
double largest_of_packing(const Stiffness& k, const Eigen::Vector3d& q) {
  Matrix sum = Matrix::Zero();
  for (const auto& [x, y, z] : {std::array{1, 1, 0}, std::array{1, -1, 0}, std::array{1, 0, 1}, std::array{1, 0, -1},
                                std::array{0, 1, 1}, std::array{0, 1, -1}}) {
    const Eigen::Vector3d n = Eigen::Vector3d(x, y, z) / std::numbers::sqrt2;
    const Eigen::Matrix3d along = n * n.transpose();
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along;
    const std::complex<double> other = std::polar(1.0, -q.dot(n));
    const auto add = [&](double stiffness, const Eigen::Matrix3d& of_u, std::complex<double> u_factor,
                         const Eigen::Matrix3d& of_w, std::complex<double> w_factor) {
      Rows rows;
      rows.leftCols<3>() = of_u.cast<std::complex<double>>() * u_factor;
      rows.rightCols<3>() = of_w.cast<std::complex<double>>() * w_factor;
      sum += stiffness * rows.adjoint() * rows;
    };
    const Eigen::Matrix3d none = Eigen::Matrix3d::Zero();
    add(k.normal, along, 1.0 - other, none, 0.0);
    add(k.tangential, across, 1.0 - other, crossed_with(n), -(1.0 + other));
    add(k.rolling, none, 0.0, across, 1.0 - other);
    add(k.twisting, none, 0.0, along, 1.0 - other);
  }
  Eigen::Matrix<double, 6, 1> root;
  root << 1.0, 1.0, 1.0, std::sqrt(2.5), std::sqrt(2.5), std::sqrt(2.5);
  const Matrix scaled = root.asDiagonal() * sum * root.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Matrix>(scaled, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

double largest_of_packing(const Stiffness& k) {
  const int steps = 4;
  const double cell = std::numbers::sqrt2;  // of the cubic lattice
  double largest = 0.0;
  for (int x = 0; x <= steps; ++x) {
    for (int y = 0; y <= steps; ++y) {
      for (int z = 0; z <= steps; ++z) {
        const Eigen::Vector3d q = Eigen::Vector3d(x, y, z) * (2.0 * std::numbers::pi / (cell * steps));
        largest = std::max(largest, largest_of_packing(k, q));
      }
    }
  }
  return largest;
}

// Without dashpots the step is 2 / sqrt(K). Where one kind of motion is much the fastest, the bound is the packing's
// own. Neighbours that move or spin against each other cannot do so with all twelve, so that the bound may be 1.6 times
// the K of the packing, a fifth of the step. Motions that mix translation, slip and rolling are faster than each of
// them, but by less than 1/9 in K, and by 1/300 without rolling.
TEST(TimeStepOfSpheres, IsThatOfAClosePacking) {
  const auto bound = [](const Stiffness& k) { return 4.0 / std::pow(largest_step(k), 2); };
  for (const double tangential : {0.0, 0.05, 0.2, 0.3, 0.5, 0.8, 1.0}) {
    for (const double rolling : {0.0, 0.1, 0.5}) {
      for (const double twisting : {0.0, 0.5}) {
        const Stiffness k{100.0, 100.0 * tangential, 100.0 * rolling, 100.0 * twisting};
        const double packing = largest_of_packing(k);
        EXPECT_GE(bound(k), packing * (rolling > 0.0 ? 0.9 : 0.997))
            << tangential << ", " << rolling << ", " << twisting;
        EXPECT_LE(bound(k), packing * 1.6) << tangential << ", " << rolling << ", " << twisting;
      }
    }
  }
  EXPECT_NEAR(bound({100.0, 0.0, 0.0, 0.0}), 800.0, 1e-6);
  EXPECT_NEAR(largest_of_packing({100.0, 0.0, 0.0, 0.0}), 800.0, 1e-6);
  EXPECT_NEAR(bound({100.0, 80.0, 0.0, 0.0}), 40.0 * 80.0, 1e-6);
  EXPECT_NEAR(largest_of_packing({100.0, 80.0, 0.0, 0.0}), 40.0 * 80.0, 1e-6);
  EXPECT_NEAR(bound({100.0, 10.0, 0.0, 0.0}), 8.0 * 100.0 + 16.0 * 10.0, 1e-6);
  EXPECT_NEAR(bound({100.0, 0.0, 70.0, 20.0}), 40.0 * 70.0 + 20.0 * 20.0, 1e-6);
}

// The dashpots add up in the same way: C = (8 c_n + 16 c_t)/m, and a motion is stable for K dt^2 + 2 C dt < 4.
TEST(TimeStepOfSpheres, HasTheDashpotsOfTheMotion) {
  const ContactLaws laws{Hooke{500.0, 0.5}, Linear{1.0, 20.0, 0.5}, {}, {}};
  const double k = 8.0 * 500.0 + 16.0 * 20.0;
  const double c = 8.0 * std::sqrt(500.0) + 16.0 * std::sqrt(20.0);
  EXPECT_NEAR(largest_step_of_bed(laws, {}, {}, 10.0, 3), 4.0 / (c + std::sqrt(c * c + 4.0 * k)), 1e-9);
  const ContactLaws rolls{Hooke{100.0, 0.0}, None{}, RollingViscous{10.0, 30.0}, {}, TwistingViscous{{10.0, 8.0}}};
  EXPECT_NEAR(largest_step_of_bed(rolls, {}, {}, 10.0, 3), 2.0 / (40.0 * 15.0 + 20.0 * 4.0), 1e-9);
}

// The stiffest contact of a fall: a force at the rim of a sphere meets 2/7 of its mass, and two spheres roll on each
// other with 2 m R^2 / I = 5 times the stiffness.
TEST(TimeStepOfSpheres, StiffestContact) {
  const auto frequency = [](const Stiffness& k) {
    return stiffest_contact(laws_of(k), {}, {}, 1.0, 10.0, 3).frequency;
  };
  EXPECT_NEAR(frequency({500.0, 0.0, 0.0, 0.0}), std::sqrt(500.0), 1e-9);
  EXPECT_NEAR(frequency({500.0, 500.0, 0.0, 0.0}), std::sqrt(3.5 * 500.0), 1e-9);
  EXPECT_NEAR(frequency({500.0, 0.0, 400.0, 0.0}), std::sqrt(5.0 * 400.0), 1e-9);
  EXPECT_NEAR(frequency({500.0, 0.0, 0.0, 600.0}), std::sqrt(5.0 * 600.0), 1e-9);
}

/// The kinetic energy of a slab of a close packing after some steps over that at the start, which is tiny and random.
/// The slab is periodic in x and y, between fixed layers, and its spheres overlap.
double growth(const Stiffness& k, double step, int steps) {
  const double cell = std::numbers::sqrt2 * 0.99;
  const int cells = 4;
  const int layers = 12;
  SoftSettings<3> settings;
  settings.time_step = step;
  settings.box.periodic = settings.box.periodic_y = true;
  settings.box.x_min = settings.box.y_min = 0.0;
  settings.box.x_max = settings.box.y_max = cells * cell;
  settings.skin = 0.2;
  Grains<3> grains;
  const auto method = make_soft<3>(MaterialLaws{1, {laws_of(k)}}, settings);
  for (int z = 0; z < layers; ++z) {
    for (int y = 0; y < 2 * cells; ++y) {
      for (int x = 0; x < 2 * cells; ++x) {
        if ((x + y + z) % 2 != 0) continue;
        Grain<3> grain;
        grain.position = Vec<3>{{x + 0.5, y + 0.5, z + 0.5}} * (0.5 * cell);
        grain.radius = 0.5;
        grain.mass = 1.0;
        grain.inverse_mass = z < 2 || z >= layers - 2 ? 0.0 : 1.0;
        const auto number = [&](std::uint32_t draw) {
          return uniform(3, Purpose::release_position, grains.size(), draw) - 0.5;
        };
        for (int axis = 0; axis < 3 && !grain.fixed(); ++axis) {
          grain.velocity[axis] = 1e-7 * number(static_cast<std::uint32_t>(axis));
          grain.rim_velocity[axis] = 1e-7 * number(static_cast<std::uint32_t>(3 + axis));
        }
        grains.add(grain, static_cast<std::int64_t>(grains.size()));
      }
    }
  }
  method->grains_added(grains);
  const double before = kinetic_energy(grains);
  Team team(1);
  const auto report = method->advance(grains, steps * step, team);
  return report.trouble ? 1e30 : kinetic_energy(grains) / before;
}

// At 0.97 of the step from the function a bed keeps its energy: springs hold as much as the motion, so that the kinetic
// energy stays below twice that of the start. At 1.03 of the step of the packing it grows without bound: where K dt^2 =
// 4.24 the velocities of a mode grow by 1.6 a step.
TEST(TimeStepOfSpheres, ABedIsStableBelowAndUnstableAboveIt) {
  for (const auto& k : {Stiffness{100.0, 0.0, 0.0, 0.0}, Stiffness{100.0, 80.0, 0.0, 0.0},
                        Stiffness{100.0, 20.0, 0.0, 0.0}, Stiffness{100.0, 10.0, 60.0, 60.0}}) {
    EXPECT_LT(growth(k, 0.97 * largest_step(k), 300), 2.0) << k.tangential;
    EXPECT_GT(growth(k, 1.03 * 2.0 / std::sqrt(largest_of_packing(k)), 300), 1e3) << k.tangential;
  }
}

}  // namespace
}  // namespace repose
