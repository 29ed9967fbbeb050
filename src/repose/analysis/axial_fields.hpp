// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/ordered_grains.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace repose {

/// Fields of a heap or column of spheres about an upright axis, averaged over the azimuth, on a grid of rings with
/// rectangular sections. Each field has one value per ring, by ascending z, then r: the average over the ring, so that
/// the sum of the values times `volume` is the total.
struct AxialFields {
  double ring = 0.0;                           ///< [L] width of a ring
  double layer = 0.0;                          ///< [L] its height
  std::vector<double> r;                       ///< [L] middles of the rings, ascending
  std::vector<double> z;                       ///< [L] middles of the layers, ascending
  std::vector<double> volume;                  ///< [L^3] of each ring
  std::vector<double> density;                 ///< [M/L^3] of the grains with their centres in the ring
  std::vector<double> solid_fraction;          ///< volume of their spheres, cut at the ring; overlaps count twice
  std::array<std::vector<double>, 5> stress;   ///< [M/(L T^2)] rr, tt, zz, rz, zr; compression positive
  std::array<std::vector<double>, 2> support;  ///< [M/(L^2 T^2)] r, z: force per volume on the heap from outside it

  std::size_t cell(std::size_t in_r, std::size_t in_z) const { return in_z * r.size() + in_r; }
};

struct AxialSettings {
  Vec<2> axis{};       ///< [L] x, y
  double ring = 0.0;   ///< [L] > 0
  double layer = 0.0;  ///< [L] > 0; edges of layers lie at its multiples above `base`
  double base = 0.0;   ///< [L] z
};

/// Measures the fields of the grains flagged `in_heap`. The stress is the exact average over each ring of the line
/// measure of Irving and Kirkwood,
///   stress_ab(x) = sum over contacts of f_a times the integral of delta(x - s) ds_b along the branch,
/// with f the force on the first partner and the branch from the centre of the second to that of the first; the first
/// index is that of the force, the second that of the normal of the plane through which it acts. Branches are cut at
/// the cylinders and planes of the grid, and components are those of the local radial and azimuthal direction at each
/// point of the branch; all integrals are closed forms. Partners outside the heap (fixed grains, walls) support it: the
/// branch then runs from the contact point to the centre of the grain in the heap, and the force enters `support`
/// there.
///
/// Therefore, to rounding: the density integrates to the mass; the integral of zz over any level plane is the force
/// through it, which at rest is the weight of the centres above it less the support above it; a layer has the mean of
/// that over its height; rr + tt + zz integrates to the sum of f . b. There is no smoothing length, so a ring should be
/// as wide as a grain at least; the noise is largest at the axis, where rings are small. Density and stress belong
/// together (weight at centres); solid_fraction is geometry, by quadrature over 40 columns across a sphere, accurate to
/// about 5e-3 of a sphere in each ring and exact in sum.
///
/// Rings and layers are larger if the grid would exceed four million rings. Empty without grains in the heap. In a
/// periodic box the axis is not repeated. Cost: a few microseconds per contact, twenty per grain.
/// Source: Goldhirsch, Granular Matter 12, 239 (2010), eq. 20 with W a point; Irving and Kirkwood, J. Chem. Phys. 18,
/// 817 (1950). Validated by tests/unit/axial_fields_test.cpp.
AxialFields axial_fields(const OrderedGrains<3>& grains, const Contacts<3>& contacts, const std::vector<bool>& in_heap,
                         const Box<3>& box, const AxialSettings& settings);

}  // namespace repose
