// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

#include <vector>

namespace repose {

/// Grains that fall one by one from random places of a level line, of a disc or of a rectangle.
class DropSource : public SourceKind {
 public:
  std::int64_t count = 0;
  double rate = unset;                ///< [1/T]
  double height = unset;              ///< [L]
  std::string height_above = "base";  ///< or "apex"
  std::string opening = "line";       ///< in three dimensions "disc" or "rectangle"
  double half_width = unset;          ///< [L] of a line or rectangle
  double half_depth = unset;          ///< [L] of a rectangle, along y
  double radius = unset;              ///< [L] of a disc
  double x = 0.0;                     ///< [L]
  double y = 0.0;                     ///< [L] in three dimensions
  Coordinates velocity{};             ///< [L/T]

  void keys(const Scene& scene, Parameters& keys) override {
    const double d = scene.grains.diameter;
    keys.integer("source.count", count, std::nullopt, {.low = 1}, "grains released in all");
    keys.number("source.rate", rate, required, positive, "1/T", "grains per time; the first at time 0");
    keys.number("source.height", height, {100.0 * d, "100 d"}, positive, "L", "height of the centres at release");
    keys.choice("source.height_above", height_above, {"base", "apex"},
                "the height is above height 0, or at each release above the highest of the discs that touch something, "
                "or of the spheres that hang together with base or walls");
    opening_keys(scene, keys);
    keys.vector("source.velocity", velocity, scene.dimension, Coordinates{}, "L/T", "velocity at release");
  }
  bool in_dimension(std::int64_t) const override { return true; }

  /// The place [L] of two numbers from 0 to 1, which are spread evenly over the opening; its height is not set.
  template <int D>
  Vec<D> place(double first, double second) const;
  void check(const Scene& scene, Problems& problems) const override;
  std::int64_t released() const override { return count; }
  bool above_apex() const override { return height_above == "apex"; }
  double fall(const Scene& scene) const override;
  double expected_end(const Scene& scene) const override;
  double expected_work(const Scene& scene, double time) const override;

 protected:
  virtual Default usual_half_width(const Scene& scene) const = 0;
  virtual std::string_view usual_opening() const = 0;  ///< in three dimensions

 private:
  void opening_keys(const Scene& scene, Parameters& keys);
  void check_opening(const Scene& scene, Problems& problems) const;
};

struct PourSource final : KindOf<PourSource, DropSource> {
  static constexpr std::string_view kind = "pour";
  static constexpr std::string_view meaning = "poured from an opening, each grain at its own time";

  std::string describe() const override;
  std::unique_ptr<Source<2>> start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                   Dimension<2>) const override;
  std::unique_ptr<Source<3>> start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                   Dimension<3>) const override;

 protected:
  std::string_view usual_opening() const override { return "disc"; }
  Default usual_half_width(const Scene& scene) const override;
};

struct RainSource final : KindOf<RainSource, DropSource> {
  static constexpr std::string_view kind = "rain";
  static constexpr std::string_view meaning = "rained over a width or an area, many at once";

  std::string describe() const override;
  std::unique_ptr<Source<2>> start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                   Dimension<2>) const override;
  std::unique_ptr<Source<3>> start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                   Dimension<3>) const override;

 protected:
  std::string_view usual_opening() const override { return "rectangle"; }
  Default usual_half_width(const Scene& scene) const override;
};

}  // namespace repose
