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

/// The measured forces on the base of a run, or their mean over an ensemble.
struct MeasuredBase {
  BaseProfile discs;                  ///< normal and shear on each base disc [grain weights]
  BinnedProfile bins;                 ///< the same in bins, with standard errors
  double centre = 0.0;                ///< [L] of the loaded interval, see BaseDip
  double half_width = 0.0;            ///< [L] of the loaded interval
  std::optional<double> slope_deg;    ///< angle of repose, mean of both flanks
  std::int64_t loaded_discs() const;  ///< base discs within the loaded interval, both ends included
  double weight() const;              ///< [grain weights] normal force on all base discs together
  bool loaded(double x) const;        ///< whether x [L] lies within the loaded interval
};

/// A model and settings as the user gives them.
struct TheoryChoice {
  std::string model;
  std::vector<theory::Setting> settings;
};

/// The agreement of one component of the force over the bins of the loaded interval.
struct Agreement {
  double chi_square = 0.0;     ///< sum of (residual / standard error)^2, over bins whose error is above 0
  std::int64_t bins = 0;       ///< in the sum
  std::int64_t degrees = 0;    ///< bins less what was matched to this component: 3 of the normal force, 0 of the shear
  double rms = 0.0;            ///< [grain weights] root mean square residual, over all bins of the interval
  double rms_over_mean = 0.0;  ///< the same over the mean normal force of these bins
};

/// A model compared with a measured base: force per length on the discs at x = left + x_over_b width, per disc with
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

/// The settings of a choice, completed from the run where its model has the parameter: angle_deg (the angle of
/// friction, which sets the slope of its model) or else slope_deg from the angle of repose; base_count from the loaded
/// discs. Appends the names of the completed ones to `from_run`. Throws InputError where the run has no slope and one
/// is needed.
std::vector<theory::Setting> settings_for(const TheoryChoice& choice, const MeasuredBase& base,
                                          std::vector<std::string>& from_run);

/// Compares a model with a measured base without a free parameter: its total normal force is the measured one, and its
/// normal force falls to a tenth of its maximum where the measured one does (BaseDip). Shear goes by the same scale.
/// The force on a disc is that on its part of the base, up to midway to its neighbours; bins are means over their
/// discs, as the measured ones are. Throws InputError for a model without a base force, and for bad settings. Validated
/// by tests/unit/theory_comparison_test.cpp.
TheoryComparison compare(const TheoryChoice& choice, const MeasuredBase& base);

/// The same for the table of a model that has a base force. Leaves `model` and `from_run` of the result empty.
TheoryComparison compare_table(const theory::Table& table, const MeasuredBase& base);

/// Names of the models that can be compared with this base: those whose table has x_over_b, normal and shear.
std::vector<std::string> models_of_base_force(const MeasuredBase& base);

}  // namespace repose
