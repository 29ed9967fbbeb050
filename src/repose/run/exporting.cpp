// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run/exporting.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/exports.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/state.hpp"
#include "repose/run/checkpoint.hpp"
#include "repose/run/folders.hpp"
#include "repose/run/record_file.hpp"
#include "repose/run/setup.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <set>

namespace fs = std::filesystem;

namespace repose {

namespace {

using Use = std::function<void(const Moment&, std::size_t number)>;

/// Goes through the saved frames, in order, and the last state, one at a time.
void for_every_moment(const ExportOrder& order, const Record& last, const Use& use) {
  std::size_t number = 0;
  for (; order.frames && is_there(fmt::format("{}/frames/{}.h5", order.folder, numbered(number))); ++number) {
    const Hdf5Reader file(fmt::format("{}/frames/{}.h5", order.folder, numbered(number)));
    const double time = file.number("/", "time");
    if (time >= last.facts.time) break;  // of a run that was cut off later
    use({time, file.integer("/", "steps"), read_grains<2>(file), read_contacts<2>(file)}, number);
  }
  use({last.facts.time, last.facts.steps, last.grains, last.contacts}, number);
}

std::vector<std::string> export_vtk(const ExportOrder& order, const Record& last, const Box<2>& box) {
  std::vector<std::pair<double, std::string>> grains;
  std::vector<std::pair<double, std::string>> contacts;
  for_every_moment(order, last, [&](const Moment& moment, std::size_t number) {
    grains.emplace_back(moment.time, fmt::format("grains_{}.vtp", numbered(number)));
    contacts.emplace_back(moment.time, fmt::format("contacts_{}.vtp", numbered(number)));
    write_vtp(order.out + "/" + grains.back().second, grains_for_vtk(moment));
    write_vtp(order.out + "/" + contacts.back().second, contacts_for_vtk(moment, box));
  });
  write_pvd(order.out + "/grains.pvd", grains);
  write_pvd(order.out + "/contacts.pvd", contacts);
  return {"grains.pvd", "contacts.pvd"};
}

std::vector<std::string> export_ovito(const ExportOrder& order, const Record& last, const Box<2>& box) {
  std::string grains;
  std::string contacts;
  for_every_moment(order, last, [&](const Moment& moment, std::size_t) {
    grains += grains_for_lammps(moment, box);
    contacts += contacts_for_lammps(moment, box);
  });
  write_text_file(order.out + "/grains.dump", grains);
  write_text_file(order.out + "/contacts.dump", contacts);
  return {"grains.dump", "contacts.dump"};
}

/// Every group of tables; where a group holds tables of several lengths, the longest has its name alone.
std::vector<std::string> export_csv(const ExportOrder& order) {
  std::vector<std::string> files;
  for (const auto* name : {"run.h5", "analysis.h5"}) {
    if (!is_there(fs::path(order.folder) / name)) continue;
    const Hdf5Reader file(order.folder + "/" + name);
    for (const auto& group : file.groups()) {
      std::set<std::size_t, std::greater<>> lengths;
      for (const auto& dataset : file.names_in(group)) {
        const auto shape = file.shape(group + "/" + dataset);
        if (!shape.empty() && shape.size() <= 2) lengths.insert(shape[0]);
      }
      for (const auto rows : lengths) {
        const auto stem = name == std::string("analysis.h5") ? "analysis_" + group : group;
        const auto written = rows == *lengths.begin() ? stem + ".csv" : fmt::format("{}_{}.csv", stem, rows);
        write_text_file(order.out + "/" + written, csv_of(file, group, rows));
        files.push_back(written);
      }
    }
  }
  return files;
}

}  // namespace

std::vector<std::string> export_run(const ExportOrder& order) {
  const auto last = read_record(order.folder);
  const auto box = make_box(last.scene);
  if (const auto problems = folder_problems(order.out); !problems.empty()) throw InputError(problems);
  std::error_code error;
  fs::create_directories(order.out, error);
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", order.out, error.message()));
  if (order.to == "vtk") return export_vtk(order, last, box);
  if (order.to == "ovito") return export_ovito(order, last, box);
  return export_csv(order);
}

}  // namespace repose
