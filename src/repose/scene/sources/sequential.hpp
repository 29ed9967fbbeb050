// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// Grains that are laid down one by one, each once all others are at rest. Rigid grains alone come to rest so well.
struct SequentialSource final : KindOf<SequentialSource, SourceKind> {
  static constexpr std::string_view kind = "sequential";
  static constexpr std::string_view meaning = "laid down one by one, each once all others are at rest";

  std::int64_t count = 1000;
  double height = unset;      ///< [L] above the place where the grain first touches something
  double half_width = unset;  ///< [L]
  double x = 0.0;             ///< [L]
  double rest = 5e-3;         ///< [gravity times time step]

  bool suits(const MethodTraits& method) const override { return method.follows_time && method.impulse_laws; }
  void keys(const Scene& scene, Parameters& keys) override {
    const double d = scene.grains.diameter;
    const bool of_base = scene.base->of_grains() && !scene.box.periodic();
    keys.integer("source.count", count, {.low = 1}, "grains released in all, each once all others are at rest");
    keys.number("source.height", height, {0.01 * d, "0.01 d"}, not_negative, "L",
                "above the place where the grain first touches another or a wall on its way down");
    keys.number("source.half_width", half_width,
                {of_base ? scene.base->reach(scene) : scene.box.half_width, "all of the base or box"}, not_negative,
                "L", "grains are released at x +- this");
    keys.number("source.x", x, any, "L", "centre of the places of release");
    keys.number("source.rest", rest, positive, "g dt",
                "all are at rest when no velocity and no rim velocity is above this");
  }
  void check(const Scene& scene, Problems& problems) const override;
  std::int64_t released() const override { return count; }
  bool limits_speed() const override { return true; }
  double expected_end(const Scene& scene) const override;
  double expected_work(const Scene& scene, double time) const override;
  std::string describe() const override;
  using SourceKind::start;
  std::unique_ptr<Source<2>> start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                   Dimension<2>) const override;
};

}  // namespace repose
