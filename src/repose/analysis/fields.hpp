// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <array>
#include <vector>

namespace repose {

/// Continuum fields of a heap on a grid of square cells. Values have one entry per cell, y ascending, then x, and are
/// averages over the cell, so that a sum of values times cell^2 is the total. In equilibrium, with gravity g,
/// sum over b of d(stress_ab)/dx_b = density g_a + support_a.
struct Fields {
  double width = 0.0;                          ///< [L] standard deviation of the Gaussian
  double cell = 0.0;                           ///< [L] side of a cell
  std::vector<double> x;                       ///< [L] centres of the columns, ascending
  std::vector<double> y;                       ///< [L] centres of the rows, ascending
  std::vector<double> density;                 ///< [M/L^2] of grains in the heap
  std::vector<double> solid_fraction;          ///< area of their discs per area; overlaps count twice
  std::array<std::vector<double>, 4> stress;   ///< [M/T^2] xx, xy, yx, yy; compression positive
  std::array<std::vector<double>, 2> support;  ///< [M/(L T^2)] x, y: force per area on the heap from outside it
};

/// Coarse-grained fields of the grains flagged `in_heap` with a Gaussian of standard deviation `width` [L], > 0:
/// density = sum m_i W(x - x_i), stress_ab = sum over contacts of f_a b_b times the mean of W along b. Here f is the
/// force on the first partner and b the branch from the centre of the second to that of the first, so that a push is
/// positive. Partners outside the heap (fixed grains, planes) support it: the branch then runs from the contact point
/// to the centre of the grain in the heap, and the force on that grain enters `support` with W at the contact point.
///
/// Averages over cells are exact for point values, as products of differences of the normal distribution, and by
/// Gauss-Legendre quadrature along branches (relative error below 1e-9 of the peak). Each contribution is spread out to
/// 8.5 widths, beyond which 2e-17 of it lies; what it gives to the cells telescopes, so that totals are exact to
/// rounding without normalisation. Cells are width/2 wide or, in a periodic box, the largest that divide the box's
/// width and are no wider; their edges are at multiples of the side, from x_min in a periodic box, where columns wrap.
/// The cell grows where the grid would exceed four million cells. Without grains in the heap there are no cells, nor
/// where one has flown away in a periodic box, so that too many of the widest cells would be needed. Cost: about 25
/// microseconds per contact.
///
/// Source: Goldhirsch, Granular Matter 12, 239 (2010); supports after Weinhart et al., Granular Matter 14, 289 (2012).
/// Validated by tests/unit/fields_test.cpp.
Fields coarse_grained(const Grains<2>& grains, const Contacts<2>& contacts, const std::vector<bool>& in_heap,
                      const Box<2>& box, double width);

}  // namespace repose
