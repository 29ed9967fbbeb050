// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <array>
#include <vector>

namespace repose {

/// Coarse-grained fields on square cells; values are averages over a cell, row by row: y ascending, then x.
struct Fields {
  double width = 0.0;                          ///< [L] standard deviation of the Gaussian
  double cell = 0.0;                           ///< [L] side of a cell
  std::vector<double> x, y;                    ///< [L] centres of the columns and rows
  std::vector<double> density;                 ///< [M/L^2]
  std::vector<double> solid_fraction;          ///< disc area per area
  std::array<std::vector<double>, 4> stress;   ///< [M/T^2] xx, xy, yx, yy; compression positive
  std::array<std::vector<double>, 2> support;  ///< [M/(L T^2)] force of fixed grains and planes on the heap, x and y
};

/// Coarse-grained density and contact stress of the grains flagged `in_heap` (Goldhirsch, Granular Matter 12, 239,
/// 2010), with the supports' forces as a field of their own (Weinhart et al., Granular Matter 14, 289, 2012), so that
/// the balance d_b stress_ab = support_a + density g_a holds up to and across the base:
///   stress_ab(r) = sum over contacts f_a b_b int_0^1 W(r - r_1 - s b) ds, f on the first partner, b the branch to it:
/// from centre to centre between two grains of the heap, from the contact point to the centre at a support.
/// W is a Gaussian, averaged over each cell without error by differences of its distribution function; the grid
/// reaches out to 8.5 widths, beyond which lies 1e-17 of it, so that sums over all cells are exact to rounding. Cells
/// are half a width wide, wider where there would be more than four million (in a periodic box they divide its width).
Fields coarse_grained(const Grains<2>& grains, const Contacts<2>& contacts, const std::vector<bool>& in_heap,
                      const Box<2>& box, double width);

}  // namespace repose
