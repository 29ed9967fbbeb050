// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

#include <array>

namespace repose {

/// Grains that fall one by one from random places of a level line.
class DropSource : public SourceKind {
 public:
  std::int64_t count = 0;
  double rate = unset;                ///< [1/T]
  double height = unset;              ///< [L]
  std::string height_above = "base";  ///< or "apex"
  double half_width = unset;          ///< [L]
  double x = 0.0;                     ///< [L]
  std::array<double, 2> velocity{};   ///< [L/T]

  void keys(const Scene& scene, Parameters& keys) override {
    const double d = scene.grains.diameter;
    keys.integer("source.count", count, std::nullopt, {.low = 1}, "grains released in all");
    keys.number("source.rate", rate, required, positive, "1/T", "grains per time; the first at time 0");
    keys.number("source.height", height, {100.0 * d, "100 d"}, positive, "L", "height of the centres at release");
    keys.choice("source.height_above", height_above, {"base", "apex"},
                "the height is above height 0, or above the highest grain that touches something at each release");
    keys.number("source.half_width", half_width, usual_half_width(scene), not_negative, "L",
                "grains are released at x +- this");
    keys.number("source.x", x, any, "L", "centre of the opening");
    keys.vector("source.velocity", velocity, std::array<double, 2>{0.0, 0.0}, "L/T", "velocity at release");
  }
  void check(const Scene& scene, Problems& problems) const override;
  std::int64_t released() const override { return count; }
  bool above_apex() const override { return height_above == "apex"; }
  double fall(const Scene& scene) const override;
  double expected_end(const Scene& scene) const override;
  double expected_work(const Scene& scene, double time) const override;

 protected:
  virtual Default usual_half_width(const Scene& scene) const = 0;
};

struct PourSource final : KindOf<PourSource, DropSource> {
  static constexpr std::string_view kind = "pour";
  static constexpr std::string_view meaning = "poured from an opening, each grain at its own time";

  std::string describe() const override;
  std::unique_ptr<Source> start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id) const override;

 protected:
  Default usual_half_width(const Scene& scene) const override;
};

struct RainSource final : KindOf<RainSource, DropSource> {
  static constexpr std::string_view kind = "rain";
  static constexpr std::string_view meaning = "rained over a width, many at once";

  std::string describe() const override;
  std::unique_ptr<Source> start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id) const override;

 protected:
  Default usual_half_width(const Scene& scene) const override;
};

}  // namespace repose
