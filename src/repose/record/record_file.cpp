// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/record_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/version.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"
#include "repose/io/state.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <type_traits>

namespace repose {

namespace {

constexpr std::int64_t format_version = 3;

void write_header(Hdf5File& file, const Scene& scene, const RunFacts& facts) {
  file.attribute("/", "format", std::string("repose-run"));
  file.attribute("/", "format_version", format_version);
  file.attribute("/", "repose_version", std::string(version));
  file.attribute("/", "title", scene.title);
  file.attribute("/", "method", std::string(scene.method->name()));
  file.attribute("/", "units", scene.units);
  file.attribute("/", "dimension", std::int64_t{2});
  file.attribute("/", "seed", scene.seed);
  file.attribute("/", "time", facts.time);
  file.attribute("/", "time_step", facts.time_step);
  file.attribute("/", "steps", facts.steps);
  file.attribute("/", "status", status_text(facts.status));
  file.attribute("/", "message", facts.message);
  file.attribute("/", "threads", facts.threads);
  file.attribute("/", "wall_seconds", facts.wall_seconds);
  file.attribute("/", "grain_steps", facts.grain_steps);
  file.attribute("/", "released", facts.released);
  file.attribute("/", "lost", facts.lost);
  file.attribute("/", "support_force", facts.support_force);
  file.attribute("/", "state_hash", facts.state_hash);
  file.attribute("/", "gravity", std::vector<double>{0.0, -scene.gravity});
  file.attribute("/", "grain_diameter", scene.grains.diameter);
  file.attribute("/", "grain_weight", scene.grain_weight());
  file.attribute("/", "periodic", std::int64_t{scene.box.periodic() ? 1 : 0});
  file.attribute("/", "x_min", -scene.box.half_width);
  file.attribute("/", "x_max", scene.box.half_width);
}

RunFacts read_facts(const Hdf5Reader& file) {
  RunFacts facts;
  try {
    facts.status = status_of(file.text("/", "status"));
  } catch (const std::out_of_range& error) {
    throw InputError(fmt::format("{}: {}", file.path(), error.what()));
  }
  facts.message = file.text("/", "message");
  facts.time = file.number("/", "time");
  facts.time_step = file.number("/", "time_step");
  facts.steps = file.integer("/", "steps");
  facts.threads = file.integer("/", "threads");
  facts.wall_seconds = file.number("/", "wall_seconds");
  facts.grain_steps = file.number("/", "grain_steps");
  facts.released = file.integer("/", "released");
  facts.lost = file.integer("/", "lost");
  facts.support_force = file.number("/", "support_force");
  facts.state_hash = file.text("/", "state_hash");
  return facts;
}

void write_walls(Hdf5File& file, const Scene& scene) {
  const auto walls = make_walls(scene);
  if (walls.empty()) return;
  std::vector<double> point;
  std::vector<double> normal;
  std::vector<double> direction;
  std::vector<double> half_length;
  std::vector<double> opens_at;
  for (const auto& wall : walls) {
    for (int k = 0; k < 2; ++k) {
      point.push_back(wall.point[k]);
      normal.push_back(wall.normal[k]);
      direction.push_back(wall.motion.direction[k]);
    }
    half_length.push_back(wall.half_length);
    opens_at.push_back(wall.opens_at);
  }
  file.group("walls");
  file.texts("walls/name", wall_names(scene), "of each wall");
  file.dataset("walls/point", point, 2, "L", "a point of the wall at the start, the middle of a finite one");
  file.dataset("walls/normal", normal, 2, "", "unit normal, towards the grains");
  file.dataset("walls/direction", direction, 2, "", "unit vector along which the wall moves; 0: it does not");
  file.dataset("walls/half_length", half_length, 1, "L", "half the length; infinite for a plane");
  file.dataset("walls/opens_at", opens_at, 1, "T", "from then on the wall is not there; infinite: it stays");
}

void write_wall_series(Hdf5File& file, const Record& record) {
  if (record.walls.empty()) return;
  const auto walls = record.walls.size() / record.series.size();
  std::vector<double> displacement;
  std::vector<double> force_x;
  std::vector<double> force_y;
  for (const auto& wall : record.walls) {
    displacement.push_back(wall.displacement);
    force_x.push_back(wall.force[0]);
    force_y.push_back(wall.force[1]);
  }
  file.table("series/wall_displacement", displacement, walls, "L", "of each wall along the direction of its motion");
  file.table("series/wall_force_x", force_x, walls, "M L/T^2", "of the grains on each wall, mean since the row before");
  file.table("series/wall_force_y", force_y, walls, "M L/T^2", "of the grains on each wall, mean since the row before");
}

/// Every entry of the account of the energy, by name.
struct EnergyColumn {
  const char* name;
  double Energy::*entry;
  const char* meaning;
};
constexpr EnergyColumn energy_columns[] = {
    {"kinetic", &Energy::kinetic, "translation and rotation"},
    {"gravitational", &Energy::gravitational, "0 at height 0"},
    {"elastic", &Energy::elastic, "of all contacts, springs of friction included"},
    {"sources", &Energy::sources, "brought by grains, at the start or later"},
    {"lost", &Energy::lost, "taken along by grains that left"},
    {"walls_work", &Energy::walls_work, "done by moving walls"},
    {"loads_work", &Energy::loads_work, "done by loads"},
    {"damping", &Energy::damping, "dissipated by dashpots between grains"},
    {"friction", &Energy::friction, "dissipated by friction and rolling resistance between grains"},
    {"walls", &Energy::walls, "dissipated at walls"},
};

/// One number of each row.
template <class Value>
void write_column(Hdf5File& file, const std::string& path, const std::vector<SeriesRow>& rows, const std::string& unit,
                  const std::string& meaning, const Value& value) {
  std::vector<std::decay_t<decltype(value(SeriesRow{}))>> values;
  values.reserve(rows.size());
  for (const auto& row : rows) values.push_back(value(row));
  file.dataset(path, values, 1, unit, meaning);
}

void write_energy(Hdf5File& file, const std::vector<SeriesRow>& rows) {
  file.group("energy");
  const auto column = [&](const std::string& name, const char* unit, const char* meaning, const auto& value) {
    write_column(file, "energy/" + name, rows, unit, meaning, value);
  };
  column("time", "T", "of the rows; energies are those of half a step before",
         [](const auto& row) { return row.time; });
  for (const auto& entry : energy_columns) {
    column(entry.name, "M L^2/T^2", entry.meaning, [&](const auto& row) { return row.energy.*entry.entry; });
  }
  column("error", "M L^2/T^2", "what is there and has gone, less what was put in",
         [](const auto& row) { return row.energy.error(); });
}

/// What the solver did since the row before: as many rows as the series.
struct SolverColumn {
  const char* name;
  std::int64_t SolverAccount::*entry;
  const char* meaning;
};
constexpr SolverColumn solver_columns[] = {
    {"steps", &SolverAccount::steps, "time steps"},
    {"sweeps", &SolverAccount::sweeps, "forward and backward sweeps"},
    {"contact_iterations", &SolverAccount::contact_iterations, "contacts visited by sweeps, each way counted"},
    {"unconverged", &SolverAccount::unconverged, "steps that reached method.most_sweeps"},
};

void write_solver(Hdf5File& file, const std::vector<SeriesRow>& rows) {
  file.group("solver");
  const auto column = [&](const std::string& name, const char* unit, const std::string& meaning, const auto& value) {
    write_column(file, "solver/" + name, rows, unit, meaning, value);
  };
  column("time", "T", "of the rows", [](const auto& row) { return row.time; });
  for (const auto& entry : solver_columns) {
    column(entry.name, "", std::string(entry.meaning) + ", since the row before",
           [&](const auto& row) { return row.solver.*entry.entry; });
  }
  column("residual", "g dt", "worst residual velocity of a contact since the row before",
         [](const auto& row) { return row.solver.worst_residual; });
  column("creep_rate", "L/T", "median speed of the grains that touch something",
         [](const auto& row) { return row.creep_rate; });
}

void write_series(Hdf5File& file, const std::vector<SeriesRow>& rows) {
  file.group("series");
  const auto column = [&](const std::string& name, const char* unit, const char* meaning, const auto& value) {
    write_column(file, "series/" + name, rows, unit, meaning, value);
  };
  column("time", "T", "time", [](const auto& row) { return row.time; });
  column("grains", "", "moving grains present", [](const auto& row) { return row.grains; });
  column("lost", "", "grains that have left", [](const auto& row) { return row.lost; });
  column("contacts", "", "contacts above the force threshold", [](const auto& row) { return row.contacts; });
  column("kinetic_energy_per_grain", "M L^2/T^2", "translation and rotation",
         [](const auto& row) { return row.kinetic_energy_per_grain; });
  column("force_residual", "grain weights", "mean net force on a grain over its weight",
         [](const auto& row) { return row.force_residual; });
  column("max_overlap", "", "deepest overlap over the mean diameter of the pair",
         [](const auto& row) { return row.max_overlap; });
}

/// Throws InputError unless every column has as many values as the first.
void check_lengths(const Hdf5Reader& file, const std::string& group, std::initializer_list<std::size_t> lengths) {
  for (const auto length : lengths) {
    if (length != *lengths.begin()) {
      throw InputError(fmt::format("{}: {}: the datasets differ in length", file.path(), group));
    }
  }
}

std::vector<SeriesRow> read_series(const Hdf5Reader& file) {
  const auto time = file.dataset<double>("series/time");
  const auto grains = file.dataset<std::int64_t>("series/grains");
  const auto lost = file.dataset<std::int64_t>("series/lost");
  const auto contacts = file.dataset<std::int64_t>("series/contacts");
  const auto energy = file.dataset<double>("series/kinetic_energy_per_grain");
  const auto residual = file.dataset<double>("series/force_residual");
  const auto overlap = file.dataset<double>("series/max_overlap");
  check_lengths(
      file, "series",
      {time.size(), grains.size(), lost.size(), contacts.size(), energy.size(), residual.size(), overlap.size()});
  std::vector<SeriesRow> rows;
  for (std::size_t k = 0; k < time.size(); ++k) {
    rows.push_back({time[k], grains[k], lost[k], contacts[k], energy[k], residual[k], overlap[k], {}, {}, 0.0});
  }
  return rows;
}

std::vector<WallRow> read_wall_series(const Hdf5Reader& file, std::size_t walls, std::size_t rows) {
  std::vector<WallRow> found;
  if (walls == 0 || rows == 0) return found;
  const auto displacement = file.table<double>("series/wall_displacement", walls);
  const auto force_x = file.table<double>("series/wall_force_x", walls);
  const auto force_y = file.table<double>("series/wall_force_y", walls);
  check_lengths(file, "series", {rows * walls, displacement.size(), force_x.size(), force_y.size()});
  for (std::size_t k = 0; k < displacement.size(); ++k) found.push_back({displacement[k], {{force_x[k], force_y[k]}}});
  return found;
}

void read_energy(const Hdf5Reader& file, std::vector<SeriesRow>& rows) {
  for (const auto& column : energy_columns) {
    const auto values = file.dataset<double>(fmt::format("energy/{}", column.name));
    check_lengths(file, "energy", {rows.size(), values.size()});
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].energy.*column.entry = values[k];
  }
}

void read_solver(const Hdf5Reader& file, std::vector<SeriesRow>& rows) {
  for (const auto& column : solver_columns) {
    const auto values = file.dataset<std::int64_t>(fmt::format("solver/{}", column.name));
    check_lengths(file, "solver", {rows.size(), values.size()});
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].solver.*column.entry = values[k];
  }
  const auto residual = file.dataset<double>("solver/residual");
  const auto creep = file.dataset<double>("solver/creep_rate");
  check_lengths(file, "solver", {rows.size(), residual.size(), creep.size()});
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].solver.worst_residual = residual[k];
    rows[k].creep_rate = creep[k];
  }
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

