// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run/run_folder.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/version.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/state.hpp"
#include "repose/run/reading.hpp"
#include "repose/run/setup.hpp"
#include "repose/run/summary.hpp"
#include "repose/scene/write.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

namespace fs = std::filesystem;

namespace repose {

namespace {

constexpr const char* own_files[] = {"scene.toml", "run.h5", "summary.json"};
constexpr const char* own_folders[] = {"frames", "pictures"};

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

bool holds_a_run(const fs::path& path) { return is_there(path / "scene.toml") && is_there(path / "run.h5"); }

/// The closest existing folder at or above a path.
fs::path existing_ancestor(fs::path path) {
  path = fs::absolute(path);
  while (!is_there(path) && path.has_relative_path()) path = path.parent_path();
  return path;
}

void clear_older_run(const fs::path& path) {
  for (const auto* name : own_folders) fs::remove_all(path / name);
  for (const auto* name : own_files) fs::remove(path / name);
}

void write_header(Hdf5File& file, const Simulation& simulation) {
  const auto& scene = simulation.scene();
  file.attribute("/", "format", std::string("repose-run"));
  file.attribute("/", "format_version", std::int64_t{1});
  file.attribute("/", "repose_version", std::string(version));
  file.attribute("/", "title", scene.title);
  file.attribute("/", "method", scene.method.kind);
  file.attribute("/", "units", scene.units);
  file.attribute("/", "dimension", std::int64_t{2});
  file.attribute("/", "seed", scene.seed);
  file.attribute("/", "time", simulation.time());
  file.attribute("/", "time_step", simulation.time_step());
  file.attribute("/", "steps", static_cast<std::int64_t>(simulation.steps()));
  file.attribute("/", "status", status_text(simulation.status()));
  file.attribute("/", "message", simulation.message());
  file.attribute("/", "gravity", std::vector<double>{0.0, -scene.gravity});
  file.attribute("/", "grain_diameter", scene.grains.diameter);
  file.attribute("/", "grain_weight", scene.grain_weight());
  file.attribute("/", "periodic", std::int64_t{scene.box.x == "periodic" ? 1 : 0});
  file.attribute("/", "x_min", -scene.box.half_width);
  file.attribute("/", "x_max", scene.box.half_width);
}

void write_planes(Hdf5File& file, const Scene& scene) {
  const auto planes = make_planes(scene);
  if (planes.empty()) return;
  std::vector<double> point;
  std::vector<double> normal;
  for (const auto& plane : planes) {
    for (int k = 0; k < 2; ++k) {
      point.push_back(plane.point[k]);
      normal.push_back(plane.normal[k]);
    }
  }
  file.group("planes");
  file.dataset("planes/point", point, 2, "L", "a point of the plane");
  file.dataset("planes/normal", normal, 2, "", "unit normal, towards the grains");
}

void write_series(Hdf5File& file, const std::vector<SeriesRow>& rows) {
  std::vector<double> time;
  std::vector<std::int64_t> grains;
  std::vector<std::int64_t> contacts;
  std::vector<double> energy;
  std::vector<double> residual;
  std::vector<double> overlap;
  for (const auto& row : rows) {
    time.push_back(row.time);
    grains.push_back(row.grains);
    contacts.push_back(row.contacts);
    energy.push_back(row.kinetic_energy_per_grain);
    residual.push_back(row.force_residual);
    overlap.push_back(row.max_overlap);
  }
  file.group("series");
  file.dataset("series/time", time, 1, "T", "time");
  file.dataset("series/grains", grains, 1, "", "moving grains present");
  file.dataset("series/contacts", contacts, 1, "", "contacts above the force threshold");
  file.dataset("series/kinetic_energy_per_grain", energy, 1, "M L^2/T^2", "translation and rotation");
  file.dataset("series/force_residual", residual, 1, "grain weights", "mean net force on a grain over its weight");
  file.dataset("series/max_overlap", overlap, 1, "", "deepest overlap over the mean diameter of the pair");
}

void write_base(Hdf5File& file, const BaseProfile& base) {
  if (base.x.empty()) return;
  file.group("base");
  file.attribute("base", "window_start", base.window_start);
  file.attribute("base", "window_end", base.window_end);
  file.dataset("base/id", base.id, 1, "", "grain id");
  file.dataset("base/x", base.x, 1, "L", "centre");
  file.dataset("base/normal", base.normal, 1, "grain weights", "force of the heap, positive downward");
  file.dataset("base/shear", base.shear, 1, "grain weights", "force of the heap, positive to the right");
}

void write_surface(Hdf5File& file, const Reading& reading, double bin_width) {
  std::vector<double> x;
  std::vector<double> height;
  std::vector<std::uint8_t> used;
  for (const auto& bin : reading.heap.surface) {
    x.push_back(bin.x);
    height.push_back(bin.height);
    used.push_back(bin.used ? 1 : 0);
  }
  file.group("surface");
  file.attribute("surface", "bin_width", bin_width);
  file.attribute("surface", "base_y", reading.base_height);
  file.attribute("surface", "apex_x", reading.heap.apex_x);
  file.attribute("surface", "apex_height", reading.heap.apex_height);
  const auto line = [&](const std::string& side, const std::optional<FlankLine>& flank) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    file.attribute("surface", side + "_slope", flank ? flank->slope : none);
    file.attribute("surface", side + "_intercept", flank ? flank->intercept : none);
  };
  line("left", reading.heap.left);
  line("right", reading.heap.right);
  file.dataset("surface/x", x, 1, "L", "centre of the bin");
  file.dataset("surface/height", height, 1, "L", "highest grain top above the base centres");
  file.dataset("surface/used", used, 1, "", "1: used for the line of its flank");
}

}  // namespace

