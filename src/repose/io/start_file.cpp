// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/start_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/hdf5_reader.hpp"
#include "repose/io/state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fs = std::filesystem;

namespace repose {

namespace {

/// "two dimensions".
std::string dimensions_text(std::int64_t dimension) { return dimension == 3 ? "three dimensions" : "two dimensions"; }

bool all_finite(double number) { return std::isfinite(number); }
bool all_finite(const Vec<3>& vector) {
  return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}

double divided(double number, double by) { return number / by; }
Vec<3> divided(const Vec<3>& vector, double by) { return {{vector[0] / by, vector[1] / by, vector[2] / by}}; }

template <int D>
StartState<D> read_run(const std::string& path) {
  const Hdf5Reader file(path);
  if (file.text("/", "format") != "repose-run") throw InputError(fmt::format("{}: is not the run.h5 of a run", path));
  if (file.text("/", "status") == "failed") {
    throw InputError(fmt::format("{}: that run failed, so its last state cannot be trusted", path));
  }
  if (const auto dimension = dimension_of_state(file); dimension != D) {
    throw InputError(
        fmt::format("{}: is a run in {}, the scene is in {}", path, dimensions_text(dimension), dimensions_text(D)));
  }
  StartState<D> state;
  state.format = "run of Repose";
  const auto grains = read_grains<D>(file);
  state.contacts = read_contacts<D>(file);
  if (file.has("walls/name")) state.walls = file.texts("walls/name");
  const auto scene = file.texts("scene");
  state.scene = scene.empty() ? "" : scene.front();
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    const auto spin = divided(grain.rim_velocity, grain.radius);
    const bool sound = std::isfinite(magnitude(grain.position)) && std::isfinite(magnitude(grain.velocity)) &&
                       all_finite(spin) && grain.radius > 0.0 && grain.mass > 0.0;
    if (!sound || (k > 0 && grains.id[k] <= grains.id[k - 1])) {
      throw InputError(fmt::format("{}: grains: the data of grain {} are invalid", path, grains.id[k]));
    }
    state.grains.push_back({.id = grains.id[k],
                            .position = grain.position,
                            .velocity = grain.velocity,
                            .spin = spin,
                            .radius = grain.radius,
                            .mass = grain.mass,
                            .material = grains.material[k],
                            .fixed = grain.fixed(),
                            .base = grains.base[k] != 0,
                            .type = grains.material[k]});
  }
  return state;
}

}  // namespace

std::string start_file(const std::string& from) {
  std::error_code error;
  return fs::is_directory(from, error) ? (fs::path(from) / "run.h5").string() : from;
}

template <int D>
StartState<D> read_start(const std::string& file, const GrainsFileOptions& options) {
  std::error_code error;
  if (!fs::exists(file, error)) throw InputError(fmt::format("{}: no such file", file));
  if (!fs::is_regular_file(file, error)) throw InputError(fmt::format("{}: is not a regular file", file));
  if (fs::path(file).extension() == ".h5") {
    if (options.step != last_snapshot) {
      throw InputError(fmt::format("{}: is a run: it has no snapshot of step {}", file, options.step));
    }
    if (options.plane != Plane::xy) throw InputError(fmt::format("{}: is a run: start.plane must be xy", file));
    return read_run<D>(file);
  }
  return {read_grains_file<D>(file, options), {}, {}, {}};
}

template StartState<2> read_start(const std::string&, const GrainsFileOptions&);
template StartState<3> read_start(const std::string&, const GrainsFileOptions&);

}  // namespace repose
