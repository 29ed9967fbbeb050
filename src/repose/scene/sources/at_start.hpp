// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/source_kind.hpp"

#include <optional>

namespace repose {

/// All grains exist at the start, placed or read from elsewhere.
struct NoSource final : KindOf<NoSource, SourceKind> {
  static constexpr std::string_view kind = "none";
  static constexpr std::string_view meaning = "all grains exist at the start, placed or read from elsewhere";

  bool in_dimension(std::int64_t) const override { return true; }
  void keys(const Scene&, Parameters&) override {}
  void check(const Scene& scene, Problems& problems) const override;
  std::string describe() const override { return ""; }
};

/// The discs that a method puts in place by itself.
struct DepositedDiscs final : KindOf<DepositedDiscs, SourceKind> {
  static constexpr std::string_view kind = "discs";
  static constexpr std::string_view meaning = "put in place by the method";

  std::int64_t count = 1000;

  bool suits(const MethodTraits& method) const override { return !method.follows_time; }
  void keys(const Scene&, Parameters& keys) override {
    keys.integer("source.count", count, {.low = 1}, "discs to deposit");
  }
  void check(const Scene& scene, Problems& problems) const override;
  std::int64_t released() const override { return count; }
  double expected_end(const Scene&) const override { return static_cast<double>(count); }
  double expected_work(const Scene&, double time) const override { return time; }
  std::string describe() const override;
};

/// The spheres that a method puts in place by itself.
struct DepositedSpheres final : KindOf<DepositedSpheres, SourceKind> {
  static constexpr std::string_view kind = "spheres";
  static constexpr std::string_view meaning = "put in place by the method";

  std::int64_t count = 1000;
  std::optional<double> radius;  ///< [L]

  bool suits(const MethodTraits& method) const override { return !method.follows_time; }
  bool in_dimension(std::int64_t dimension) const override { return dimension == 3; }
  void keys(const Scene&, Parameters& keys) override {
    keys.integer("source.count", count, {.low = 1, .high = 100'000'000}, "spheres to deposit");
    keys.optional_number("source.radius", radius, {"", "all of the box"}, positive, "L",
                         "they are dropped over a disc of this radius about x = y = 0");
  }
  void check(const Scene&, Problems&) const override {}
  std::int64_t released() const override { return count; }
  double expected_end(const Scene&) const override { return static_cast<double>(count); }
  double expected_work(const Scene&, double time) const override { return time; }
  std::string describe() const override;
};

}  // namespace repose