std::vector<std::string> RunFolder::problems(const std::string& path, bool overwrite) {
  std::error_code error;
  const bool there = fs::exists(path, error);
  if (error) return {fmt::format("{}: cannot write a run here: {}", path, error.message())};
  if (there) {
    if (!fs::is_directory(path)) return {fmt::format("{}: cannot write a run here: is a file", path)};
    if (::access(path.c_str(), W_OK | X_OK | R_OK) != 0) {
      return {fmt::format("{}: cannot write a run here: {}", path, std::strerror(errno))};
    }
    if (fs::is_empty(path)) return {};
    if (!overwrite) return {fmt::format("{}: folder is not empty; choose another --out, or --overwrite", path)};
    if (!holds_a_run(path)) {
      return {fmt::format("{}: folder is not empty and holds no run, so --overwrite leaves it alone", path)};
    }
    return {};
  }
  const auto parent = existing_ancestor(path);
  if (!fs::is_directory(parent))
    return {fmt::format("{}: cannot write a run here: {} is a file", path, parent.string())};
  if (::access(parent.c_str(), W_OK | X_OK) != 0) {
    return {fmt::format("{}: cannot write a run here: {}: {}", path, parent.string(), std::strerror(errno))};
  }
  return {};
}

RunFolder::RunFolder(std::string path, const Simulation& simulation) : path_(std::move(path)) {
  const auto ancestor = existing_ancestor(path_);
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", path_, error.message()));
  // The new start is written beside an older run, which goes only when nothing can fail any more.
  const std::string beside = path_ + "/new";
  const std::string target = path_;
  try {
    fs::create_directory(beside);
    path_ = beside;
    write_text_file(path_ + "/scene.toml", scene_text(simulation.scene()));
    write_run(simulation);
    path_ = target;
    clear_older_run(path_);
    for (const auto* name : own_files) fs::rename(fs::path(beside) / name, fs::path(path_) / name);
    fs::remove_all(beside);
  } catch (const std::exception& failure) {
    fs::remove_all(beside, error);
    for (auto made = fs::absolute(target); made != ancestor; made = made.parent_path()) fs::remove(made, error);
    std::string why = failure.what();
    if (why.starts_with(beside)) why.replace(0, beside.size(), target);
    throw InputError(why);
  }
}

void RunFolder::write(const Simulation& simulation, bool frame) {
  if (frame) {
    std::error_code error;
    fs::create_directories(path_ + "/frames", error);
    const auto name = fmt::format("{:06}", frames_.size());
    Hdf5File file(fmt::format("{}/frames/{}.h5", path_, name));
    file.attribute("/", "time", simulation.time());
    file.attribute("/", "steps", static_cast<std::int64_t>(simulation.steps()));
    write_grains(file, simulation.wrapped_grains());
    write_contacts(file, simulation.contacts());
    file.commit();
    frames_.push_back(name);
  }
  write_run(simulation);
}

void RunFolder::write_run(const Simulation& simulation) {
  const auto contacts = simulation.contacts();
  const auto reading = read(simulation, contacts);
  Hdf5File file(path_ + "/run.h5");
  write_header(file, simulation);
  write_grains(file, simulation.wrapped_grains());
  write_contacts(file, contacts);
  write_planes(file, simulation.scene());
  write_series(file, simulation.series());
  write_base(file, reading.base);
  write_surface(file, reading, simulation.scene().analysis.bin_width);
  if (!frames_.empty()) {
    file.group("frames");
    for (const auto& name : frames_) file.external_link("frames/" + name, "frames/" + name + ".h5", "/");
  }
  file.commit();
  write_text_file(path_ + "/summary.json", summary_text(simulation, contacts, reading));
}

}  // namespace repose
