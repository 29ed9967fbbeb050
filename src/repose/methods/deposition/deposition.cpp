// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/deposition/deposition.hpp"

#include "repose/core/huge_pages.hpp"
#include "repose/methods/contacts.hpp"
#include "repose/methods/deposition/brute_force.hpp"
#include "repose/methods/deposition/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace repose {

namespace {

using namespace deposition;

template <class Search>
class Deposition final : public Method<2> {
 public:
  explicit Deposition(const DepositionSettings& settings) : settings_(settings) {}

  TimeSteps time_steps() const override { return {1.0, false}; }
  double time() const override { return static_cast<double>(made_); }

  StepReport advance(Grains<2>& grains, double until, Team& /*team*/) override {
    if (complete()) return {time()};
    const auto stage = in_stage("dropping discs");
    grains.reaction.clear();  // there are no forces
    const std::int64_t before = made_;
    const std::int64_t last = std::min<std::int64_t>(time_steps().count(until), settings_.count);
    const Roller<Search> roller(settings_, *search_);
    bool trouble = false;
    // Discs are drawn some time before they fall, so that what they will meet can be fetched meanwhile.
    std::array<DroppedDisc, 16> drawn;
    while (made_ < last && !trouble) {
      const std::span drops(drawn.data(), static_cast<std::size_t>(std::min<std::int64_t>(last - made_, drawn.size())));
      settings_.draw(made_, drops);
      for (const auto& drop : drops) search_->prefetch(place_of(drop));
      for (const auto& drop : drops) {
        const auto rest = roller.drop(place_of(drop), drop.radius);
        trouble = !rest || !std::isfinite(rest->x);
        if (trouble) break;
        add(grains, drop, *rest);
      }
    }
    if (complete()) search_.reset();  // its memory is better used to write and analyse the packing
    return {time(), made_ - before, trouble};
  }

  /// Lists the grains that exist, and makes room for those to come.
  void grains_added(Grains<2>& grains) override {
    const auto all = grains.size() + static_cast<std::size_t>(settings_.count - made_);
    grains.reserve(all);
    supports_.reserve(all);
    prefer_huge_pages(grains.line);
    prefer_huge_pages(grains.id);
    prefer_huge_pages(grains.material);
    prefer_huge_pages(grains.base);
    prefer_huge_pages(supports_);
    supports_.resize(grains.size());
    list(grains);
  }

  void refresh(Grains<2>& /*grains*/, Team& /*team*/) override {}

  Contacts<2> contacts(const Grains<2>& grains) const override {
    Contacts<2> contacts;
    const auto blocks = contacts_of_supports(grains, supports_, settings_.box);
    contacts.list.reserve(blocks.size);
    blocks.for_each([&](const auto& block) { contacts.list.insert(contacts.list.end(), block.begin(), block.end()); });
    return contacts;
  }

  const std::vector<SupportPair>* supports() const override { return &supports_; }

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
    return box.x_min + drop.radius + drop.place * (box.width() - 2.0 * drop.radius);
  }

  double snapped(double length) const {
    if (!settings_.snapped) return length;
    const double unit = 0x1p-40 * settings_.largest_radius;
    return std::round(length / unit) * unit;
  }

  void add(Grains<2>& grains, const DroppedDisc& drop, const Rest& rest) {
    const auto number = static_cast<std::int32_t>(grains.size());
    grains.add({}, grains.id.empty() ? 0 : grains.id.back() + 1, false, drop.material);
    auto& grain = grains.line.back();  // set in place: a copy would wait for its parts to be stored
    grain.position = settings_.box.wrapped(Vec<2>{{snapped(rest.x), snapped(rest.y)}});
    grain.radius = drop.radius;
    grain.mass = drop.mass;
    grain.inverse_mass = 1.0 / drop.mass;
    supports_.push_back({rest.first, rest.second});
    search_->add(number);
    ++made_;
  }

  void list(const Grains<2>& grains) {
    search_.emplace(settings_, grains);
    for (std::size_t k = 0; k < grains.size(); ++k) search_->add(static_cast<std::int32_t>(k));
  }

  DepositionSettings settings_;
  std::optional<Search> search_;
  std::vector<SupportPair> supports_;  // one entry per grain, in memory order, which here is the order of ids
  std::int64_t made_ = 0;
};

}  // namespace

std::unique_ptr<Method<2>> make_deposition(const DepositionSettings& settings) {
  return std::make_unique<Deposition<Columns>>(settings);
}

std::unique_ptr<Method<2>> make_deposition_by_brute_force(const DepositionSettings& settings) {
  return std::make_unique<Deposition<BruteForce>>(settings);
}

}  // namespace repose
