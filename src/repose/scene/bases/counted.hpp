// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// A base whose width, and that of the box, is a whole number of diameters.
class CountedBase : public BaseKind {
 public:
  std::int64_t count = 32;

  void check(const Scene& scene, Problems& problems) const override;
  std::optional<double> box_half_width(const Scene& scene) const override;

 protected:
  void count_key(Parameters& keys);
  std::string width_text() const;
};

/// Touching discs from side to side of the box.
struct ContiguousBase final : KindOf<ContiguousBase, CountedBase> {
  static constexpr std::string_view kind = "contiguous";
  static constexpr std::string_view meaning = "touching discs of diameter d from side to side of the box";

  std::string material;

  bool suits(const MethodTraits&) const override { return true; }
  void keys(const Scene& scene, Parameters& keys) override {
    count_key(keys);
    if (scene.method->traits().has_forces()) material_key("base.material", material, scene, keys);
  }
  bool of_grains() const override { return true; }
  bool of_one_size() const override { return true; }
  double reach(const Scene& scene) const override { return *box_half_width(scene); }
  double height_on_top(const Scene& scene, double diameter) const override;
  std::string describe() const override { return "contiguous, " + width_text(); }
  using BaseKind::add_grains;
  void add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const override;
};

/// The floor, half a diameter below height 0, for discs that are put in place.
struct FlatBase final : KindOf<FlatBase, CountedBase> {
  static constexpr std::string_view kind = "flat";
  static constexpr std::string_view meaning = "the floor, half a diameter below height 0";

  bool suits(const MethodTraits& method) const override { return !method.follows_time; }
  void keys(const Scene&, Parameters& keys) override { count_key(keys); }
  std::string describe() const override { return "flat, " + width_text(); }
};

/// A flat floor at height 0 for spheres that are put in place.
struct FloorBase final : KindOf<FloorBase, BaseKind> {
  static constexpr std::string_view kind = "floor";
  static constexpr std::string_view meaning = "a flat floor at height 0";

  bool suits(const MethodTraits& method) const override { return !method.follows_time; }
  bool in_dimension(std::int64_t dimension) const override { return dimension == 3; }
  void keys(const Scene&, Parameters&) override {}
};

/// Discs on that floor at random places.
struct DisorderedBase final : KindOf<DisorderedBase, CountedBase> {
  static constexpr std::string_view kind = "disordered";
  static constexpr std::string_view meaning = "discs of diameter d at random places on that floor until no more fit";

  bool suits(const MethodTraits& method) const override { return !method.follows_time; }
  void keys(const Scene&, Parameters& keys) override { count_key(keys); }
  std::string describe() const override { return "disordered, " + width_text(); }
  using BaseKind::add_grains;
  void add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const override;
};

}  // namespace repose
