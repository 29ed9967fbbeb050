// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/record_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"
#include "repose/io/state.hpp"
#include "repose/record/record_groups.hpp"
#include "repose/record/track_file.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <stdexcept>

namespace repose {

namespace {

template <int D>
Record<D> read_header(const Hdf5Reader& file) {
  Record<D> record;
  read_attributes(file, "/", run_attributes<D>(), record);
  try {
    record.facts.status = status_of(file.text("/", "status"));
  } catch (const std::out_of_range& error) {
    throw InputError(fmt::format("{}: {}", file.path(), error.what()));
  }
  return record;
}

void require_files(const std::string& folder, std::initializer_list<const char*> names) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) throw InputError(fmt::format("{}: no such folder", folder));
  for (const auto* name : names) {
    if (!std::filesystem::exists(std::filesystem::path(folder) / name, error)) {
      throw InputError(fmt::format("{}: holds no run: no {}", folder, name));
    }
  }
}

std::string kept_scene(const Hdf5Reader& file) {
  const auto kept = file.texts("scene");
  return kept.empty() ? "" : kept.front();
}

/// Files of older programs have no other than two.
std::int64_t dimension_of(const Hdf5Reader& file) { return file.integer("/", "dimension") == 3 ? 3 : 2; }

template <int D>
void check_dimension(const Hdf5Reader& file) {
  if (dimension_of(file) == D) return;
  throw InputError(fmt::format("{}: is of {} dimensions, not of {}", file.path(), D == 2 ? 3 : 2, D));
}

/// The scene that was run. Only its [analysis] may have been changed in scene.toml since then.
Scene read_scene_of(const std::string& folder, const Hdf5Reader& file) {
  const auto scene = read_scene(folder + "/scene.toml");
  auto run = scene_from_text(kept_scene(file), file.path() + ": scene");
  run.analysis = scene.analysis;
  if (scene_text(run) == scene_text(scene)) return scene;
  throw InputError(
      fmt::format("{}/scene.toml: is not the scene that was run, but for [analysis], which may change: "
                  "/scene of run.h5 has it",
                  folder));
}

/// The walls of the scene as a file has them.
template <int D>
std::vector<RecordedWall<D>> read_walls(const Hdf5Reader& file, const Scene& scene) {
  const auto count = make_walls<D>(scene).size();
  auto walls = recorded_walls<D>(scene, std::vector<WallState>(count), 0.0);
  if (count > 0) read_group(file, wall_group<D>(), walls, count);
  return walls;
}

}  // namespace

template <int D>
void check_partners(const std::string& path, const OrderedGrains<D>& grains, const Contacts<D>& contacts,
                    std::size_t walls) {
  const auto& id = grains->id;
  const auto number_of_walls = static_cast<std::int64_t>(walls);
  if (const auto twice = std::adjacent_find(id.begin(), id.end()); twice != id.end()) {
    throw InputError(fmt::format("{}: grains/id: {} is the id of two grains", path, *twice));
  }
  const bool sound =
      std::is_sorted(id.begin(), id.end()) &&
      std::all_of(contacts.list.begin(), contacts.list.end(), [&](const auto& contact) {
        return grains.find(contact.first) &&
               (contact.second < 0 ? contact.second >= -number_of_walls : grains.find(contact.second).has_value());
      });
  if (!sound) throw InputError(fmt::format("{}: contacts: names a grain or wall that is not there", path));
  // Grids of the analysis cover contacts.
  constexpr double longest_lever = 10.0;  // times the radii of the pair
  constexpr double rounding = 1e-6;
  const auto radius = [&](std::int64_t partner) {
    return partner < 0 ? 0.0 : grains->line[*grains.find(partner)].radius;
  };
  const bool placed = std::all_of(contacts.list.begin(), contacts.list.end(), [&](const auto& contact) {
    const double reach = longest_lever * (radius(contact.first) + radius(contact.second));
    return std::fabs(contact.first_lever) <= reach && dot(contact.normal, contact.normal) <= 1.0 + rounding;
  });
  if (!placed) throw InputError(fmt::format("{}: contacts: one does not lie at its grains", path));
}

template <int D>
void write_record(const std::string& path, const Record<D>& record, const std::vector<std::string>& frames,
                  const std::vector<std::string>& segments) {
  Hdf5File file(path, record.scene.units);
  write_attributes(file, "/", run_attributes<D>(), record);
  file.texts("scene", {scene_text(record.scene)}, "the scene that was run, complete");
  write_grains(file, record.grains);
  write_contacts(file, contacts_of(record), record.grains, record.scene.method->traits().has_forces());
  if (!record.walls.empty()) write_group(file, wall_group<D>(), record.walls);
  write_group(file, series_group(), record.series);
  if (!record.wall_series.empty()) write_columns(file, "series", wall_series_columns<D>(), record);
  if (!record.column_series.empty()) write_group(file, column_group<D>(), record);
  if (record.scene.output.energy) write_group(file, energy_group(), record.series);
  if (record.scene.method->solver() != nullptr) write_group(file, solver_group(), record.series);
  if (record.scene.method->traits().collides) write_group(file, collision_group(), record.series);
  if (!record.base.x.empty()) write_group(file, base_group<D>(), record.base);
  file.external_link("analysis", "analysis.h5", "/");
  const auto link = [&](const std::string& group, const std::vector<std::string>& names) {
    if (names.empty()) return;
    file.group(group);
    for (const auto& name : names) {
      file.external_link(fmt::format("{}/{}", group, name), fmt::format("{}/{}.h5", group, name), "/");
    }
  };
  link("frames", frames);
  link("track", segments);
  file.commit();
}

