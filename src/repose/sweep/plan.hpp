// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/read.hpp"
#include "repose/scene/scene.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// A statement about the results of a sweep: a statistic lies between `above` and `below`. The rule that decides it is
/// fixed beforehand: the claim holds if the 95 % interval of the statistic lies within the bounds, fails if it lies
/// wholly outside, and is undecided otherwise (see judge_claims).
struct Claim {
  enum class Kind {
    value,        ///< the mean of one point
    difference,   ///< mean of the first point less that of the second
    equivalence,  ///< the difference between any two of the points, whose bounds are -margin and margin
    fit           ///< a number of a fit over several points (sweep/height_fit.hpp)
  };
  std::string text;
  std::string source;   ///< the paper that states it
  std::string measure;  ///< column of the table
  Kind kind = Kind::value;
  std::vector<std::string> points;  ///< names
  double above = -std::numeric_limits<double>::infinity();
  double below = std::numeric_limits<double>::infinity();
  std::string fit = {};  ///< name of the fit
};

/// Janssen's law is to be fitted to the loads of columns of several heights, each a point.
struct HeightPlan {
  std::string name;
  std::string measure = "column.apparent_mass";  ///< a mass, or a force
  std::vector<std::string> points;               ///< names
  bool pushed_up = false;
};

/// A parameter of a point of a sweep: a key of the scene and its value.
struct Parameter {
  std::string key;
  std::string text;     ///< as TOML
  double number = 0.0;  ///< NaN where the value is not a number
};

/// One set of parameters; every seed of the sweep makes a member of it.
struct SweepPoint {
  std::string name;  ///< unique, fit for the name of a folder
  std::vector<Parameter> parameters;
  Scene scene;  ///< the seed is that of the first member
  /// The point from the ends of whose members those of this one start, seed by seed; it comes before this one. The
  /// scene of a member is then `file` with `overrides`, read when its start exists.
  std::optional<std::size_t> starts_from = {};
  std::string file = {};
  Overrides overrides = {};
};

/// An ensemble: points times seeds, read from a sweep file and checked with all its scenes.
struct SweepPlan {
  std::string title;
  std::vector<std::int64_t> seeds;
  std::vector<std::string> keys;  ///< of the parameters, in order of first appearance
  std::vector<SweepPoint> points;
  std::vector<HeightPlan> fits;
  std::vector<Claim> claims;
};

/// A file of the folder of a sweep; the plan can be read again from these files alone.
struct SweepFile {
  std::string name;  ///< relative to the folder
  std::string text;
  std::string copy_of = {};  ///< the file whose copy it is, in place of a text
};

/// A sweep as its file says, or with the changes of its table [quick], which make it small.
enum class SweepForm { full, quick };

/// Reads a sweep file and the scenes that it names, relative to it. Throws InputError with every problem.
SweepPlan read_sweep(const std::string& path, SweepForm form = SweepForm::full);

/// The sweep file and its scenes as files that stand in one folder: "sweep.toml" first, then "scenes/...". The file is
/// that of its author, with other paths, and form = "quick" before it in the quick form.
std::vector<SweepFile> self_contained(const std::string& path, SweepForm form = SweepForm::full);

}  // namespace repose
