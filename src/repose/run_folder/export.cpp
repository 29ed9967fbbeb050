// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/export.hpp"

#include "repose/contact_problem/contact_problem.hpp"
#include "repose/core/dimension.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/csv_tables.hpp"
#include "repose/io/exports.hpp"
#include "repose/io/folders.hpp"
#include "repose/record/record_file.hpp"
#include "repose/run_folder/checkpoint.hpp"
#include "repose/run_folder/moment_stress.hpp"
#include "repose/run_folder/moments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace fs = std::filesystem;

namespace repose {

namespace {

/// The saved frames to export; none of them is missing.
std::vector<std::string> frame_files(const ExportOrder& order) {
  std::vector<std::string> files;
  std::vector<std::string> missing;
  for (const auto& name : order.frames ? saved_frames(order.folder) : std::vector<std::string>()) {
    files.push_back(frame_path(order.folder, name));
    if (!path_exists(files.back())) {
      missing.push_back(fmt::format("{}: is missing; --frames last does without", files.back()));
    }
  }
  if (!missing.empty()) throw InputError(missing);
  return files;
}

/// `walls` are those that stand at the time of the moment, by number.
template <int D>
using Use = std::function<void(const Moment<D>&, const std::vector<RecordedWall<D>>& walls, std::size_t number)>;

/// Goes through the saved frames, in order, and the last state, one at a time; returns how many these are. Where
/// contacts have forces, each grain has its stress.
template <int D>
std::size_t for_every_moment(const ExportOrder& order, const Record<D>& last, const Use<D>& use) {
  const bool forces = last.scene.method->traits().has_forces();
  const auto use_with_stress = [&](Moment<D> moment, const std::vector<RecordedWall<D>>& walls, std::size_t number) {
    if (forces) add_stress(moment, walls, last.box);
    use(moment, walls, number);
  };
  std::size_t number = 0;
  for (const auto& path : frame_files(order)) {
    auto moment = read_frame(path, last);
    if (moment.step >= last.facts.steps) break;  // the last state itself
    const auto walls = walls_at(last, moment.time);
    use_with_stress(std::move(moment), walls, number++);
  }
  use_with_stress({last.facts.time, last.facts.steps, last.grains, last.contacts}, last.walls, number);
  return number + 1;
}

/// The last state with the series, which has where walls stood at the times of frames.
template <int D>
Record<D> read_states(const ExportOrder& order) {
  auto last = read_last_state<D>(order.folder);
  if (order.frames) read_series(Hdf5Reader(order.folder + "/run.h5"), last);
  return last;
}

/// The fields of the last state as image data, where the run was analysed and has any.
void export_fields(const ExportOrder& order, const std::string& folder, Exported& done) {
  const auto path = order.folder + "/analysis.h5";
  if (!path_exists(path)) return;
  const Hdf5Reader file(path);
  for (const auto& table : csv_tables(file)) {
    if (!table.grid || table.group != "fields") continue;
    const auto x = file.dataset<double>("fields/x");
    const auto y = file.dataset<double>("fields/y");
    const double cell = file.number("fields", "cell");
    VtkGrid grid{x.size(), y.size(), x.front() - 0.5 * cell, y.front() - 0.5 * cell, cell, {}};
    for (const auto& name : table.datasets) {
      grid.cell_data.push_back({name, 1, file.table<double>("fields/" + name, x.size())});
    }
    done.files.emplace_back("fields.vti");
    write_vti(folder + "/fields.vti", grid);
  }
}

VtkPolyData walls_of(const std::vector<RecordedWall<2>>& walls, const Moment<2>& moment) {
  return walls_for_vtk(lines_of(walls, moment));
}
VtkPolyData walls_of(const std::vector<RecordedWall<3>>& walls, const Moment<3>& moment) {
  return walls_for_vtk(surfaces_of(walls, moment));
}

template <int D>
void export_vtk(const ExportOrder& order, const std::string& folder, Exported& done) {
  const auto last = read_states<D>(order);
  std::vector<std::pair<double, std::string>> grains;
  std::vector<std::pair<double, std::string>> contacts;
  std::vector<std::pair<double, std::string>> walls;
  const auto add = [&](auto& series, const char* name, const Moment<D>& moment, std::size_t number,
                       const VtkPolyData& data) {
    series.emplace_back(moment.time, fmt::format("{}_{}.vtp", name, numbered(number)));
    write_vtp(folder + "/" + series.back().second, data);
  };
  const bool forces = last.scene.method->traits().has_forces();
  done.moments = for_every_moment<D>(
      order, last, [&](const Moment<D>& moment, const std::vector<RecordedWall<D>>& standing, std::size_t number) {
        add(grains, "grains", moment, number, grains_for_vtk(moment));
        add(contacts, "contacts", moment, number, contacts_for_vtk(moment, last.box, forces));
        if (!standing.empty()) add(walls, "walls", moment, number, walls_of(standing, moment));
      });
  const auto finish = [&](const auto& series, const char* name) {
    if (series.empty()) return;
    done.files.push_back(std::string(name) + ".pvd");
    write_pvd(folder + "/" + done.files.back(), series);
  };
  finish(grains, "grains");
  finish(contacts, "contacts");
  finish(walls, "walls");
  if (D == 2) export_fields(order, folder, done);
}

template <int D>
void export_ovito(const ExportOrder& order, const std::string& folder, Exported& done) {
  const auto last = read_states<D>(order);
  WholeFile grains(folder + "/grains.dump");
  WholeFile contacts(folder + "/contacts.dump");
  done.moments = for_every_moment<D>(order, last, [&](const Moment<D>& moment, const auto&, std::size_t) {
    add_grains_for_lammps(grains, moment, last.box);
    add_contacts_for_lammps(contacts, moment, last.box);
  });
  grains.commit();
  contacts.commit();
  done.files = {"grains.dump", "contacts.dump"};
}

/// Throws InputError if an analysis.h5 is not that of the last state. Other files pass.
void check_analysis(const Hdf5Reader& file, const RunFacts& run) {
  check_belongs(file, run);
  if (file.text_or("/", "state_hash", run.state_hash) == run.state_hash) return;
  throw InputError(fmt::format("{}: is not the analysis of the last state of the run; `repose analyse` writes it again",
                               file.path()));
}

void export_csv(const ExportOrder& order, const std::string& folder, Exported& done) {
  const auto facts = read_run_facts(order.folder);
  for (const auto* name : {"run.h5", "analysis.h5"}) {
    const auto path = order.folder + "/" + name;
    if (!path_exists(path)) continue;  // nobody has analysed the run
    const Hdf5Reader file(path);
    check_analysis(file, facts);
    const std::string prefix = file.text("/", "format") == "repose-run" ? "" : "analysis_";
    for (const auto& table : csv_tables(file)) {
      done.files.push_back(prefix + table.name + ".csv");
      write_csv(folder + "/" + done.files.back(), file, table);
    }
  }
  done.moments = 1;
  for (const auto& path : frame_files(order)) {
    const Hdf5Reader file(path);
    const auto number = fs::path(path).stem().string();
    for (const auto& table : csv_tables(file)) {
      done.files.push_back(fmt::format("frame_{}_{}.csv", number, table.name));
      write_csv(folder + "/" + done.files.back(), file, table);
    }
    ++done.moments;
  }
}

void export_contact_problem(const ExportOrder& order, const std::string& folder, Exported& done) {
  refuse_spheres(order.folder, "the export of contact problems");
  done.files = {"problem.h5"};
  write_contact_problem(folder + "/" + done.files.front(), next_contact_problem(read_last_state<2>(order.folder)));
  done.moments = 1;
}

bool belongs_to_series(const std::string& name) {
  const auto begins = [&](const char* with) { return name.starts_with(with); };
  return ((begins("grains_") || begins("contacts_") || begins("walls_")) && name.ends_with(".vtp")) ||
         (begins("frame_") && name.ends_with(".csv"));
}

/// Moves the finished files to their place. Parts of an older series would be shown by nobody, but would stay.
void move_in(const fs::path& from, const fs::path& to) {
  std::set<std::string> written;
  for (const auto& entry : fs::directory_iterator(from)) written.insert(entry.path().filename().string());
  if (std::any_of(written.begin(), written.end(), belongs_to_series)) {
    std::vector<fs::path> older;
    for (const auto& entry : fs::directory_iterator(to)) {
      if (belongs_to_series(entry.path().filename().string())) older.push_back(entry.path());
    }
    for (const auto& path : older) fs::remove(path);
  }
  for (const auto& name : written) fs::rename(from / name, to / name);
}

}  // namespace

Exported export_run(const ExportOrder& order) {
  const auto in_its_dimension = [&](const auto& write) {
    return [&order, write](const ExportOrder&, const std::string& folder, Exported& done) {
      with_dimension(run_dimension(order.folder), [&](auto dimension) { write(dimension, folder, done); });
    };
  };
  const auto vtk = [&](auto dimension, const auto& folder, auto& done) { export_vtk<dimension>(order, folder, done); };
  const auto ovito = [&](auto dimension, const auto& folder, auto& done) {
    export_ovito<dimension>(order, folder, done);
  };
  const std::map<std::string, ExportWriter> writers = {{"vtk", in_its_dimension(vtk)},
                                                       {"ovito", in_its_dimension(ovito)},
                                                       {"csv", export_csv},
                                                       {"contact-problem", export_contact_problem}};
  return export_run(order, writers.at(order.to));
}

Exported export_run(const ExportOrder& order, const ExportWriter& writer) {
  std::error_code error;
  if (!fs::is_directory(order.folder, error)) throw InputError(fmt::format("{}: no such folder", order.folder));
  if (!path_exists(order.folder + "/run.h5"))
    throw InputError(fmt::format("{}: holds no run: no run.h5", order.folder));
  read_run_facts(order.folder);  // throws before anything is written
  Exported done;
  done.folder = order.out.empty() ? order.folder + "/export/" + order.to : order.out;
  if (const auto problems = folder_problems(done.folder); !problems.empty()) throw InputError(problems);
  const bool may_replace = order.overwrite || order.out.empty() || !path_exists(done.folder);
  if (!may_replace && !fs::is_empty(done.folder)) {
    throw InputError(fmt::format("{}: folder is not empty; choose another --out, or --overwrite", done.folder));
  }

  const auto ancestor = existing_ancestor(done.folder);
  const std::string beside = done.folder + "/.unfinished";
  const auto undo = [&] {
    fs::remove_all(beside, error);
    for (auto made = fs::absolute(done.folder); made != ancestor && made.has_relative_path();
         made = made.parent_path()) {
      fs::remove(made, error);
    }
  };
  fs::create_directories(done.folder, error);
  if (error) throw RunError(fmt::format("{}: cannot write: {}", done.folder, error.message()));
  const FolderLock lock(done.folder);  // two exports at once would mix their files
  try {
    fs::create_directories(beside);
    writer(order, beside, done);
    move_in(beside, done.folder);
    fs::remove_all(beside);
  } catch (const fs::filesystem_error& failure) {
    undo();
    throw RunError(fmt::format("{}: cannot write: {}", done.folder, failure.code().message()));
  } catch (const RunError& failure) {
    undo();
    std::string why = failure.what();
    if (why.starts_with(beside)) why.replace(0, beside.size(), done.folder);
    throw RunError(why);
  } catch (...) {
    undo();
    throw;
  }
  return done;
}

}  // namespace repose
