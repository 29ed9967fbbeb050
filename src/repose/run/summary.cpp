// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run/summary.hpp"

#include "repose/core/version.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

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

}  // namespace

std::string summary_text(const Simulation& simulation, const Contacts<2>& contacts, const Reading& reading) {
  const auto& scene = simulation.scene();
  const bool observed = !simulation.series().empty();
  const SeriesRow last = observed ? simulation.series().back() : SeriesRow{};
  const double seconds = simulation.wall_seconds();
  Json json;
  json["title"] = scene.title;
  json["repose_version"] = version;
  json["method"] = scene.method.kind;
  json["seed"] = scene.seed;
  json["status"] = status_text(simulation.status());
  json["stop_reason"] = simulation.message();
  json["grains"] = moving_count(simulation.grains());
  json["grains_released"] = simulation.released();
  json["grains_lost"] = simulation.grains_lost();
  json["contacts"] = reading.network.contacts;
  json["force_threshold"] = scene.analysis.force_threshold;
  json["time"] = simulation.time();
  json["steps"] = simulation.steps();
  json["time_step"] = simulation.time_step();
  json["velocities"] = scene.synchronised() ? "synchronised" : "half-step";
  json["threads"] = simulation.threads();
  json["wall_seconds"] = seconds;
  json["grain_steps_per_second"] = seconds > 0.0 ? number(simulation.grain_steps() / seconds) : Json(nullptr);
  json["kinetic_energy_per_grain"] = observed ? number(last.kinetic_energy_per_grain) : Json(nullptr);
  json["force_residual"] = observed ? number(last.force_residual) : Json(nullptr);
  json["max_overlap"] = number(max_overlap(contacts));
  json["solid_fraction"] = nullptr;
  json["coordination"] = number(reading.network.coordination);
  json["anisotropy"] = number(reading.network.anisotropy);
  json["fabric_direction_deg"] = number(reading.network.direction_deg);
  json["connectivity"] = reading.network.coordination ? Json(reading.network.connectivity) : Json(nullptr);
  json["angle_of_repose_deg"] = angle(reading.heap);
  json["heap_height"] = reading.heap.surface.empty() ? Json(nullptr) : Json(reading.heap.apex_height);
  json["base_profile"] = base_profile(reading.base);
  json["base_dip"] = dip_json(reading.dip);
  json["weight_error"] = number(reading.weight_error);
  return json.dump(2) + "\n";
}

}  // namespace repose
