// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/stops.hpp"

#include "repose/simulation/simulation.hpp"
#include "repose/simulation/trouble.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

template <int D>
std::optional<Stop> stop_of_source(const Simulation<D>& simulation, const Source<D>& source) {
  const auto& scene = simulation.scene();
  const double fall = std::sqrt(scene.grains.diameter / scene.gravity);
  if (source.done() || source.waiting(simulation.time()) <= source.patience() * fall) return std::nullopt;
  return Stop{Status::failed, source.buried()};
}

template <int D>
std::optional<Stop> stop_after_row(const Simulation<D>& simulation, const Source<D>& source) {
  const auto& scene = simulation.scene();
  const auto& row = simulation.series().back();
  if (row.max_overlap > largest_overlap) return Stop{Status::failed, describe_trouble(simulation)};
  if (const auto* solver = scene.method->solver(); solver != nullptr && solver->stops() && row.solver.unconverged > 0) {
    return Stop{
        Status::failed,
        fmt::format("{} of {} steps to time {:.6g} did not converge: worst residual {:.3g} of gravity times "
                    "time step, method.tolerance = {} (method.unconverged = \"error\")",
                    row.solver.unconverged, row.solver.steps, row.time, row.solver.worst_residual, solver->tolerance)};
  }
  return stop_of_source(simulation, source);
}

template std::optional<Stop> stop_of_source(const Simulation<2>&, const Source<2>&);
template std::optional<Stop> stop_of_source(const Simulation<3>&, const Source<3>&);
template std::optional<Stop> stop_after_row(const Simulation<2>&, const Source<2>&);
template std::optional<Stop> stop_after_row(const Simulation<3>&, const Source<3>&);

}  // namespace repose
