// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/summary.hpp"

#include "repose/analysis/statistics.hpp"
#include "repose/core/errors.hpp"
#include "repose/core/version.hpp"
#include "repose/io/hash.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace repose {

namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
Json number(const std::optional<double>& x) { return x ? number(*x) : Json(nullptr); }

Json angle(const HeapShape& heap) {
  const auto left = heap.left ? Json(heap.left->angle_deg) : Json(nullptr);
  const auto right = heap.right ? Json(heap.right->angle_deg) : Json(nullptr);
  const auto mean =
      heap.left && heap.right ? Json(0.5 * (heap.left->angle_deg + heap.right->angle_deg)) : Json(nullptr);
  return {{"left", left}, {"right", right}, {"mean", mean}, {"moments", number(heap.moments_angle_deg)}};
}

Json base_profile(const BaseProfile& base) {
  if (base.x.empty()) return nullptr;
  return {
      {"x", base.x}, {"normal", base.normal}, {"shear", base.shear}, {"window", {base.window_start, base.window_end}}};
}

Json dip_json(const std::optional<BaseDip>& dip) {
  if (!dip) return nullptr;
  return {{"index", dip->index}, {"centre", dip->centre}, {"half_width", dip->half_width}};
}

Json core_json(const CoreRegion& core) {
  if (core.grains == 0) return nullptr;
  return {{"grains", core.grains},
          {"solid_fraction", number(core.solid_fraction)},
          {"coordination", number(core.coordination)}};
}

Json forces_json(const std::optional<ForceStatistics>& forces, double weight) {
  if (!forces) return nullptr;
  return {{"mean", weight > 0.0 ? number(forces->mean / weight) : Json(nullptr)},
          {"strong_fraction", forces->strong_fraction},
          {"sliding_fraction", forces->sliding_fraction}};
}

Json chains_json(const Chains& chains) {
  if (chains.list.empty()) return nullptr;
  double contacts = 0.0;
  for (const auto& chain : chains.list) contacts += static_cast<double>(chain.contacts);
  const auto& largest = chains.list.front();
  return {{"count", chains.list.size()},
          {"mean_contacts", contacts / static_cast<double>(chains.list.size())},
          {"largest_contacts", largest.contacts},
          {"largest_height", largest.height}};
}

/// Means over the events of one kind; the waiting time of the first is not defined and does not count.
template <class Event, class Value>
Json mean_over(const std::vector<Event>& events, const Value& value) {
  std::vector<double> values;
  for (const auto& event : events) values.push_back(static_cast<double>(value(event)));
  return number(mean_of(values).mean);
}

Json avalanches_json(const Motion& motion) {
  if (motion.rows.empty()) return nullptr;
  const auto& list = motion.avalanches;
  std::size_t largest = 0;
  for (const auto& event : list) largest = std::max(largest, event.size);
  return {{"count", list.size()},
          {"largest_size", largest},
          {"mean_size", mean_over(list, [](const auto& event) { return event.size; })},
          {"mean_duration", mean_over(list, [](const auto& event) { return event.duration; })},
          {"mean_waiting", mean_over(list, [](const auto& event) { return event.waiting; })},
          {"mean_depth", mean_over(list, [](const auto& event) { return event.depth; })}};
}

Json bursts_json(const Motion& motion) {
  if (motion.rows.empty()) return nullptr;
  const auto& list = motion.bursts;
  return {{"count", list.size()},
          {"mean_peak", mean_over(list, [](const auto& event) { return event.peak; })},
          {"mean_duration", mean_over(list, [](const auto& event) { return event.duration; })},
          {"mean_waiting", mean_over(list, [](const auto& event) { return event.waiting; })}};
}

Json estimate(const Estimate& value) { return {{"mean", number(value.mean)}, {"error", number(value.error)}}; }

Json tensor_json(const FabricTensor& tensor) {
  return {{"xx", number(tensor.xx)},
          {"yy", number(tensor.yy)},
          {"xy", number(tensor.xy)},
          {"anisotropy", estimate(tensor.anisotropy)},
          {"direction_deg", estimate(tensor.direction_deg)}};
}