std::string kept_scene(const Hdf5Reader& file) {
  const auto kept = file.texts("scene");
  return kept.empty() ? "" : kept.front();
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

/// A damaged file may name grains that are not there; nothing behind this point looks again.
void check_partners(const Hdf5Reader& file, const Record& record) {
  const auto& id = record.grains.id;
  const auto walls = static_cast<std::int64_t>(make_walls(record.scene).size());
  const auto known = [&](std::int64_t k) { return std::binary_search(id.begin(), id.end(), k); };
  const bool sound =
      std::is_sorted(id.begin(), id.end()) &&
      std::all_of(record.contacts.list.begin(), record.contacts.list.end(), [&](const auto& contact) {
        return known(contact.first) && (contact.second < 0 ? contact.second >= -walls : known(contact.second));
      });
  if (!sound) throw InputError(fmt::format("{}: contacts: names a grain or wall that is not there", file.path()));
}

}  // namespace

void read_track_segment(const std::string& path, Track& track) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(fmt::format("{}: is missing", path));
  const Hdf5Reader file(path);
  const auto time = file.dataset<double>("time");
  const auto offset = file.dataset<std::int64_t>("offset");
  const auto id = file.dataset<std::int64_t>("id");
  const auto position = file.dataset<float>("position", 2);
  const auto radius = file.dataset<float>("radius");
  const auto energy = file.dataset<float>("kinetic_energy");
  const auto in_heap = file.dataset<std::uint8_t>("in_heap");
  check_lengths(file, "track", {id.size(), position.size() / 2, radius.size(), energy.size(), in_heap.size()});
  const bool sound = offset.size() == time.size() + 1 && offset.front() == 0 &&
                     offset.back() == static_cast<std::int64_t>(id.size()) &&
                     std::is_sorted(offset.begin(), offset.end());
  if (!sound) throw InputError(fmt::format("{}: wrong offsets", file.path()));
  for (std::size_t m = 0; m < time.size(); ++m) {
    TrackMoment moment{time[m], {}};
    for (auto k = static_cast<std::size_t>(offset[m]); k < static_cast<std::size_t>(offset[m + 1]); ++k) {
      moment.grains.push_back({id[k], position[2 * k], position[2 * k + 1], radius[k], energy[k], in_heap[k] != 0});
    }
    track.push_back(std::move(moment));
  }
}

