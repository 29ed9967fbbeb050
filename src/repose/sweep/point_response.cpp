// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/point_response.hpp"

#include "repose/scene/write.hpp"
#include "repose/theory/point_load.hpp"

#include <boost/math/tools/minima.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <variant>

namespace repose {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
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

/// x - from, by the nearest image.
double along(double x, double from, double width) { return width > 0.0 ? std::remainder(x - from, width) : x - from; }

/// Place of the grain that bears the load, in a bed without it.
Vec<2> loaded_place(const Record& record, const Scene::Load& load) {
  const double width = width_of(record.scene);
  Vec<2> nearest{{none, none}};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < record.grains.size(); ++k) {
    const auto& grain = record.grains.line[k];
    if (load.grain >= 0 ? record.grains.id[k] != load.grain : grain.fixed()) continue;
    const double dx = along(grain.position[0], load.position[0], width);
    const double dy = grain.position[1] - load.position[1];
    const double square = load.grain >= 0 ? 0.0 : dx * dx + dy * dy;
    if (square >= least) continue;
    least = square;
    nearest = grain.position;
  }
  return nearest;
}

/// What one seed says at one place of the load.
struct Sample {
  double x = 0.0;      ///< [L] of the load
  double depth = 0.0;  ///< [L]
  std::vector<double> base;
  std::vector<double> more;  ///< [grain weights] normal force that the load brings
};

double pitch_of(const Scene& scene, const std::vector<double>& base) {
  const auto count = static_cast<double>(base.size());
  return width_of(scene) > 0.0 ? width_of(scene) / count : (base.back() - base.front()) / (count - 1.0);
}

using Samples = std::map<std::int64_t, std::vector<Sample>>;  // by seed

/// Length that two intervals share.
double shared(double a, double b, double c, double d) { return std::max(0.0, std::min(b, d) - std::max(a, c)); }

/// Response [F/h] of a sample in a bin: the force on a base grain is spread over a pitch.
double response_in(const Sample& sample, double force, double pitch, double width, double middle, double bin) {
  double sum = 0.0;
  for (std::size_t k = 0; k < sample.base.size(); ++k) {
    const double at = along(sample.base[k], sample.x, width);
    sum += sample.more[k] * shared(at - 0.5 * pitch, at + 0.5 * pitch, (middle - 0.5 * bin) * sample.depth,
                                   (middle + 0.5 * bin) * sample.depth);
  }
  return sum / (pitch * force * bin);
}

double stiffness_ratio(const Scene& scene) {
  const auto& laws = scene.contact;
  const auto* linear = std::get_if<Linear>(&laws.tangential);
  const auto* hooke = std::get_if<Hooke>(&laws.normal);
  if (laws.friction == 0.0) return 0.0;
  return linear != nullptr && hooke != nullptr ? linear->stiffness / hooke->stiffness : 0.5;
}

/// Mean of a stress [F/h] over each bin.
template <class Stress>
std::vector<double> bin_means(const PointResponse& response, const Stress& stress) {
  constexpr int parts = 16;
  std::vector<double> means;
  for (const double middle : response.x) {
    double sum = 0.0;
    for (int k = 0; k < parts; ++k) sum += stress(middle + response.bin * ((k + 0.5) / parts - 0.5));
    means.push_back(sum / parts);
  }
  return means;
}

/// The same of OSL, whose boxes end within bins.
std::vector<double> osl_means(const PointResponse& response, const theory::PointLoad& model) {
  const auto rays = theory::rays(model);
  const double half = 0.5 * model.load_width;
  std::vector<double> means;
  for (const double middle : response.x) {
    const auto force = [&](double place, double weight) {
      return weight * shared(place - half, place + half, middle - 0.5 * response.bin, middle + 0.5 * response.bin);
    };
    means.push_back((force(rays.left, rays.weight_left) + force(rays.right, rays.weight_right)) /
                    (model.load_width * response.bin));
  }
  return means;
}

double chi_square(const PointResponse& response, const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double off = (response.bins[k].mean - values[k]) / response.bins[k].error;
    sum += off * off;
  }
  return std::isfinite(sum) ? sum : none;
}