Json exponent(const std::optional<Estimate>& value) { return value ? estimate(*value) : Json(nullptr); }

Json packing_json(const Results& results, const Scene& scene) {
  if (!results.packing_problem.empty()) return {{"problem", results.packing_problem}};
  if (!results.packing) return nullptr;
  const auto& packing = *results.packing;
  const auto& slab = packing.slab;
  Json json = {
      {"slab",
       {{"low", slab.low}, {"high", slab.high}, {"base_height", slab.base_height}, {"mean_height", slab.mean_height}}},
      {"contact_gap", scene.analysis.contact_gap},
      {"discs", packing.discs},
      {"discs_in_slab", packing.coordination.discs},
      {"solid_fraction", estimate(packing.solid_fraction)},
      {"coordination", estimate(packing.coordination.mean)},
      {"coordination_without_rattlers", estimate(packing.coordination.without_rattlers)},
      {"rattlers", number(packing.coordination.rattlers)},
      {"connectivity_error", packing.coordination.connectivity_error}};
  // By name too: a sweep makes measures of numbers, not of lists.
  for (std::size_t q = 0; q < packing.coordination.connectivity.size(); ++q) {
    json[fmt::format("P_{}", q)] = number(packing.coordination.connectivity[q]);
  }
  json["fabric"] = packing.fabric ? tensor_json(packing.fabric->all) : Json(nullptr);
  json["fabric_folded"] = packing.fabric ? tensor_json(packing.fabric->folded) : Json(nullptr);
  json["regime"] = packing.regime ? Json(name_of(*packing.regime)) : Json(nullptr);
  json["regime_by_structure"] =
      packing.regime_by_structure ? Json(name_of(*packing.regime_by_structure)) : Json(nullptr);
  if (packing.surface) {
    json["roughness"] = number(packing.surface->roughness);
    json["roughness_exponent"] = exponent(packing.surface->scaling.exponent);
    json["growth_exponent"] = exponent(packing.surface->growth.exponent);
  }
  if (packing.local_density) {
    json["local_density"] = {{"mean", number(packing.local_density->density.mean)},
                             {"deviation", number(packing.local_density->density.deviation)}};
  }
  if (scene.method->sticking_angle()) json["discs_breaking_rule"] = results.breaking_rule;
  return json;
}

/// The packing's own measures of contacts, for a method whose contacts carry no forces.
void put_packing(const Packing& packing, Json& json) {
  json["coordination"] = number(packing.coordination.mean.mean);
  json["connectivity"] = packing.coordination.connectivity;
  if (!packing.fabric) return;
  json["anisotropy"] = number(packing.fabric->all.anisotropy.mean);
  json["fabric_direction_deg"] = number(packing.fabric->folded.direction_deg.mean);
}

/// What the solver did in the whole run.
Json solver_json(const Record& record) {
  const auto* solver = record.scene.method->solver();
  if (solver == nullptr) return nullptr;
  const auto all = solver_account(record);
  const auto steps = static_cast<double>(all.steps);
  return {{"steps", all.steps},
          {"sweeps_per_step", all.steps > 0 ? Json(static_cast<double>(all.sweeps) / steps) : Json(nullptr)},
          {"contact_iterations", all.contact_iterations},
          {"unconverged", all.unconverged},
          {"worst_residual", number(all.worst_residual)},
          {"tolerance", solver->tolerance},
          {"creep_rate", record.series.empty() ? Json(nullptr) : number(record.series.back().creep_rate)}};
}

constexpr std::string_view last_key = ",\n  \"checksum\": ";
/// No text inside a JSON document has a line break, so that only a key of the summary itself begins so.
constexpr std::string_view theory_key = ",\n  \"theory\": ";

/// The end of a summary whose text begins so: the hash of that, under the last key.
std::string ending(std::string_view beginning) { return fmt::format("{}\"{}\"\n}}\n", last_key, hash_of(beginning)); }

}  // namespace

