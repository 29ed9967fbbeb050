// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/response.hpp"

#include "repose/core/numbers.hpp"
#include "repose/scene/write.hpp"
#include "repose/sweep/response_theory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace repose {

namespace {

constexpr double reach = 2.0;          // [h] of the bins
constexpr double narrowest_bin = 0.1;  // [h]

std::string without_loads(Scene scene) {
  scene.loads.clear();
  return scene_text(scene);
}

bool one_downward(const Scene& scene) {
  return scene.loads.size() == 1 && scene.loads[0].force[0] == 0.0 && scene.loads[0].force[1] < 0.0;
}

double width_of(const Scene& scene) { return scene.box.periodic() ? 2.0 * scene.box.half_width : 0.0; }

/// x - from [L], by the nearest image in a periodic box.
double along(double x, double from, double width) { return width > 0.0 ? std::remainder(x - from, width) : x - from; }

/// Position of the grain that will bear the load, in a bed without the load.
Vec<2> loaded_place(const Record<2>& record, const Scene::Load& load) {
  const double width = width_of(record.scene);
  Vec<2> nearest{{no_number, no_number}};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < record.grains.size(); ++k) {
    const auto& grain = record.grains->line[k];
    if (load.grain >= 0 ? record.grains->id[k] != load.grain : grain.fixed()) continue;
    const double dx = along(grain.position[0], load.position[0], width);
    const double dy = grain.position[1] - load.position[1];
    const double square = load.grain >= 0 ? 0.0 : dx * dx + dy * dy;
    if (square >= least) continue;
    least = square;
    nearest = grain.position;
  }
  return nearest;
}

/// The response in one member with the load at one place.
struct Sample {
  double x = 0.0;      ///< [L] of the load
  double depth = 0.0;  ///< [L]
  std::vector<double> base;
  std::vector<double> more;  ///< [grain weights] normal force that the load brings
};

using Samples = std::map<std::int64_t, std::vector<Sample>>;  // by seed

double pitch_of(const Scene& scene, const std::vector<double>& base) {
  const auto count = static_cast<double>(base.size());
  return width_of(scene) > 0.0 ? width_of(scene) / count : (base.back() - base.front()) / (count - 1.0);
}

/// Response [F/h] of a sample in a bin: the force on a base grain is spread over a pitch.
double response_in(const Sample& sample, double force, double pitch, double width, double middle, double bin) {
  double sum = 0.0;
  for (std::size_t k = 0; k < sample.base.size(); ++k) {
    const double at = along(sample.base[k], sample.x, width);
    sum += sample.more[k] * shared_length(at - 0.5 * pitch, at + 0.5 * pitch, (middle - 0.5 * bin) * sample.depth,
                                          (middle + 0.5 * bin) * sample.depth);
  }
  return sum / (pitch * force * bin);
}

/// Mean over the places of one seed, by a function of a sample.
template <class Value>
std::vector<double> by_seed(const Samples& samples, const Value& value) {
  std::vector<double> means;
  for (const auto& [seed, places] : samples) {
    double sum = 0.0;
    for (const auto& place : places) sum += value(place);
    means.push_back(sum / static_cast<double>(places.size()));
  }
  return means;
}

void measure(PointResponse& response, const Samples& samples, const Scene& scene) {
  const double pitch = pitch_of(scene, samples.begin()->second.front().base);
  const double width = width_of(scene);
  response.depth = mean_of(by_seed(samples, [](const Sample& sample) { return sample.depth; }));
  const double pitches = std::max(1.0, std::ceil(narrowest_bin * response.depth.mean / pitch));
  response.bin = pitches * pitch / response.depth.mean;
  const auto bins_aside = static_cast<int>(reach / response.bin);
  for (int k = -bins_aside; k <= bins_aside; ++k) {
    const double middle = k * response.bin;
    response.x.push_back(middle);
    response.bins.push_back(mean_of(by_seed(samples, [&](const Sample& sample) {
      return response_in(sample, response.force, pitch, width, middle, response.bin);
    })));
  }
  response.total = mean_of(by_seed(samples, [&](const Sample& sample) {
    double sum = 0.0;
    for (const double more : sample.more) sum += more;
    return sum / response.force;
  }));
  response.second_moment = mean_of(by_seed(samples, [&](const Sample& sample) {
    double sum = 0.0;
    for (std::size_t k = 0; k < sample.base.size(); ++k) {
      const double x = along(sample.base[k], sample.x, width) / sample.depth;
      if (std::abs(x) <= reach) sum += x * x * sample.more[k] / response.force;
    }
    return sum;
  }));
  compare_with_theory(response, scene, pitch);
}

