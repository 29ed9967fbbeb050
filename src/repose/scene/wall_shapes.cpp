// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/wall_shapes.hpp"

#include "repose/boundaries/make_walls.hpp"
#include "repose/io/stl_file.hpp"
#include "repose/scene/problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>

namespace repose {

namespace {

namespace fs = std::filesystem;

constexpr double least_length = 1e-6;  // diameters of a grain

std::string text_of(const Coordinates& numbers) { return coordinates_text(numbers, 3); }
Vec<3> vector_between(const Coordinates& from, const Coordinates& to) { return vec<3>(to) - vec<3>(from); }

void check_direction(const std::string& key, const Coordinates& vector, Problems& problems) {
  if (!problems.sound(key) || magnitude(vec<3>(vector)) >= 1e-100) return;
  problems.problem(key, fmt::format(" = {}: must have a direction", text_of(vector)));
}

void check_length(const std::string& key, double length, double diameter, Problems& problems) {
  if (!problems.sound(key) || length >= least_length * diameter) return;
  problems.problem(key, fmt::format(" = {}: must be at least {} of a diameter", length, least_length));
}

/// The axis of a cylinder or a cone.
void check_axis(const std::string& prefix, const Coordinates& from, const Coordinates& to, double diameter,
                Problems& problems) {
  if (!problems.sound(prefix + "from") || !problems.sound(prefix + "to")) return;
  if (magnitude(vector_between(from, to)) >= least_length * diameter) return;
  problems.problem(prefix + "to", fmt::format(" = {}: is where the wall begins", text_of(to)));
}

/// The triangles of an STL file. A scene is asked for its walls again and again, so the last files are kept as long as
/// they do not change.
std::shared_ptr<const std::vector<Wall<3>>> facets_of(const std::string& path, double scale, const Coordinates& shift) {
  using Key = std::tuple<std::string, double, Coordinates>;
  struct Kept {
    fs::file_time_type changed;
    std::shared_ptr<const std::vector<Wall<3>>> walls;
  };
  static std::mutex one_at_a_time;
  static std::map<Key, Kept> kept;
  constexpr std::size_t most = 16;
  const std::lock_guard guard(one_at_a_time);
  const Key key{path, scale, shift};
  std::error_code error;
  const auto changed = fs::last_write_time(path, error);
  const auto found = kept.find(key);
  if (!error && found != kept.end() && found->second.changed == changed) return found->second.walls;
  const auto surface = read_stl(path, {.scale = scale, .shift = vec<3>(shift)});
  auto walls = std::make_shared<const std::vector<Wall<3>>>(surface_walls(surface.vertices, surface.facets));
  if (kept.size() >= most) kept.clear();
  kept[key] = {changed, walls};
  return walls;
}

}  // namespace

Kinds<ShapeKind>& shape_kinds() {
  static Kinds<ShapeKind> kinds{
      {DiscShape{}, RingShape{}, RectangleShape{}, CylinderShape{}, ConicalShape{}, SurfaceShape{}}};
  return kinds;
}

void DiscShape::keys(Parameters& keys) {
  keys.vector("centre", centre, 3, std::nullopt, "L", "middle of the disc");
  keys.vector("normal", normal, 3, std::nullopt, "", "a vector perpendicular to it");
  keys.number("radius", radius, required, positive, "L", "radius of the disc");
}

void DiscShape::check(const std::string& prefix, double diameter, Problems& problems) const {
  check_direction(prefix + "normal", normal, problems);
  check_length(prefix + "radius", radius, diameter, problems);
}

std::vector<Wall<3>> DiscShape::walls() const { return {disc_wall(vec<3>(centre), vec<3>(normal), radius)}; }

std::string DiscShape::describe() const { return fmt::format("disc of radius {} at {}", radius, text_of(centre)); }

void RingShape::keys(Parameters& keys) {
  keys.vector("centre", centre, 3, std::nullopt, "L", "middle of the ring");
  keys.vector("normal", normal, 3, std::nullopt, "", "a vector perpendicular to it");
  keys.number("inner_radius", inner_radius, required, positive, "L", "radius of the hole");
  keys.number("outer_radius", outer_radius, required, positive, "L", "radius of the ring");
}

void RingShape::check(const std::string& prefix, double diameter, Problems& problems) const {
  check_direction(prefix + "normal", normal, problems);
  if (!problems.sound(prefix + "inner_radius") || !problems.sound(prefix + "outer_radius")) return;
  if (outer_radius - inner_radius >= least_length * diameter) return;
  problems.problem(prefix + "outer_radius",
                   fmt::format(" = {}: must be > inner_radius = {} [L]", outer_radius, inner_radius));
}

std::vector<Wall<3>> RingShape::walls() const {
  return {ring_wall(vec<3>(centre), vec<3>(normal), inner_radius, outer_radius)};
}

std::string RingShape::describe() const {
  return fmt::format("ring of radii {} and {} at {}", inner_radius, outer_radius, text_of(centre));
}

void RectangleShape::keys(Parameters& keys) {
  keys.vector("corner", corner, 3, std::nullopt, "L", "a corner of the rectangle");
  keys.vector("side_a", side_a, 3, std::nullopt, "L", "from this corner to the next one");
  keys.vector("side_b", side_b, 3, std::nullopt, "L", "from this corner to the one before it, perpendicular to side_a");
}

void RectangleShape::check(const std::string& prefix, double diameter, Problems& problems) const {
  constexpr double rounding = 1e-9;
  const double a = magnitude(vec<3>(side_a));
  const double b = magnitude(vec<3>(side_b));
  for (const auto& [key, side, length] : {std::tuple{"side_a", &side_a, a}, std::tuple{"side_b", &side_b, b}}) {
    if (!problems.sound(prefix + key) || length >= least_length * diameter) continue;
    problems.problem(prefix + key,
                     fmt::format(" = {}: must be at least {} of a diameter long", text_of(*side), least_length));
  }
  if (!problems.sound(prefix + "side_a") || !problems.sound(prefix + "side_b")) return;
  if (std::fabs(dot(vec<3>(side_a), vec<3>(side_b))) <= rounding * a * b) return;
  problems.problem(prefix + "side_b",
                   fmt::format(" = {}: must be perpendicular to side_a = {}", text_of(side_b), text_of(side_a)));
}

std::vector<Wall<3>> RectangleShape::walls() const {
  return {rectangle_wall(vec<3>(corner), vec<3>(side_a), vec<3>(side_b))};
}

std::string RectangleShape::describe() const {
  return fmt::format("rectangle of {:.6g} by {:.6g} from {}", magnitude(vec<3>(side_a)), magnitude(vec<3>(side_b)),
                     text_of(corner));
}

void CylinderShape::keys(Parameters& keys) {
  keys.vector("from", from, 3, std::nullopt, "L", "one end of its axis");
  keys.vector("to", to, 3, std::nullopt, "L", "the other end");
  keys.number("radius", radius, required, positive, "L", "radius of the cylinder");
}

void CylinderShape::check(const std::string& prefix, double diameter, Problems& problems) const {
  check_axis(prefix, from, to, diameter, problems);
  check_length(prefix + "radius", radius, diameter, problems);
}

std::vector<Wall<3>> CylinderShape::walls() const { return {frustum_wall(vec<3>(from), vec<3>(to), radius, radius)}; }

std::string CylinderShape::describe() const {
  return fmt::format("cylinder of radius {} from {} to {}", radius, text_of(from), text_of(to));
}

void ConicalShape::keys(Parameters& keys) {
  keys.vector("from", from, 3, std::nullopt, "L", "one end of its axis");
  keys.vector("to", to, 3, std::nullopt, "L", "the other end");
  keys.number("radius_from", radius_from, required, not_negative, "L", "radius at the one end; 0 at a tip");
  keys.number("radius_to", radius_to, required, not_negative, "L", "radius at the other end; 0 at a tip");
}

void ConicalShape::check(const std::string& prefix, double diameter, Problems& problems) const {
  check_axis(prefix, from, to, diameter, problems);
  if (!problems.sound(prefix + "radius_from") || !problems.sound(prefix + "radius_to")) return;
  if (std::max(radius_from, radius_to) >= least_length * diameter) return;
  problems.problem(prefix + "radius_to", fmt::format(" = {}: one radius must be > 0", radius_to));
}

std::vector<Wall<3>> ConicalShape::walls() const {
  return {frustum_wall(vec<3>(from), vec<3>(to), radius_from, radius_to)};
}

std::string ConicalShape::describe() const {
  return fmt::format("cone of radius {} at {} and {} at {}", radius_from, text_of(from), radius_to, text_of(to));
}

void SurfaceShape::keys(Parameters& keys) {
  keys.text("file", file, "STL file, beside the scene");
  keys.number("scale", scale, 1.0, positive, "L", "length of a unit of the file");
  keys.vector("shift", shift, 3, Coordinates{}, "L", "added to all places of the file, after the scale");
}

void SurfaceShape::find(const std::string& folder) { path = (fs::path(folder) / file).string(); }

void SurfaceShape::check(const std::string& prefix, double /*diameter*/, Problems& problems) const {
  for (const auto* key : {"file", "scale", "shift"}) {
    if (!problems.sound(prefix + key)) return;
  }
  try {
    facets_of(path.empty() ? file : path, scale, shift);
  } catch (const InputError& error) {
    for (const auto& line : error.problems()) {
      problems.problem(prefix + "file", fmt::format(" = \"{}\": {}", file, line));
    }
  }
}

std::vector<Wall<3>> SurfaceShape::walls() const { return *facets_of(path.empty() ? file : path, scale, shift); }

std::string SurfaceShape::describe() const {
  return fmt::format("surface of {} triangles from {}", walls().size(), file);
}

}  // namespace repose
