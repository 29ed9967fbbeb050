// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/ordered_grains.hpp"

#include <array>
#include <vector>

namespace repose {

/// Continuum fields of a heap on a grid of square cells. Each field has one value per cell, by ascending y, then x.
/// Values are averages over the cell, so that the sum of the values times cell^2 is the total. In equilibrium, with
/// gravity g, sum over b of d(stress_ab)/dx_b = density g_a + support_a.
struct Fields {
  double width = 0.0;                          ///< [L] standard deviation of the Gaussian
  double cell = 0.0;                           ///< [L] side of a cell
  std::vector<double> x;                       ///< [L] centres of the columns, ascending
  std::vector<double> y;                       ///< [L] centres of the rows, ascending
  std::vector<double> density;                 ///< [M/L^2] of the grains in the heap
  std::vector<double> solid_fraction;          ///< area of their discs per area; overlaps count twice
  std::array<std::vector<double>, 4> stress;   ///< [M/T^2] xx, xy, yx, yy; compression positive
  std::array<std::vector<double>, 2> support;  ///< [M/(L T^2)] x, y: force per area on the heap from outside it
};

/// Coarse-grained fields of the grains flagged `in_heap`, with a Gaussian W of standard deviation `width` [L] > 0:
/// density = sum m_i W(x - x_i), stress_ab = sum over contacts of f_a b_b times the mean of W along b. Here f is the
/// force on the first partner and b the branch from the centre of the second to that of the first, so compression is
/// positive. Partners outside the heap (fixed grains, walls) support it: the branch then runs from the contact point to
/// the centre of the grain in the heap, and the force on that grain enters `support` with W at the contact point.
///
/// Averages over cells of W at a point are exact: products of differences of the normal distribution. Averages along
/// branches use Gauss-Legendre quadrature (relative error below 1e-9 of the peak). Each contribution extends to 8.5
/// widths; 2e-17 of it lies beyond. The weights of the cells telescope, so totals are exact to rounding without
/// normalisation.
///
/// Cells are width/2 wide; in a periodic box they are the largest that divide the width of the box and are no wider.
/// Their edges lie at multiples of the side, in a periodic box from x_min, and columns wrap. Cells are larger if the
/// grid would exceed four million of them. The fields are empty without grains in the heap, and if a grain is so far
/// away in a periodic box that even cells as wide as the box would be too many. Cost: about 25 microseconds per
/// contact.
///
/// Source: Goldhirsch, Granular Matter 12, 239 (2010); supports after Weinhart et al., Granular Matter 14, 289 (2012).
/// Validated by tests/unit/fields_test.cpp.
Fields coarse_grained(const OrderedGrains<2>& grains, const Contacts<2>& contacts, const std::vector<bool>& in_heap,
                      const Box<2>& box, double width);

}  // namespace repose
