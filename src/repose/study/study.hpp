// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/comparison/base_comparison.hpp"
#include "repose/sweep/plan.hpp"
#include "repose/sweep/table.hpp"
#include "repose/theory/models.hpp"

#include <string>
#include <vector>

namespace repose {

/// A claim on a single number of a stress model.
struct ModelClaim {
  Claim claim;  ///< `measure` is the name of the number
  std::string model;
  std::vector<theory::Setting> settings;
};

/// A claim on the mean base profile of a point: the largest deviation of a force from that of a model of base forces,
/// of equal weight and width (comparison/base_comparison.hpp), over the largest force of the model.
struct ProfileClaim {
  Claim claim;
  TheoryChoice against;
  bool shear = false;
};

/// A published figure or number: what its source states, the ensemble of runs that tests it, and claims on it.
struct Study {
  std::string name;          ///< "baxter1997.fig3": folder and file
  std::string file;          ///< the study file
  std::string title;         ///< one line
  std::string source;        ///< document, with figure, section or page
  std::string states;        ///< what the source states
  std::string remark;        ///< what a reader must know of assumptions and findings; "" without
  std::string ensemble;      ///< path of the sweep file; "" where models alone are judged
  bool force_range = false;  ///< the base forces that equilibrium allows rigid grains are computed, too
  SweepPlan plan;            ///< that of the ensemble, with the claims of the study
  std::vector<ModelClaim> model_claims;
  std::vector<ProfileClaim> profile_claims;
  std::string figure;  ///< the table [figure] as JSON
};

/// A study found in a folder, before it is read.
struct StudyFile {
  std::string name;
  std::string path;
};

/// The studies FOLDER/GROUP/NAME.toml of a folder, as "GROUP.NAME", in order of their numbers. Throws InputError if
/// there are none.
std::vector<StudyFile> find_studies(const std::string& folder);

/// Those that are named: "GROUP.NAME", "GROUP" for all of it, or "all". Throws InputError for an unknown name.
std::vector<StudyFile> chosen_studies(const std::vector<StudyFile>& all, const std::vector<std::string>& names);

/// Reads and checks a study with its ensemble and scenes. Throws InputError with every problem.
Study read_study(const StudyFile& file, SweepForm form);

/// The study with its verdicts as JSON; `table` is that of the ensemble in `folder` (both empty without one), `place`
/// the folder that the text is for. A number of a model is exact, unless the
/// model draws random numbers and has its standard error. The deviation of a profile is exact where all members have
/// the same profile, undecided where they differ, and not determined for rigid grains. Validated by
/// tests/cli/test_study.py.
std::string study_json(const Study& study, SweepForm form, const SweepTable& table, const std::string& folder,
                       const std::string& place);

/// The verdicts of such a text, two lines each.
std::string study_text(const std::string& json);

}  // namespace repose
