// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/base_profile.hpp"
#include "repose/theory/models.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// What a run, or the mean of an ensemble, says of the forces on its base.
struct MeasuredBase {
  BaseProfile discs;                  ///< normal and shear on each base disc [grain weights]
  BinnedProfile bins;                 ///< the same in bins, with standard errors
  double centre = 0.0;                ///< [L] of the stretch that the heap loads, see BaseDip
  double half_width = 0.0;            ///< [L] of it
  std::optional<double> slope_deg;    ///< angle of repose, mean of both flanks
  std::int64_t loaded_discs() const;  ///< base discs within that stretch, both ends included
  double weight() const;              ///< [grain weights] normal force on all base discs together
  bool loaded(double x) const;        ///< whether a place [L] lies within that stretch
};

/// A model as the user asks for it.
struct TheoryChoice {
  std::string model;
  std::vector<theory::Setting> settings;
};

/// How well one component of the force agrees over the bins of the loaded stretch.
struct Agreement {
  double chi_square = 0.0;     ///< sum of (residual / standard error)^2, over bins whose error is above 0
  std::int64_t bins = 0;       ///< that it sums over
  std::int64_t degrees = 0;    ///< bins less what was matched to this component: 3 of the normal force, 0 of the shear
  double rms = 0.0;            ///< [grain weights] root mean square residual, over all bins of the stretch
  double rms_over_mean = 0.0;  ///< the same over the mean normal force of these bins
};

/// A model laid on a measured base: force per length on the discs at x = left + x_over_b width, per disc with
/// `spacing`.
struct TheoryComparison {
  theory::Model model;
  std::vector<std::string> from_run;  ///< parameters that were taken from the run
  double weight = 0.0;                ///< [grain weights] total normal force
  double left = 0.0, width = 0.0;     ///< [L] foot and width of the model's base
  double spacing = 0.0;               ///< [L] mean distance of the base discs
  double scale = 0.0;       ///< [grain weights] force on a disc of that spacing per unit of the model's columns
  BinnedProfile residuals;  ///< simulation less model, with the errors of the simulation; loaded bins only
  Agreement normal, shear;

  /// The model with the parameters that are not its defaults.
  std::string label() const;
};

/// The settings of a choice, and what its model has and the run knows: slope_deg; or, where a model has an angle_deg
/// (of friction) that is not given, angle_deg instead, whose slope is its own; base_count, the loaded discs. The names
/// of those taken from the run are appended to `from_run`. Throws InputError where the run has no slope and one is
/// needed.
std::vector<theory::Setting> settings_for(const TheoryChoice& choice, const MeasuredBase& base,
                                          std::vector<std::string>& from_run);

/// Lays a model on a measured base without a free parameter: its total normal force is the measured one, and its normal
/// force falls to a tenth of its maximum where the measured one does (BaseDip). Shear goes by the same scale. Forces on
/// a disc are those of its stretch of base, up to midway between it and its neighbours; bins are means over their
/// discs, as the measured ones are. Throws InputError for a model without a base force, and for bad settings. Validated
/// by tests/unit/theory_comparison_test.cpp.
TheoryComparison compare(const TheoryChoice& choice, const MeasuredBase& base);

/// The same for the table of a model, which has a base force: all but the model and what it took from the run.
TheoryComparison laid_on(const theory::Table& table, const MeasuredBase& base);

/// Names of the models that can be laid on this base: those whose table has x_over_b, normal and shear.
std::vector<std::string> models_of_base_force(const MeasuredBase& base);

}  // namespace repose
