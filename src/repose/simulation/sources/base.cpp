// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/bases/counted.hpp"
#include "repose/scene/bases/deposited.hpp"
#include "repose/scene/bases/row.hpp"
#include "repose/simulation/sources/draw.hpp"
#include "repose/simulation/sources/initial.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace repose {

namespace {

void add_fixed(const Grain<2>& like, Vec<2> position, std::uint16_t material, Grains<2>& grains, std::int64_t& id) {
  auto grain = like;
  grain.inverse_mass = 0.0;
  grain.position = position;
  grains.add(grain, id++, true, material);
}

std::vector<double> row_places(const RowBase& base, const Scene& scene) {
  const double spacing = base.spacing;
  std::vector<double> places;
  if (scene.box.periodic()) {
    const long count = std::lround(2.0 * scene.box.half_width / spacing);
    for (long k = 0; k < count; ++k) places.push_back(static_cast<double>(k - count / 2) * spacing);
  } else {
    const long side = static_cast<long>(std::floor(base.half_width / spacing + 1e-9));
    for (long k = -side; k <= side; ++k) places.push_back(static_cast<double>(k) * spacing);
  }
  return places;
}

}  // namespace

void RowBase::add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const {
  const auto grain = make_grain<2>(scene, scene.grains.diameter, material);
  const auto number = scene.material_number(material);
  for (const double x : row_places(*this, scene)) add_fixed(grain, {{x, 0.0}}, number, grains, id);
}

/// Discs that touch their neighbours, as if each had been laid down beside the one before, at random heights. What is
/// left over of the width is shared out among the gaps of a periodic base, and among the ends of an open one.
void DepositedBase::add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const {
  const auto seed = static_cast<std::uint64_t>(scene.seed);
  const bool periodic = scene.box.periodic();
  const double half = periodic ? scene.box.half_width : half_width;
  const GrainDraw<2> draw(scene, Purpose::base_species, Purpose::base_size);
  std::vector<Grain<2>> discs;
  const auto step = [](const Grain<2>& a, const Grain<2>& b) {
    const double apart = a.radius + b.radius;
    const double rise = a.position[1] - b.position[1];
    return std::sqrt(apart * apart - rise * rise);
  };
  double end = 0.0;  // of the last disc, from the centre of the first, and in a periodic box back to the first
  for (std::uint64_t k = 0;; ++k) {
    auto disc = make_grain<2>(scene, 2.0 * draw(k).grain.radius, material);
    disc.position[1] = -roughness * uniform(seed, Purpose::base_height, k);
    if (!discs.empty()) disc.position[0] = discs.back().position[0] + step(discs.back(), disc);
    const double now = disc.position[0] + (periodic && !discs.empty() ? step(disc, discs.front()) : 0.0);
    if (now > 2.0 * half) break;
    end = now;
    discs.push_back(disc);
  }
  const double left_over = 2.0 * half - end;
  const double gap = periodic ? left_over / static_cast<double>(discs.size()) : 0.0;
  const double first = -half + (periodic ? 0.5 * gap : 0.5 * left_over);
  const auto number = scene.material_number(material);
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const double x = first + discs[k].position[0] + static_cast<double>(k) * gap;
    add_fixed(discs[k], {{x, discs[k].position[1]}}, number, grains, id);
  }
}

/// Touching discs from side to side.
void ContiguousBase::add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const {
  const auto grain = make_grain<2>(scene, scene.grains.diameter, material);
  const auto number = scene.material_number(material);
  for (std::int64_t k = 0; k < count; ++k) {
    const double x = (static_cast<double>(k) + 0.5) * scene.grains.diameter - reach(scene);
    add_fixed(grain, {{x, 0.0}}, number, grains, id);
  }
}

/// Discs on the floor at random places, one after the other, until no more fit: random sequential adsorption on a line,
/// which covers 0.7476 of it (Renyi).
void DisorderedBase::add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const {
  const auto seed = static_cast<std::uint64_t>(scene.seed);
  const double d = scene.grains.diameter;
  const double half = scene.box.half_width;
  const bool periodic = scene.box.periodic();
  std::uint64_t draw = 0;
  struct Gap {
    double first;  // room for a centre
    double last;
  };
  std::vector<double> places;
  std::vector<Gap> waiting;
  const auto fill = [&](Gap gap) {
    if (gap.last >= gap.first) waiting.push_back(gap);
  };
  if (periodic) {
    places.push_back(-half + 2.0 * half * uniform(seed, Purpose::parking, draw++));
    fill({places[0] + d, places[0] + 2.0 * half - d});
  } else {
    fill({-half + 0.5 * d, half - 0.5 * d});
  }
  // Gaps do not know of each other, so that one can be filled after the other.
  while (!waiting.empty()) {
    const auto gap = waiting.back();
    waiting.pop_back();
    const double x = gap.first + (gap.last - gap.first) * uniform(seed, Purpose::parking, draw++);
    places.push_back(x);
    fill({x + d, gap.last});
    fill({gap.first, x - d});
  }
  for (auto& x : places) x = x >= half ? x - 2.0 * half : x;
  std::sort(places.begin(), places.end());
  const auto grain = make_grain<2>(scene, d);
  for (const double x : places) add_fixed(grain, {{x, 0.0}}, 0, grains, id);
}

}  // namespace repose