void check_belongs(const Hdf5Reader& file, const RunFacts& run) {
  if (run.scene_hash.empty() || file.text_or("/", "scene_hash", run.scene_hash) == run.scene_hash) return;
  throw InputError(fmt::format("{}: belongs to another run than the run.h5 of this folder", file.path()));
}

BaseProfile read_base(const Hdf5Reader& file) {
  BaseProfile base;
  if (!file.has("base")) return base;
  with_dimension(dimension_of(file), [&](auto dimension) { read_group(file, base_group<dimension>(), base); });
  return base;
}

namespace {

void check_version(const Hdf5Reader& file) {
  if (file.text("/", "format") != run_format || file.integer("/", "format_version") != run_format_version) {
    throw InputError(fmt::format("{}: not a run of this version of Repose", file.path()));
  }
}

}  // namespace

RunFacts read_run_facts(const std::string& folder) {
  const Hdf5Reader file(folder + "/run.h5");
  check_version(file);
  return read_header<2>(file).facts;
}

std::int64_t run_dimension(const std::string& folder) {
  require_files(folder, {"run.h5"});
  const Hdf5Reader file(folder + "/run.h5");
  check_version(file);
  return dimension_of(file);
}

void refuse_spheres(const std::string& folder, const std::string& what) {
  if (run_dimension(folder) == 2) return;
  throw InputError(fmt::format("{}: is a run of spheres; {} knows discs alone", folder, what));
}

std::string read_run_scene(const std::string& folder) {
  require_files(folder, {"run.h5"});
  const Hdf5Reader file(folder + "/run.h5");
  check_version(file);
  return kept_scene(file);
}

template <int D>
Record<D> read_last_state(const std::string& folder) {
  require_files(folder, {"scene.toml", "run.h5"});
  const Hdf5Reader file(folder + "/run.h5");
  check_version(file);
  check_dimension<D>(file);
  Record<D> record = read_header<D>(file);
  record.scene = read_scene_of(folder, file);
  record.box = make_box<D>(record.scene);
  record.walls = read_walls<D>(file, record.scene);
  record.grains = {read_grains<D>(file), record.box};
  record.contacts = read_contacts<D>(file);
  check_partners(file.path(), record.grains, record.contacts, record.walls.size());
  return record;
}

template <int D>
void read_series(const Hdf5Reader& file, Record<D>& record) {
  read_group(file, series_group(), record.series);
  const auto rows = record.series.size();
  if (rows > 0 && !record.walls.empty()) read_columns(file, "series", wall_series_columns<D>(), record, rows);
}

template <int D>
Record<D> read_record(const std::string& folder) {
  Record<D> record = read_last_state<D>(folder);
  const Hdf5Reader file(folder + "/run.h5");
  read_series(file, record);
  const auto rows = record.series.size();
  if (file.has("column")) read_group(file, column_group<D>(), record, rows);
  if (record.scene.output.energy) read_group(file, energy_group(), record.series, rows);
  if (record.scene.method->solver() != nullptr) read_group(file, solver_group(), record.series, rows);
  if (record.scene.method->traits().collides) read_group(file, collision_group(), record.series, rows);
  record.base = read_base(file);
  if (file.has("track")) {
    for (const auto& name : file.names_in("track")) {
      read_track_segment(fmt::format("{}/track/{}.h5", folder, name), record.facts.scene_hash, record.track);
    }
  }
  return record;
}

template void check_partners(const std::string&, const OrderedGrains<2>&, const Contacts<2>&, std::size_t);
template void write_record(const std::string&, const Record<2>&, const std::vector<std::string>&,
                           const std::vector<std::string>&);
template Record<2> read_last_state(const std::string&);
template void read_series(const Hdf5Reader&, Record<2>&);
template Record<2> read_record(const std::string&);
template void check_partners(const std::string&, const OrderedGrains<3>&, const Contacts<3>&, std::size_t);
template void write_record(const std::string&, const Record<3>&, const std::vector<std::string>&,
                           const std::vector<std::string>&);
template Record<3> read_last_state(const std::string&);
template void read_series(const Hdf5Reader&, Record<3>&);
template Record<3> read_record(const std::string&);

}  // namespace repose
