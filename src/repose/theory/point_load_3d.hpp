// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <string>

namespace repose::theory {

/// The stress at depth h below a vertical force F on the level surface of an elastic medium in three dimensions: a half
/// space, or a layer on a rigid floor at depth h. Lengths are in h, stresses in F/h^2, compression is positive. Source:
/// Boussinesq; Johnson, Contact Mechanics (1985), eq. (3.20); derived in docs/theory/point-load-3d.md. Validated by
/// tests/theory/point_load_3d_test.cpp.
struct PointLoad3d {
  double load_radius = 0.0;    ///< [h] radius of the disc that carries the force evenly; 0: a point
  std::string floor = "none";  ///< at depth h: none (half space), smooth-rigid, rough-rigid
  double poisson = 0.25;       ///< in [0, 1/2]
  double range = 2.0;          ///< [h]
  std::int64_t points = 401;

  static constexpr ModelText text{.name = "point-load-3d",
                                  .about =
                                      "Stress at depth below a force on the surface of an elastic half space or "
                                      "layer, in three dimensions",
                                  .source = "Boussinesq; Johnson 1985, eq. (3.20); docs/theory/point-load-3d.md"};
};

/// Stresses [F/h^2] on a horizontal plane.
struct PlaneStresses {
  double vertical = 0.0;  ///< sigma_zz
  double shear = 0.0;     ///< sigma_rz, positive if the material above pushes that below outward
  double radial = 0.0;    ///< sigma_rr
  double hoop = 0.0;      ///< sigma_phiphi
};

/// The stresses at depth h in a half space below a point load, at the distance r [h] from its axis.
PlaneStresses boussinesq(double poisson, double r_over_h);

/// The fraction of F that a half space carries within the distance r [h] at depth h, below a point load.
double boussinesq_carried(double r_over_h);

/// The vertical stress [F/h^2] at depth h.
double vertical_stress(const PointLoad3d& model, double r_over_h);

void parameters(PointLoad3d& model, Parameters& to);

/// A table with the columns r_over_h, vertical and plane (the response in plane strain, in F/h); for a point load on a
/// half space also shear, radial, hoop and carried. Its numbers are the peak and the half widths.
Table evaluate(const PointLoad3d& model);

}  // namespace repose::theory
