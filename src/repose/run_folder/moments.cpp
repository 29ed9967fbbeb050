// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/moments.hpp"

#include "repose/core/reproducible_math.hpp"
#include "repose/io/state.hpp"
#include "repose/record/record_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

namespace repose {

namespace {

/// How far the grains reach beyond the point of a wall along it.
struct Reach {
  double first = 0.0;  // [L] <= 0
  double last = 0.0;   // [L] >= 0
};

template <int D>
Reach reach_of(const Moment<D>& moment, const Wall<D>& wall, const Vec<D>& along) {
  Reach reach;
  for (const auto& grain : moment.grains->line) {
    const double place = dot(Vec<D>(grain.position - wall.point), along);
    reach.first = std::min(reach.first, place - 2.0 * grain.radius);
    reach.last = std::max(reach.last, place + 2.0 * grain.radius);
  }
  return reach;
}

WallLine line_of(const Wall<2>& wall, std::int64_t number, const Moment<2>& moment) {
  const Vec<2> along{{wall.normal[1], -wall.normal[0]}};
  if (wall.finite()) {
    return {wall.point - along * wall.half_length, wall.point + along * wall.half_length, number};
  }
  const auto reach = reach_of(moment, wall, along);
  return {wall.point + along * reach.first, wall.point + along * reach.last, number};
}

/// Makes the triangles of walls from places along their axes.
class Surface {
 public:
  Surface(const Wall<3>& wall, std::int64_t number) : wall_(wall) {
    made_.number = number;
    side_ = wall.shape.side == Vec<3>{} ? any_perpendicular(wall.normal) : wall.shape.side;
    across_ = cross(wall.normal, side_);
  }

  const Vec<3>& side() const { return side_; }
  const Vec<3>& across() const { return across_; }
  WallSurface take() { return std::move(made_); }

  void add_point(double side, double across, double along_normal = 0.0) {
    made_.points.push_back(wall_.point + side_ * side + across_ * across + wall_.normal * along_normal);
  }

  void add_rectangle(const Reach& side, const Reach& across) {
    add_point(side.first, across.first);
    add_point(side.last, across.first);
    add_point(side.last, across.last);
    add_point(side.first, across.last);
    made_.triangles = {{0, 1, 2}, {0, 2, 3}};
  }

  void add_triangle(const std::array<Vec<2>, 3>& corners) {
    for (const auto& corner : corners) add_point(corner[0], corner[1]);
    made_.triangles = {{0, 1, 2}};
  }

  /// What a line from one end to the other, as (distance from the axis, place along it), sweeps.
  void add_round(const Vec<2>& from, const Vec<2>& to) {
    constexpr std::size_t segments = 48;
    for (std::size_t k = 0; k < segments; ++k) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / segments;
      for (const auto& end : {from, to}) {
        add_point(end[0] * reproducible::cos(angle), end[0] * reproducible::sin(angle), end[1]);
      }
    }
    for (std::size_t k = 0; k < segments; ++k) {
      const auto here = 2 * k;
      const auto next = 2 * ((k + 1) % segments);
      // At a tip the triangle has no area.
      if (from[0] > 0.0) made_.triangles.push_back({here, next, next + 1});
      if (to[0] > 0.0) made_.triangles.push_back({here, next + 1, here + 1});
    }
  }

 private:
  const Wall<3>& wall_;
  Vec<3> side_{};
  Vec<3> across_{};
  WallSurface made_;
};

WallSurface surface_of(const Wall<3>& wall, std::int64_t number, const Moment<3>& moment) {
  using Kind = WallShape<3>::Kind;
  Surface surface(wall, number);
  const auto& corners = wall.shape.corners;
  switch (wall.shape.kind) {
    case Kind::rectangle:
      surface.add_rectangle({-corners[0][0], corners[0][0]}, {-corners[0][1], corners[0][1]});
      break;
    case Kind::triangle:
      surface.add_triangle(corners);
      break;
    case Kind::frustum:
      surface.add_round(corners[0], corners[1]);
      break;
    case Kind::disc:
      if (wall.finite()) {
        surface.add_round({}, {{wall.half_length, 0.0}});
      } else {
        surface.add_rectangle(reach_of(moment, wall, surface.side()), reach_of(moment, wall, surface.across()));
      }
      break;
  }
  return surface.take();
}

}  // namespace

std::vector<std::string> saved_frames(const std::string& folder) {
  const Hdf5Reader run(folder + "/run.h5");
  const auto groups = run.names_in("/");
  if (std::find(groups.begin(), groups.end(), "frames") == groups.end()) return {};
  return run.names_in("frames");
}

std::string frame_path(const std::string& folder, const std::string& name) {
  return fmt::format("{}/frames/{}.h5", folder, name);
}

template <int D>
Moment<D> read_frame(const std::string& path, const Record<D>& last) {
  const Hdf5Reader file(path);
  check_belongs(file, last.facts);
  Moment<D> moment{
      file.number("/", "time"), file.integer("/", "steps"), {read_grains<D>(file), last.box}, read_contacts<D>(file)};
  check_partners(path, moment.grains, moment.contacts, last.walls.size());
  return moment;
}

std::vector<WallLine> lines_of(const std::vector<RecordedWall<2>>& walls, const Moment<2>& moment) {
  std::vector<WallLine> lines;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (!walls[w].open) lines.push_back(line_of(walls[w].wall, static_cast<std::int64_t>(w), moment));
  }
  return lines;
}

std::vector<WallSurface> surfaces_of(const std::vector<RecordedWall<3>>& walls, const Moment<3>& moment) {
  std::vector<WallSurface> surfaces;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (!walls[w].open) surfaces.push_back(surface_of(walls[w].wall, static_cast<std::int64_t>(w), moment));
  }
  return surfaces;
}

template Moment<2> read_frame(const std::string&, const Record<2>&);
template Moment<3> read_frame(const std::string&, const Record<3>&);

}  // namespace repose