/// The theories; the load is as wide as a grain of the base.
void compare_with_theory(PointResponse& response, const Scene& scene, double pitch) {
  const double d = scene.grains.diameter;
  theory::PointLoad model;
  model.load_width = pitch / response.depth.mean;
  model.floor = "rough-rigid";
  model.poisson = response.poisson = 0.25 * (1.0 - std::min(1.0, stiffness_ratio(scene)));
  const double rise = std::sqrt(std::max(d * d - 0.25 * pitch * pitch, 0.01 * d * d));
  model.eta = response.eta = 0.25 * pitch * pitch / (rise * rise);
  model.depth = response.depth.mean / d;
  model.diffusion = 0.25 * pitch * pitch / (rise * d);
  const auto elastic = [&](double poisson) {
    auto other = model;
    other.poisson = poisson;
    return bin_means(response, [&](double x) { return elastic_stress(other, x); });
  };
  const auto add = [&](const char* name, std::vector<double> values) {
    const double square = chi_square(response, values);
    response.curves.push_back({name, std::move(values), square});
  };
  add("elastic", elastic(model.poisson));
  add("osl", osl_means(response, model));
  add("diffusive", bin_means(response, [&](double x) { return diffusive_stress(model, x); }));
  response.fitted_poisson = none;
  if (std::isnan(response.curves.front().chi_square)) return;
  const double poisson = boost::math::tools::brent_find_minima(
                             [&](double value) { return chi_square(response, elastic(value)); }, 0.0, 0.5, 16)
                             .first;
  response.fitted_poisson = poisson;
  add("elastic_fitted", elastic(poisson));
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
  return size > 0.0 ? std::sqrt(off / size) : none;
}

std::string cell(double x) { return std::isnan(x) ? "" : fmt::format("{}", x); }

nlohmann::ordered_json number(double x) {
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json estimate(const Estimate& value) {
  return {{"mean", number(value.mean)}, {"error", number(value.error)}};
}

}  // namespace

std::vector<PointResponse> point_responses(const SweepPlan& plan, const SweepTable& table,
                                           const std::function<Record(std::size_t member)>& state) {
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
      std::optional<Record> record;
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
    response.nonlinearity = none;
    for (std::size_t k = 0; k < responses.size() && std::isnan(response.nonlinearity); ++k) {
      if (responses[k].without != response.without) continue;
      response.nonlinearity = difference(samples, response.force, all_samples[k], responses[k].force);
    }
    all_samples.push_back(std::move(samples));
    responses.push_back(std::move(response));
  }
  return responses;
}

std::string response_csv(const std::vector<PointResponse>& responses) {
  std::string text = "point,x_over_h,response,response_error,elastic,osl,diffusive,elastic_fitted\n";
  for (const auto& response : responses) {
    for (std::size_t k = 0; k < response.x.size(); ++k) {
      text += fmt::format("{},{},{},{}", response.name, response.x[k] + 0.0, cell(response.bins[k].mean),
                          cell(response.bins[k].error));
      for (const auto& curve : response.curves) text += fmt::format(",{}", cell(curve.values[k]));
      text += response.curves.size() < 4 ? ",\n" : "\n";
    }
  }
  return text;
}

std::string response_json(const std::vector<PointResponse>& responses) {
  auto all = nlohmann::ordered_json::array();
  for (const auto& response : responses) {
    nlohmann::ordered_json curves;
    for (const auto& curve : response.curves) {
      curves[curve.name] = {{"chi_square", number(curve.chi_square)},
                            {"bins", response.x.size()},
                            {"peak", number(*std::ranges::max_element(curve.values))}};
    }
    all.push_back({{"point", response.name},
                   {"without", response.without},
                   {"places", response.places},
                   {"seeds", response.depth.count},
                   {"force", response.force},
                   {"depth", estimate(response.depth)},
                   {"bin", response.bin},
                   {"total", estimate(response.total)},
                   {"second_moment", estimate(response.second_moment)},
                   {"centre", estimate(response.bins[response.bins.size() / 2])},
                   {"nonlinearity", number(response.nonlinearity)},
                   {"poisson", response.poisson},
                   {"fitted_poisson", number(response.fitted_poisson)},
                   {"eta", response.eta},
                   {"curves", curves}});
  }
  return all.dump(2) + "\n";
}

}  // namespace repose