void write_track_segment(const std::string& path, const Track& track, std::size_t first) {
  std::vector<double> time;
  std::vector<std::int64_t> offset{0};
  std::vector<std::int64_t> id;
  std::vector<float> position;
  std::vector<float> radius;
  std::vector<float> energy;
  std::vector<std::uint8_t> in_heap;
  for (auto m = first; m < track.size(); ++m) {
    for (const auto& grain : track[m].grains) {
      id.push_back(grain.id);
      position.push_back(grain.x);
      position.push_back(grain.y);
      radius.push_back(grain.radius);
      energy.push_back(grain.kinetic_energy);
      in_heap.push_back(grain.in_heap ? 1 : 0);
    }
    time.push_back(track[m].time);
    offset.push_back(static_cast<std::int64_t>(id.size()));
  }
  Hdf5File file(path);
  file.dataset("time", time, 1, "T", "of each moment");
  file.dataset("offset", offset, 1, "", "grains of moment m are rows offset[m] to offset[m + 1]");
  file.dataset("id", id, 1, "", "stable id, ascending within a moment");
  file.dataset("position", position, 2, "L", "centre");
  file.dataset("radius", radius, 1, "L", "radius");
  file.dataset("kinetic_energy", energy, 1, "M L^2/T^2", "translation and rotation");
  file.dataset("in_heap", in_heap, 1, "", "1: touches something");
  file.commit();
}

