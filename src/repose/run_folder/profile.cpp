// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/profile.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <vector>

namespace repose {

namespace {

double total(const std::vector<Profile::Line>& lines) {
  double seconds = 0.0;
  for (const auto& line : lines) seconds += line.seconds;
  return seconds;
}

/// Grain-steps per second of the time in which the run advanced.
template <int D>
double rate(const Simulation<D>& simulation) {
  return simulation.wall_seconds() > 0.0 ? simulation.grain_steps() / simulation.wall_seconds() : 0.0;
}

}  // namespace

template <int D>
std::string describe_profile(const Simulation<D>& simulation) {
  const auto lines = simulation.profile()->lines();
  const double all = total(lines);
  auto text = fmt::format("\n{:24}{:>11}{:>8}{:>11}\n", "stage", "seconds", "%", "calls");
  const auto add = [&](std::string_view name, double seconds, const std::string& calls) {
    text += fmt::format("{:24}{:11.4f}{:8.1f}{:>11}\n", name, seconds, 100.0 * seconds / all, calls);
  };
  for (const auto& line : lines) add(line.name, line.seconds, line.calls > 0 ? fmt::format("{}", line.calls) : "");
  add("all", all, "");
  return text + fmt::format("{:.3g} million grain-steps per second\n", rate(simulation) / 1e6);
}

template <int D>
std::string profile_text(const Simulation<D>& simulation) {
  const auto lines = simulation.profile()->lines();
  nlohmann::ordered_json json;
  json["seconds"] = total(lines);
  json["threads"] = simulation.threads();
  json["steps"] = simulation.steps();
  json["grain_steps_per_second"] = rate(simulation);
  for (const auto& line : lines) {
    json["stages"].push_back({{"name", line.name}, {"seconds", line.seconds}, {"calls", line.calls}});
  }
  return json.dump(2) + "\n";
}

template std::string describe_profile(const Simulation<2>&);
template std::string describe_profile(const Simulation<3>&);
template std::string profile_text(const Simulation<2>&);
template std::string profile_text(const Simulation<3>&);

}  // namespace repose