/// Root mean square, over seeds, places in common and base grains, of the difference of two responses per force, over
/// that of the second.
double difference(const Samples& first, double first_force, const Samples& second, double second_force) {
  double off = 0.0;
  double size = 0.0;
  for (const auto& [seed, places] : first) {
    const auto same_seed = second.find(seed);
    if (same_seed == second.end()) continue;
    for (const auto& a : places) {
      for (const auto& b : same_seed->second) {
        if (a.x != b.x || a.depth != b.depth) continue;
        for (std::size_t k = 0; k < a.more.size(); ++k) {
          const double per_force = b.more[k] / second_force;
          off += (a.more[k] / first_force - per_force) * (a.more[k] / first_force - per_force);
          size += per_force * per_force;
        }
      }
    }
  }
  return size > 0.0 ? std::sqrt(off / size) : no_number;
}

}  // namespace

std::vector<PointResponse> point_responses(const SweepPlan& plan, const SweepTable& table,
                                           const std::function<Record<2>(std::size_t member)>& state) {
  std::vector<std::string> scenes;
  for (const auto& point : plan.points) scenes.push_back(without_loads(point.scene));
  const auto finished = [&](std::size_t point, std::int64_t seed) -> std::optional<std::size_t> {
    for (std::size_t m = 0; m < table.members.size(); ++m) {
      const auto& member = table.members[m];
      if (member.point == point && member.seed == seed && member.status == "finished") return m;
    }
    return std::nullopt;
  };
  std::vector<PointResponse> responses;
  std::vector<Samples> all_samples;
  std::vector<bool> taken(plan.points.size(), false);
  for (std::size_t first = 0; first < plan.points.size(); ++first) {
    if (taken[first] || !one_downward(plan.points[first].scene)) continue;
    std::size_t without = 0;
    while (without < scenes.size() && (!plan.points[without].scene.loads.empty() || scenes[without] != scenes[first])) {
      ++without;
    }
    if (without == scenes.size()) continue;
    const auto& scene = plan.points[first].scene;
    std::vector<std::size_t> points;
    for (std::size_t p = first; p < plan.points.size(); ++p) {
      const auto& other = plan.points[p].scene;
      if (scenes[p] != scenes[first] || !one_downward(other)) continue;
      if (other.loads[0].force != scene.loads[0].force || other.loads[0].start != scene.loads[0].start) continue;
      taken[p] = true;
      points.push_back(p);
    }
    PointResponse response;
    response.name = plan.points[first].name;
    response.without = plan.points[without].name;
    response.places = points.size();
    response.force = -scene.loads[0].force[1] / scene.grain_weight();
    Samples samples;
    for (const auto seed : plan.seeds) {
      const auto bare = finished(without, seed);
      if (!bare || table.members[*bare].base.x.size() < 2) continue;
      std::optional<Record<2>> record;
      for (const auto p : points) {
        const auto loaded = finished(p, seed);
        if (!loaded || table.members[*loaded].base.x != table.members[*bare].base.x) continue;
        if (!record) record = state(*bare);
        const auto place = loaded_place(*record, plan.points[p].scene.loads[0]);
        Sample sample{place[0], place[1], table.members[*bare].base.x, table.members[*loaded].base.normal};
        for (std::size_t k = 0; k < sample.more.size(); ++k) sample.more[k] -= table.members[*bare].base.normal[k];
        if (sample.depth > 0.0) samples[seed].push_back(std::move(sample));
      }
    }
    if (samples.empty()) continue;
    measure(response, samples, scene);
    response.nonlinearity = no_number;
    for (std::size_t k = 0; k < responses.size() && std::isnan(response.nonlinearity); ++k) {
      if (responses[k].without != response.without) continue;
      response.nonlinearity = difference(samples, response.force, all_samples[k], responses[k].force);
    }
    all_samples.push_back(std::move(samples));
    responses.push_back(std::move(response));
  }
  return responses;
}

}  // namespace repose
