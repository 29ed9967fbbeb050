// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/deposition/deposition.hpp"

#include "repose/methods/deposition/brute_force.hpp"
#include "repose/methods/deposition/columns.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace repose {

namespace {

using namespace deposition;

/// The supports of a disc; see Rest.
struct Supports {
  std::int32_t first = nothing;
  std::int32_t second = nothing;
};

template <class Search>
class Deposition final : public Method<2> {
 public:
  explicit Deposition(const DepositionSettings& settings) : settings_(settings) {}

  StepReport advance(Grains<2>& grains, long steps, Team& /*team*/) override {
    StepReport report;
    const Roller<Search> roller(settings_, *search_);
    for (; report.steps < steps && made_ < settings_.count; ++report.steps) {
      const auto drop = settings_.drop(made_);
      const auto rest = roller.drop(place_of(drop), drop.grain.radius);
      if (!rest || !std::isfinite(rest->x)) {
        report.trouble = true;
        return report;
      }
      add(grains, drop, *rest);
    }
    return report;
  }

  /// Lists what is there already, and makes room for what is to come.
  void grains_added(Grains<2>& grains) override {
    const auto all = grains.size() + static_cast<std::size_t>(settings_.count - made_);
    grains.reserve(all);
    supports_.reserve(all);
    supports_.resize(grains.size());
    list(grains);
  }

  void refresh(Grains<2>& /*grains*/, Team& /*team*/) override {}

  Contacts<2> contacts(const Grains<2>& grains) const override {
    Contacts<2> contacts;
    std::size_t count = 0;
    for (const auto& support : supports_) count += (support.first >= 0 ? 1U : 0U) + (support.second >= 0 ? 1U : 0U);
    contacts.list.reserve(count);
    for (std::size_t k = 0; k < supports_.size(); ++k) {
      const auto [low, high] = std::minmax(supports_[k].first, supports_[k].second);
      for (const auto support : {low, high}) {
        if (support >= 0) contacts.list.push_back(touch(grains, k, static_cast<std::size_t>(support)));
      }
    }
    return contacts;
  }

  double time_step() const override { return 1.0; }
  void set_loads(const std::vector<Load<2>>& /*loads*/) override {}
  void set_histories(const Grains<2>& /*grains*/, const Contacts<2>& /*contacts*/) override {}
  const std::vector<WallState>& walls() const override { return no_walls_; }
  std::vector<Vec<2>> taken_wall_impulses() override { return {}; }
  Energy energy(const Grains<2>& /*grains*/) const override { return {}; }

  void exchange(Archive& archive) override {
    archive.value("deposition/made", made_);
    archive.array("deposition/supports", supports_);
    archive.check("deposition/made", made_ >= 0 && made_ <= settings_.count);
  }

  void restored(const Grains<2>& grains, const Team& /*team*/) override { list(grains); }

  std::int64_t made() const override { return made_; }
  bool complete() const override { return made_ == settings_.count; }
  double grains_per_step(std::size_t /*moving*/) const override { return 1.0; }

 private:
  double place_of(const DroppedDisc& drop) const {
    const auto& box = settings_.box;
    if (box.periodic) return box.x_min + drop.place * box.width();
    return box.x_min + drop.grain.radius + drop.place * (box.width() - 2.0 * drop.grain.radius);
  }

  double snapped(double length) const {
    if (!settings_.snapped) return length;
    const double unit = 0x1p-40 * settings_.largest_radius;
    return std::round(length / unit) * unit;
  }

  void add(Grains<2>& grains, const DroppedDisc& drop, const Rest& rest) {
    auto grain = drop.grain;
    grain.position = settings_.box.wrapped(Vec<2>{{snapped(rest.x), snapped(rest.y)}});
    const auto number = static_cast<std::int32_t>(grains.size());
    const auto id = grains.id.empty() ? 0 : grains.id.back() + 1;
    grains.add(grain, id, false, drop.material);
    supports_.push_back({rest.first, rest.second});
    search_->add(number);
    ++made_;
  }

  void list(const Grains<2>& grains) {
    search_.emplace(settings_, grains);
    for (std::size_t k = 0; k < grains.size(); ++k) search_->add(static_cast<std::int32_t>(k));
  }

  Contact<2> touch(const Grains<2>& grains, std::size_t i, std::size_t j) const {
    const auto& a = grains.line[i];
    const auto& b = grains.line[j];
    const auto d = separation(a.position, b.position, settings_.box);
    const double distance = magnitude(d);
    const double reach = a.radius + b.radius;
    Contact<2> contact;
    contact.first = grains.id[i];
    contact.second = grains.id[j];
    contact.normal = d * (1.0 / distance);
    contact.overlap = reach - distance;
    contact.relative_overlap = 2.0 * contact.overlap / reach;
    contact.first_lever = a.radius;
    return contact;
  }

  DepositionSettings settings_;
  std::optional<Search> search_;
  std::vector<Supports> supports_;  // one entry per grain, in memory order, which here is the order of ids
  std::int64_t made_ = 0;
  std::vector<WallState> no_walls_;
};

}  // namespace

std::unique_ptr<Method<2>> make_deposition(const DepositionSettings& settings) {
  return std::make_unique<Deposition<Columns>>(settings);
}

std::unique_ptr<Method<2>> make_deposition_by_brute_force(const DepositionSettings& settings) {
  return std::make_unique<Deposition<BruteForce>>(settings);
}

}  // namespace repose
