// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/sources/drop.hpp"

#include "repose/core/reproducible_math.hpp"
#include "repose/scene/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {

void DropSource::opening_keys(const Scene& scene, Parameters& keys) {
  if (scene.dimension == 3) {
    if (opening == "line") opening = usual_opening();
    keys.choice("source.opening", opening, usual_opening(), {"disc", "rectangle"}, "level area of the releases");
  }
  const bool disc = opening == "disc";
  if (disc) {
    keys.number("source.radius", radius, usual_half_width(scene), not_negative, "L", "of the disc");
  } else {
    keys.number("source.half_width", half_width, usual_half_width(scene), not_negative, "L",
                "grains are released at x +- this");
  }
  if (scene.dimension == 3 && !disc) {
    keys.number("source.half_depth", half_depth, {half_width, "source.half_width"}, not_negative, "L",
                "grains are released at y +- this");
  }
  keys.number("source.x", x, any, "L", "centre of the opening");
  if (scene.dimension == 3) keys.number("source.y", y, any, "L", "centre of the opening");
}

template <int D>
Vec<D> DropSource::place(double first, double second) const {
  Vec<D> place;
  if constexpr (D == 2) {
    place[0] = x + half_width * (2.0 * first - 1.0);
  } else if (opening == "disc") {
    const double distance = radius * std::sqrt(first);
    const double turn = 2.0 * std::numbers::pi * second;
    place[0] = x + distance * reproducible::cos(turn);
    place[1] = y + distance * reproducible::sin(turn);
  } else {
    place[0] = x + half_width * (2.0 * first - 1.0);
    place[1] = y + half_depth * (2.0 * second - 1.0);
  }
  return place;
}
template Vec<2> DropSource::place(double, double) const;
template Vec<3> DropSource::place(double, double) const;

namespace {

/// Places all over an opening, its middle first.
template <int D>
std::vector<Vec<D>> places_of(const DropSource& source) {
  const int along = D == 2 ? 2000 : 40;
  const int across = D == 2 ? 0 : 40;
  std::vector<Vec<D>> places;
  const auto add = [&](double first, double second) {
    places.push_back(source.place<D>(first, second));
    places.back()[up<D>] = source.height;
  };
  add(source.opening == "disc" ? 0.0 : 0.5, 0.5);
  for (int k = 0; k <= along; ++k) {
    for (int m = 0; m <= across; ++m)
      add(k / static_cast<double>(along), m / std::max(1.0, static_cast<double>(across)));
  }
  return places;
}

}  // namespace

/// The opening lies within the box.
void DropSource::check_opening(const Scene& scene, Problems& problems) const {
  const bool disc = opening == "disc";
  const std::string key = disc ? "source.radius" : "source.half_width";
  const double reach = disc ? radius : half_width;
  if (problems.sound(key) && problems.sound("box.half_width") && std::fabs(x) + reach > scene.box.half_width) {
    problems.problem(key,
                     fmt::format(" = {}: the opening must lie within the box, x = +-{}", reach, scene.box.half_width));
  }
  if (scene.dimension == 2) return;
  const std::string key_y = disc ? "source.radius" : "source.half_depth";
  const double reach_y = disc ? radius : half_depth;
  if (problems.sound(key_y) && problems.sound("box.half_depth") && std::fabs(y) + reach_y > scene.box.half_depth) {
    problems.problem(
        key_y, fmt::format(" = {}: the opening must lie within the box, y = +-{}", reach_y, scene.box.half_depth));
  }
}

void DropSource::check(const Scene& scene, Problems& problems) const {
  if (scene.gravity == 0.0 && problems.sound("gravity")) {
    problems.problem("source.kind", fmt::format(" = \"{}\": needs gravity > 0", name()));
  }
  check_opening(scene, problems);
  if (above_apex() || !problems.none()) return;
  const auto wall = with_dimension(
      scene.dimension, [&](auto dimension) { return wall_that_blocks(scene, places_of<dimension>(*this)); });
  if (wall) {
    problems.problem("source.height", fmt::format(" = {}: no grain ever finds room there: wall \"{}\" is in the way",
                                                  height, wall_names(scene)[*wall]));
  }
}

double DropSource::fall(const Scene& scene) const {
  // From above the highest grain of a heap, a grain may fall past the heap. No slope is steeper than 45 degrees for
  // long, so the lowest place is no farther below than the sides are away.
  const auto sides = upright_sides(scene);
  const double heap =
      std::min(scene.expected_column() * scene.grains.diameter, std::max(sides.right - x, x - sides.left));
  return height + (above_apex() ? heap : 0.0) + scene.rise(velocity);
}

double DropSource::expected_end(const Scene& scene) const {
  const double poured = static_cast<double>(count) / rate;
  return poured + std::sqrt(2.0 * height / scene.gravity) + 50.0 * std::sqrt(scene.grains.diameter / scene.gravity);
}

double DropSource::expected_work(const Scene&, double time) const {
  const double during = std::min(time, static_cast<double>(count) / rate);
  return 0.5 * rate * during * during + static_cast<double>(count) * (time - during);
}

Default PourSource::usual_half_width(const Scene& scene) const { return {3.0 * scene.grains.diameter, "3 d"}; }

Default RainSource::usual_half_width(const Scene& scene) const {
  return {scene.base->of_grains() ? scene.base->reach(scene) : scene.box.half_width, "all of the base or box"};
}

std::string PourSource::describe() const { return fmt::format("{} poured", count); }
std::string RainSource::describe() const { return fmt::format("{} rained", count); }

}  // namespace repose
