// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

/// Forces on the base, and how well they balance the weight.
void add_base(Registry& to) {
  const auto profile = [](auto member) { return [=](const Measured& run) { return run.record.base.*member; }; };
  const auto dip = [](auto member) { return [=](const Measured& run) { return (*run.results.dip).*member; }; };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(measure("base_profile", "",
              "lists: force of the heap on each base grain, or on a plane of each grain that it carries; in M L/T^2 "
              "without gravity",
              [](const Measured& run) { return run.record.base.x.empty() ? std::nullopt : std::optional(Object{}); }));
  add(measure("base_profile.x", "L", "centres", profile(&BaseProfile::x)));
  add(measure("base_profile.normal", "grain weights", "positive downward", profile(&BaseProfile::normal)));
  add(measure("base_profile.shear", "grain weights", "positive to the right", profile(&BaseProfile::shear)));
  add(measure("base_profile.window", "T", "start and end of the average; one time for a plane",
              [](const Measured& run) {
                return std::vector<double>{run.record.base.window_start, run.record.base.window_end};
              }));
  add(measure("base_dip", "", "whether the load dips under the apex",
              [](const Measured& run) { return run.results.dip ? std::optional(Object{}) : std::nullopt; }));
  add(measure("base_dip.index", "",
              "mean normal force over 0.15-0.45 of the half-width over the mean within 0.15 of the centre",
              dip(&BaseDip::index)));
  add(measure("base_dip.centre", "L",
              "of the loaded base, where the running mean over 5 grains exceeds a tenth of its largest value",
              dip(&BaseDip::centre)));
  add(measure("base_dip.half_width", "L", "of the loaded base", dip(&BaseDip::half_width)));
  add(measure("base_scatter", "",
              "root mean square deviation of the base force from its running mean over 5 grains, over the mean force, "
              "within 0.75 of the half-width",
              [](const Measured& run) { return run.results.base_scatter; }));
  add(measure("weight_error", "",
              "vertical force on fixed grains and walls over the weight of the grains that touch something, less 1",
              [](const Measured& run) { return run.results.weight_error; }));
  to.groups.push_back(analysis_group<BinnedProfile>(
      {"base",
       "bins",
       {attribute("bin_width", &BinnedProfile::bin_width, "L", "`analysis.base_bin`")},
       {
           array("x", &BinnedProfile::x, "L", "centre of the bin"),
           array("count", &BinnedProfile::count, "", "base grains in it"),
           array("normal", &BinnedProfile::normal, "grain weights", "mean over them, positive downward"),
           array("normal_error", &BinnedProfile::normal_error, "grain weights",
                 "standard error of the mean from the scatter between them; NaN for one grain"),
           array("shear", &BinnedProfile::shear, "grain weights", "mean over them, positive to the right"),
           array("shear_error", &BinnedProfile::shear_error, "grain weights",
                 "standard error of the mean from the scatter between them; NaN for one grain"),
       }},
      [](const Measured& run) { return run.results.base.x.empty() ? nullptr : &run.results.base; }));
}

}  // namespace repose
