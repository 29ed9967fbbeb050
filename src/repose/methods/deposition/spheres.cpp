// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/deposition/spheres.hpp"

#include "repose/core/huge_pages.hpp"
#include "repose/methods/contacts.hpp"
#include "repose/methods/deposition/spheres_brute_force.hpp"
#include "repose/methods/deposition/spheres_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace repose {

namespace {

using namespace deposition::spheres;

template <class Search>
class SphereDeposition final : public Method<3> {
 public:
  explicit SphereDeposition(const SphereDepositionSettings& settings) : settings_(settings) {}

  TimeSteps time_steps() const override { return {1.0, false}; }
  double time() const override { return static_cast<double>(made_); }

  StepReport advance(Grains<3>& grains, double until, Team& /*team*/) override {
    if (complete()) return {time()};
    const auto stage = in_stage("dropping spheres");
    grains.reaction.clear();  // there are no forces
    const std::int64_t before = made_;
    const std::int64_t last = std::min<std::int64_t>(time_steps().count(until), settings_.count);
    const Roller<Search> roller(settings_, *search_);
    bool trouble = false;
    // Spheres are drawn some time before they fall, so that what they will meet can be fetched meanwhile.
    std::array<DroppedSphere, 16> drawn;
    std::array<std::array<double, 2>, 16> places;
    while (made_ < last && !trouble) {
      const auto count = static_cast<std::size_t>(std::min<std::int64_t>(last - made_, drawn.size()));
      settings_.draw(made_, std::span(drawn.data(), count));
      for (std::size_t k = 0; k < count; ++k) {
        places[k] = place_of(drawn[k]);
        search_->prefetch(places[k][0], places[k][1]);
      }
      for (std::size_t k = 0; k < count && !trouble; ++k) {
        const auto rest = roller.drop(places[k][0], places[k][1], drawn[k].radius);
        trouble = rest.kind == Rest::Kind::unresolved || (rest.kind == Rest::Kind::lost && !open());
        if (trouble) break;
        if (rest.kind == Rest::Kind::rest) add(grains, drawn[k], rest);
        ++made_;
      }
    }
    if (complete()) search_.reset();  // its memory is better used to write and analyse the packing
    return {time(), made_ - before, trouble};
  }

  /// Lists the grains that exist, and makes room for those to come.
  void grains_added(Grains<3>& grains) override {
    const auto all = grains.size() + static_cast<std::size_t>(settings_.count - made_);
    grains.reserve(all);
    supports_.reserve(all);
    prefer_huge_pages(grains.line);
    prefer_huge_pages(grains.id);
    prefer_huge_pages(grains.material);
    prefer_huge_pages(grains.base);
    prefer_huge_pages(supports_);
    supports_.resize(grains.size(), {nothing, nothing, nothing});
    list(grains);
  }

  void refresh(Grains<3>& /*grains*/, Team& /*team*/) override {}

  Contacts<3> contacts(const Grains<3>& grains) const override {
    Contacts<3> contacts;
    for (std::size_t k = 0; k < supports_.size(); ++k) {
      auto on = supports_[k];
      std::sort(on.begin(), on.end());
      for (const auto support : on) {
        if (support < 0) continue;
        contacts.list.push_back(contact_of_grains(grains, k, static_cast<std::size_t>(support), settings_.box));
      }
    }
    return contacts;
  }

  void exchange(Archive& archive) override {
    archive.value("deposition/made", made_);
    archive.array("deposition/supports", supports_);
    archive.check("deposition/made", made_ >= 0 && made_ <= settings_.count);
  }

  void restored(const Grains<3>& grains, const Team& /*team*/) override { list(grains); }

  std::int64_t made() const override { return made_; }
  bool complete() const override { return made_ == settings_.count; }
  double grains_per_step(std::size_t /*moving*/) const override { return 1.0; }

 private:
  /// Whether a sphere can fall beside everything.
  bool open() const {
    const auto& box = settings_.box;
    return (!box.periodic && !std::isfinite(box.width())) || (!box.periodic_y && !std::isfinite(box.depth()));
  }

  std::array<double, 2> place_of(const DroppedSphere& drop) const {
    if (std::isfinite(settings_.drop_radius)) {
      const double aside = settings_.drop_radius * std::sqrt(drop.place[0]);
      const double angle = 2.0 * std::numbers::pi * drop.place[1];
      return {settings_.drop_centre[0] + aside * reproducible::cos(angle),
              settings_.drop_centre[1] + aside * reproducible::sin(angle)};
    }
    const auto& box = settings_.box;
    const auto between = [&](double low, double high, double place, bool periodic) {
      if (periodic) return low + place * (high - low);
      return low + drop.radius + place * (high - low - 2.0 * drop.radius);
    };
    return {between(box.x_min, box.x_max, drop.place[0], box.periodic),
            between(box.y_min, box.y_max, drop.place[1], box.periodic_y)};
  }

  Vec<3> snapped(Vec<3> place) const {
    if (!settings_.snapped) return place;
    const double unit = 0x1p-40 * settings_.largest_radius;
    for (int k = 0; k < 3; ++k) place[k] = std::round(place[k] / unit) * unit;
    return place;
  }

  void add(Grains<3>& grains, const DroppedSphere& drop, const Rest& rest) {
    const auto number = static_cast<std::int32_t>(grains.size());
    grains.add({}, grains.id.empty() ? 0 : grains.id.back() + 1, false, drop.material);
    auto& grain = grains.line.back();
    grain.position = settings_.box.wrapped(snapped(rest.position));
    grain.radius = drop.radius;
    grain.mass = drop.mass;
    grain.inverse_mass = 1.0 / drop.mass;
    supports_.push_back(rest.supports);
    search_->add(number);
  }

  void list(const Grains<3>& grains) {
    search_.emplace(settings_, grains);
    for (std::size_t k = 0; k < grains.size(); ++k) search_->add(static_cast<std::int32_t>(k));
  }

  SphereDepositionSettings settings_;
  std::optional<Search> search_;
  std::vector<std::array<std::int32_t, 3>> supports_;  // one entry per grain, in memory order, the order of ids
  std::int64_t made_ = 0;
};

}  // namespace

std::unique_ptr<Method<3>> make_sphere_deposition(const SphereDepositionSettings& settings) {
  return std::make_unique<SphereDeposition<Columns>>(settings);
}

std::unique_ptr<Method<3>> make_sphere_deposition_by_brute_force(const SphereDepositionSettings& settings) {
  return std::make_unique<SphereDeposition<BruteForce>>(settings);
}

}  // namespace repose
