// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"
#include "repose/simulation/sources/source.hpp"

#include <optional>
#include <string>

namespace repose {

template <int D>
class Simulation;

/// The end of a run and the reason for it.
struct Stop {
  Status status = Status::finished;
  std::string message;
};

/// The stop because a grain has waited for room for too long, if it has.
template <int D>
std::optional<Stop> stop_of_source(const Simulation<D>& simulation, const Source<D>& source);

/// The stop that the last row of the series calls for, if any: trouble.
template <int D>
std::optional<Stop> stop_after_row(const Simulation<D>& simulation, const Source<D>& source);

}  // namespace repose