std::string summary_text(const Record& record, const Results& results) {
  const auto& scene = record.scene;
  const auto& facts = record.facts;
  const bool observed = !record.series.empty();
  const SeriesRow last = observed ? record.series.back() : SeriesRow{};
  const double seconds = facts.wall_seconds;
  Json json;
  json["title"] = scene.title;
  json["repose_version"] = version;
  json["method"] = scene.method->name();
  json["seed"] = scene.seed;
  json["status"] = status_text(facts.status);
  json["stop_reason"] = facts.message;
  json["grains"] = moving_count(record.grains);
  json["grains_released"] = facts.released;
  json["grains_lost"] = facts.lost;
  json["contacts"] = results.network.contacts;
  json["force_threshold"] = scene.analysis.force_threshold;
  json["time"] = facts.time;
  json["steps"] = facts.steps;
  json["time_step"] = facts.time_step;
  json["velocities"] = scene.synchronised() ? "synchronised" : "half-step";
  json["threads"] = facts.threads;
  json["wall_seconds"] = seconds;
  json["grain_steps_per_second"] = seconds > 0.0 ? number(facts.grain_steps / seconds) : Json(nullptr);
  json["kinetic_energy_per_grain"] = observed ? number(last.kinetic_energy_per_grain) : Json(nullptr);
  json["force_residual"] = observed ? number(last.force_residual) : Json(nullptr);
  json["max_overlap"] = number(results.max_overlap);
  json["solid_fraction"] = results.packing ? number(results.packing->solid_fraction.mean) : Json(nullptr);
  json["coordination"] = number(results.network.coordination);
  json["anisotropy"] = number(results.network.anisotropy);
  json["fabric_direction_deg"] = number(results.network.direction_deg);
  json["connectivity"] = results.network.coordination ? Json(results.network.connectivity) : Json(nullptr);
  json["angle_of_repose_deg"] = angle(results.heap);
  json["heap_height"] = results.heap.surface.empty() ? Json(nullptr) : Json(results.heap.apex_height);
  json["core"] = core_json(results.core);
  json["forces"] = forces_json(results.forces, scene.grain_weight());
  json["chains"] = chains_json(results.chains);
  json["avalanches"] = avalanches_json(results.motion);
  json["bursts"] = bursts_json(results.motion);
  json["base_profile"] = base_profile(record.base);
  json["base_dip"] = dip_json(results.dip);
  json["base_scatter"] = number(results.base_scatter);
  json["weight_error"] = number(results.weight_error);
  json["field_weight_error"] = number(results.field_weight_error);
  json["packing"] = packing_json(results, scene);
  json["solver"] = solver_json(record);
  if (const auto angle = scene.method->sticking_angle()) json["critical_angle"] = *angle;
  if (!scene.method->traits().has_forces()) {
    json["contacts"] = results.packing ? Json(results.packing->contacts) : Json(nullptr);
    for (const auto* key : {"kinetic_energy_per_grain", "force_residual", "force_threshold", "velocities"})
      json[key] = nullptr;
    if (results.packing) put_packing(*results.packing, json);
  }
  json["state_hash"] = facts.state_hash;
  return with_checksum(json.dump(2));
}

std::string with_checksum(std::string json) {
  json.resize(json.rfind("\n}"));
  return json + ending(json);
}

bool is_whole_summary(std::string_view text) {
  const auto end = text.rfind(last_key);
  return end != std::string_view::npos && text.substr(end) == ending(text.substr(0, end));
}

std::string with_theory(const std::string& text, const std::string& theory) {
  REPOSE_ASSERT(is_whole_summary(text));
  auto beginning = text.substr(0, text.rfind(last_key));
  if (const auto older = beginning.find(theory_key); older != std::string::npos) beginning.resize(older);
  if (!theory.empty()) beginning += std::string{theory_key} + theory;
  return beginning + ending(beginning);
}

std::string summary_status(const std::string& text) {
  if (!is_whole_summary(text)) return "";
  const auto json = Json::parse(text, nullptr, false);
  return json.is_object() ? json.value("status", std::string()) : std::string();
}

}  // namespace repose