void write_record(const std::string& path, const Record& record, const std::vector<std::string>& frames,
                  const std::vector<std::string>& segments) {
  Hdf5File file(path);
  write_header(file, record.scene, record.facts);
  file.texts("scene", {scene_text(record.scene)}, "the scene that was run, complete");
  write_grains(file, record.grains);
  write_contacts(file, record.contacts);
  write_walls(file, record.scene);
  write_series(file, record.series);
  write_wall_series(file, record);
  if (record.scene.output.energy) write_energy(file, record.series);
  if (record.scene.method->solver() != nullptr) write_solver(file, record.series);
  write_base(file, record.base);
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

BaseProfile read_base(const Hdf5Reader& file) {
  BaseProfile base;
  if (!file.has("base")) return base;
  base.window_start = file.number("base", "window_start");
  base.window_end = file.number("base", "window_end");
  base.id = file.dataset<std::int64_t>("base/id");
  base.x = file.dataset<double>("base/x");
  base.normal = file.dataset<double>("base/normal");
  base.shear = file.dataset<double>("base/shear");
  check_lengths(file, "base", {base.id.size(), base.x.size(), base.normal.size(), base.shear.size()});
  return base;
}

namespace {

void check_version(const Hdf5Reader& file) {
  if (file.text("/", "format") != "repose-run" || file.integer("/", "format_version") != format_version) {
    throw InputError(fmt::format("{}: not a run of this version of Repose", file.path()));
  }
}

}  // namespace

RunFacts read_run_facts(const std::string& folder) {
  const Hdf5Reader file(folder + "/run.h5");
  check_version(file);
  return read_facts(file);
}

std::string read_run_scene(const std::string& folder) {
  const Hdf5Reader file(folder + "/run.h5");
  check_version(file);
  return kept_scene(file);
}

Record read_last_state(const std::string& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) throw InputError(fmt::format("{}: no such folder", folder));
  for (const auto* name : {"scene.toml", "run.h5"}) {
    if (!std::filesystem::exists(std::filesystem::path(folder) / name, error)) {
      throw InputError(fmt::format("{}: holds no run: no {}", folder, name));
    }
  }
  Record record;
  const Hdf5Reader file(folder + "/run.h5");
  check_version(file);
  record.scene = read_scene_of(folder, file);
  record.facts = read_facts(file);
  record.grains = read_grains<2>(file);
  record.contacts = read_contacts<2>(file);
  check_partners(file, record);
  return record;
}

Record read_record(const std::string& folder) {
  Record record = read_last_state(folder);
  const Hdf5Reader file(folder + "/run.h5");
  record.series = read_series(file);
  record.walls = read_wall_series(file, make_walls(record.scene).size(), record.series.size());
  if (record.scene.output.energy) read_energy(file, record.series);
  if (record.scene.method->solver() != nullptr) read_solver(file, record.series);
  record.base = read_base(file);
  if (file.has("track")) {
    for (const auto& name : file.names_in("track")) {
      read_track_segment(fmt::format("{}/track/{}.h5", folder, name), record.track);
    }
  }
  return record;
}

}  // namespace repose
