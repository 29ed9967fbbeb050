// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/inference.hpp"
#include "repose/sweep/plan.hpp"
#include "repose/theory/screening_fit.hpp"

#include <string>
#include <vector>

namespace repose {

struct SweepTable;

/// Janssen's law fitted to the masses that carry columns of several heights, each a point of a sweep: with one length,
/// and with two. See docs/physics/columns.md.
struct HeightFit {
  std::string name;
  std::string problem;  ///< why there is none; empty where there is
  std::vector<std::string> points;
  theory::ApparentMasses data;      ///< means over members, by point
  std::vector<double> mass_height;  ///< [M/L] of the whole column, by point
  double members = 0.0;             ///< behind the data
  double mass_per_height = 0.0;     ///< [M/L] that the law is fitted with: mean over the points
  double sense = 1.0;               ///< of the wall friction; -1: pushed up
  double width = 0.0;               ///< [L]
  double friction = 0.0;            ///< of the walls, as mobilised: mean over the points, without sign
  Inference stress_ratio;           ///< K from wall and bottom loads: mean over the points
  theory::ScreeningFit one, two;
  double chance_one = 0.0, chance_two = 0.0;  ///< of a chi-square at least as large if the law holds
};

/// The numbers of a fit by name: "lambda", "lambda_1", "lambda_2", "ratio" (lambda_1/lambda_2), "stress_ratio" (K from
/// lambda), "stress_ratio_direct" (K from the loads), "stress_ratio_excess" (the first less the second), "chance_one",
/// "chance_two".
const std::vector<std::string>& height_fit_measures();

/// One of these, with its error. Errors of the fit are scaled by (chi-square/degrees of freedom)^(1/2) where that is
/// above 1, so that a law that does not hold is not given errors that are too small; the degrees of freedom of
/// Student's t are members less points. A chance has no error.
Inference infer(const HeightFit& fit, const std::string& measure);

/// The fits of a plan, in their order.
std::vector<HeightFit> fit_heights(const SweepPlan& plan, const SweepTable& table);

/// heights.csv: a row per point of each fit. heights.json: an object per fit.
std::string heights_csv(const std::vector<HeightFit>& fits);
std::string heights_json(const std::vector<HeightFit>& fits);

}  // namespace repose
