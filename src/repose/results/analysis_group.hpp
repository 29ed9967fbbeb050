// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/groups.hpp"
#include "repose/io/reference_table.hpp"
#include "repose/results/measure.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace repose {

/// A group of analysis.h5, or columns for one that exists.
template <int D>
struct AnalysisGroupIn {
  std::string name;
  std::vector<ReferenceTable> reference;
  /// Writes the group where it has a meaning for the run.
  std::function<void(Hdf5File&, const MeasuredIn<D>&)> write;
};
using AnalysisGroup = AnalysisGroupIn<2>;

/// A group made from a `Part` of the results: `part` gives a pointer to it or a std::optional, empty where the group
/// has no meaning.
template <class Part, int D = 2, class Get>
AnalysisGroupIn<D> analysis_group(const Group<Part>& group, Get part) {
  AnalysisGroupIn<D> made{group.name, reference_of(group), {}};
  made.write = [group, part = std::move(part)](Hdf5File& file, const MeasuredIn<D>& run) {
    if (const auto& found = std::invoke(part, run)) write_group(file, group, *found);
  };
  return made;
}

/// The same made from the whole run, written where `exists` is true.
AnalysisGroup analysis_group(const Group<Measured>& group, std::function<bool(const Measured&)> exists);

}  // namespace repose
