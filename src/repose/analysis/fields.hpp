// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/flat_wall.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/ordered_grains.hpp"

#include <array>
#include <vector>

namespace repose {

/// Continuum fields of a heap on a grid of square cells. Each field has one value per cell, by ascending y, then x.
/// Densities, stress and support are averages over the cell, so that the sum of the values times cell^2 is the total.
/// Where a cell lies partly behind a wall, the value over `room` is the average in the part before it.
struct Fields {
  double width = 0.0;                           ///< [L] standard deviation of the Gaussian
  double cell = 0.0;                            ///< [L] side of a cell
  std::vector<double> x;                        ///< [L] centres of the columns, ascending
  std::vector<double> y;                        ///< [L] centres of the rows, ascending
  std::vector<double> room;                     ///< fraction of the cell that walls leave to the heap; 0 far from it
  std::vector<double> density;                  ///< [M/L^2] of the grains in the heap
  std::vector<double> solid_fraction;           ///< area of their discs per area; overlaps count twice
  std::array<std::vector<double>, 4> stress;    ///< [M/T^2] xx, xy, yx, yy; compression positive
  std::array<std::vector<double>, 2> support;   ///< [M/(L T^2)] x, y: force per area on the heap from outside it
  std::array<std::vector<double>, 2> velocity;  ///< [L/T] x, y: momentum over mass; NaN far from the heap
  std::vector<double> temperature;              ///< [L^2/T^2] see analysis/local_motion.hpp
  std::vector<double> contacts;                 ///< [1/L^2] contacts above the threshold
  std::array<std::vector<double>, 3> fabric;    ///< xx, xy, yy of the mean n n of these contacts; NaN far from them
  std::vector<double> coordination;             ///< mean number of them per grain; NaN far from the heap
};

struct FieldSettings {
  double width = 0.0;             ///< [L] > 0, of the Gaussian
  double threshold = 0.0;         ///< [M L/T^2] a larger normal force, push or pull, makes a contact count
  std::vector<FlatWall> walls{};  ///< nothing is put behind these
};

/// Coarse-grained fields of the grains flagged `in_heap`, with a Gaussian W of standard deviation `width`:
/// density = sum m_i W(x - x_i), stress_ab = sum over contacts of f_a b_b times the mean of W along b. Here f is the
/// force on the first partner and b the branch from the centre of the second to that of the first, so compression is
/// positive. Partners outside the heap (fixed grains, walls) support it: the branch then runs from the contact point to
/// the centre of the grain in the heap, and the force on that grain enters `support` with W at the contact point.
/// Fabric and contacts take the mean of W along the branch too, velocity and coordination W at the centres of grains.
///
/// W ends at walls (analysis/smear.hpp) and integrates to one, so the integrals of mass, stress and support are exact
/// to rounding, with any walls. The eye is the centre of a grain, and the middle of a contact between grains.
///
/// Balance of forces, with F_i the sum of all contact forces on grain i:
///   sum over b of d(stress_ab)/dx_b = support_a - sum F_ia W(x - x_i), in equilibrium support_a + density g_a,
/// exact to the quadrature along branches (relative error below 1e-9 of the peak) where no wall lies within 8.5 widths.
/// Summed over x, it holds for every level cut between upright planes, however near these are, and likewise for upright
/// cuts between level planes. Nearer to other walls W changes along a branch, and the balance has an error of the order
/// of the stress over the width, which decays as the Gaussian; the jump of the stress at the wall carries the rest.
///
/// Averages over cells of W at a point are exact: products of differences of the normal distribution. Each contribution
/// extends to 8.5 widths. Cells are width/2 wide; in a periodic box they are the largest that divide the width of the
/// box and are no wider. Their edges lie at multiples of the side, in a periodic box from x_min, and columns wrap.
/// Cells are larger if the grid would exceed four million of them. The fields are empty without grains in the heap, and
/// if a grain is so far away in a periodic box that even cells as wide as the box would be too many. Cost: about 30
/// microseconds per contact and grain, ten times as much within 8.5 widths of finite walls.
///
/// Source: Goldhirsch, Granular Matter 12, 239 (2010); supports after Weinhart et al., Granular Matter 14, 289 (2012).
/// Validated by tests/unit/fields_test.cpp, tests/unit/fields_balance_test.cpp, tests/unit/fields_walls_test.cpp and
/// tests/unit/fields_motion_test.cpp.
Fields coarse_grained(const OrderedGrains<2>& grains, const Contacts<2>& contacts, const std::vector<bool>& in_heap,
                      const Box<2>& box, const FieldSettings& settings);

}  // namespace repose
