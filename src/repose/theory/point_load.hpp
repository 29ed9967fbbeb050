// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <string>

namespace repose::theory {

/// Vertical stress at depth h below a vertical force F on a level surface, plane strain, lengths in h and stresses in
/// F/h. Three answers: isotropic elasticity (elliptic; Flamant's half plane, or a layer on a rigid floor), OSL, the
/// closure sxx = eta szz + mu sxz (hyperbolic; two rays), and diffusion, the mean of the q-model (parabolic). Sources:
/// Johnson, Contact Mechanics (1985), ch. 2; Bouchaud, Cates and Claudin (1995); Bratberg (2003), eqs (41)-(43), (50).
/// Derived in docs/theory/point-load.md; validated by tests/theory/point_load_test.cpp.
struct PointLoad {
  double load_width = 0.1;                 ///< [h] of the strip that carries the force evenly; 0: a point
  std::string floor = "none";              ///< at depth h: none (half plane), smooth-rigid, rough-rigid
  double poisson = 0.125;                  ///< of plane strain, in [0, 1/2]; a rough floor depends on it
  double eta = 1.0 / 3.0;                  ///< of OSL, > 0
  double mu = 0.0;                         ///< of OSL
  double depth = 20.0;                     ///< h in grain diameters; the width of the diffusive response depends on it
  double diffusion = 0.28867513459481287;  ///< [d] variance of the diffusive response per depth: d/(2 sqrt 3)
  double half_range = 2.0;                 ///< [h]
  std::int64_t points = 401;

  static constexpr ModelText text{
      .name = "point-load",
      .about = "Vertical stress at depth below a force on the surface: elastic, OSL and diffusive",
      .source = "Flamant; Johnson 1985, ch. 2; Bouchaud et al. 1995; Bratberg 2003, eqs (41)-(43), (50)"};
};

/// Vertical stress [F/h] of the elastic medium at x [h] from the load.
double elastic_stress(const PointLoad& model, double x_over_h);

/// Vertical stress on the floor of a layer per vertical stress on its surface, both cos(m x/h).
double floor_transfer(const PointLoad& model, double m);

/// The two rays of OSL at x/h = right > 0 and left < 0, roots of c^2 - mu c - eta = 0. With all of F vertical and no
/// horizontal force their weights are -left/(right - left) and right/(right - left).
struct Rays {
  double left = 0.0;
  double right = 0.0;
  double weight_left = 0.0;
  double weight_right = 0.0;
};
Rays rays(const PointLoad& model);

/// Vertical stress [F/h] of OSL: a box of load_width around each ray, half as high at its very edges.
double osl_stress(const PointLoad& model, double x_over_h);

/// Vertical stress [F/h] by diffusion: a Gaussian of variance diffusion/depth, spread over load_width.
double diffusive_stress(const PointLoad& model, double x_over_h);

void parameters(PointLoad& model, Parameters& to);

/// Columns x_over_h, elastic, osl (not for a point), diffusive; numbers of the rays.
Table evaluate(const PointLoad& model);

}  // namespace repose::theory
