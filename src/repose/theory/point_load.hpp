// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <string>

namespace repose::theory {

/// The vertical stress at depth h below a vertical force F on a level surface, in plane strain. Lengths are in h,
/// stresses in F/h. It has three answers: isotropic elasticity (elliptic; Flamant's half plane, or a layer on a rigid
/// floor); OSL, the closure sxx = eta szz + mu sxz (hyperbolic; two rays); and diffusion, the mean of the q-model
/// (parabolic). Source: Johnson, Contact Mechanics (1985), ch. 2; Bouchaud, Cates and Claudin (1995); Bratberg (2003),
/// eqs (41)-(43), (50); derived in docs/theory/point-load.md. Validated by tests/theory/point_load_test.cpp.
struct PointLoad {
  double load_width = 0.1;                 ///< [h] width of the strip that carries the force evenly; 0: a point
  std::string floor = "none";              ///< at depth h: none (half plane), smooth-rigid, rough-rigid
  double poisson = 0.125;                  ///< in plane strain, in [0, 1/2]; only a rough floor depends on it
  double eta = 1.0 / 3.0;                  ///< eta of OSL, > 0
  double mu = 0.0;                         ///< mu of OSL
  double depth = 20.0;                     ///< h in grain diameters; sets the width of the diffusive response
  double diffusion = 0.28867513459481287;  ///< [d] variance of the diffusive response per depth: d/(2 sqrt 3)
  double half_range = 2.0;                 ///< [h]
  std::int64_t points = 401;

  static constexpr ModelText text{
      .name = "point-load",
      .about = "Vertical stress at depth below a force on the surface: elastic, OSL and diffusive",
      .source = "Flamant; Johnson 1985, ch. 2; Bouchaud et al. 1995; Bratberg 2003, eqs (41)-(43), (50)"};
};

/// The vertical stress [F/h] of the elastic medium at x [h] from the load.
double elastic_stress(const PointLoad& model, double x_over_h);

/// The amplitude of the vertical stress on the floor of a layer divided by that on its surface, both as cos(m x/h).
double floor_transfer(const PointLoad& model, double m);

/// The two rays of OSL at x/h = right > 0 and left < 0, the roots of c^2 - mu c - eta = 0. F is vertical, so their
/// weights are -left/(right - left) for the right ray and right/(right - left) for the left one.
struct Rays {
  double left = 0.0;
  double right = 0.0;
  double weight_left = 0.0;
  double weight_right = 0.0;
};
Rays rays(const PointLoad& model);

/// The vertical stress [F/h] of OSL: a box of width load_width around each ray, half as high exactly at its edges.
double osl_stress(const PointLoad& model, double x_over_h);

/// The vertical stress [F/h] by diffusion: a Gaussian of variance diffusion/depth, averaged over load_width.
double diffusive_stress(const PointLoad& model, double x_over_h);

void parameters(PointLoad& model, Parameters& to);

/// A table with the columns x_over_h, elastic, osl (not for a point load) and diffusive, and the numbers of the rays.
Table evaluate(const PointLoad& model);

}  // namespace repose::theory
