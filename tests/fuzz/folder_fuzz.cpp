// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Feeds the readers of run folders and checkpoints with good files that libFuzzer's input has changed (./dev validate):
// each four bytes of it are an edit of one dataset or attribute. The seals are made again, so that only what the
// readers check themselves protects the program.
#include "repose/core/errors.hpp"
#include "repose/io/seal.hpp"
#include "repose/record/record_file.hpp"
#include "repose/run_folder/export.hpp"
#include "repose/run_folder/resume.hpp"
#include "repose/scene/read.hpp"

#include <hdf5.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace repose;

constexpr const char* scene_of_runs = R"(
[base]
kind = "row"
half_width = 4
[box]
half_width = 6
[source]
kind = "pour"
count = 6
rate = 1.0
height = 6
half_width = 2
[stop]
time = 20
[output]
frames = 8
track = 4
)";

fs::path place() {
  const char* given = std::getenv("TMPDIR");
  return fs::path(given != nullptr ? given : "/tmp") / "fuzz-folders";
}

/// Writes a run to its end and one that was interrupted.
void make_good_folders() {
  fs::remove_all(place());
  fs::create_directories(place());
  for (const bool whole : {true, false}) {
    Simulation simulation(scene_from_text(scene_of_runs, "scene"), 1);
    RunFolder folder((place() / (whole ? "whole" : "cut")).string(), simulation);
    std::atomic<bool> interrupt{false};
    if (!whole) simulation.observe_every(12.0, [&](const Simulation<2>&) { interrupt = true; });
    folder.run(simulation, interrupt);
    folder.write(simulation);
  }
}

constexpr std::array odd_numbers = {0.0,
                                    -1.0,
                                    1.0,
                                    0.5,
                                    -1e308,
                                    1e308,
                                    1e-320,
                                    4e9,
                                    9.3e18,
                                    std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::infinity()};

void names_below(hid_t file, std::vector<std::string>& names) {
  H5Ovisit2(
      file, H5_INDEX_NAME, H5_ITER_INC,
      [](hid_t, const char* name, const H5O_info_t* info, void* list) -> herr_t {
        if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(list)->emplace_back(name);
        return 0;
      },
      &names, H5O_INFO_BASIC);
}

/// Makes a dataset again with another length, or with a length that nothing was written for.
void change_length(hid_t file, const std::string& name, std::uint8_t how) {
  const hid_t old = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  const hid_t type = H5Dget_type(old);
  const hid_t space = H5Dget_space(old);
  std::array<hsize_t, H5S_MAX_RANK> shape{};
  const int rank = H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  H5Sclose(space);
  H5Dclose(old);
  if (rank >= 1) {
    constexpr std::array<hsize_t, 6> lengths{0, 1, 2, 1000, 4'000'000'000, hsize_t{1} << 61};
    auto& length = shape[how / 16 % 2 == 0 ? 0 : static_cast<std::size_t>(rank - 1)];
    length = how % 8 < lengths.size() ? lengths[how % 8] : length + (how % 8 == 6 ? 1 : -1);
    const hid_t other = H5Screate_simple(rank, shape.data(), nullptr);
    H5Ldelete(file, name.c_str(), H5P_DEFAULT);
    const hid_t made = H5Dcreate2(file, name.c_str(), type, other, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (made >= 0) H5Dclose(made);
    if (other >= 0) H5Sclose(other);
  }
  H5Tclose(type);
}

/// Sets one number, or all bytes of a text, of a dataset.
void change_value(hid_t file, const std::string& name, std::uint8_t where, std::uint8_t what) {
  const hid_t dataset = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  const hid_t type = H5Dget_type(dataset);
  const hid_t space = H5Dget_space(dataset);
  const auto count = H5Sget_simple_extent_npoints(space);
  const bool numbers = H5Tget_class(type) == H5T_FLOAT || H5Tget_class(type) == H5T_INTEGER;
  if (count > 0 && numbers && count < 1'000'000) {
    std::vector<double> values(static_cast<std::size_t>(count));
    if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0) {
      values[where % values.size()] = odd_numbers[what % odd_numbers.size()];
      H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    }
  }
  H5Sclose(space);
  H5Tclose(type);
  H5Dclose(dataset);
}

void change_attribute(hid_t file, std::uint8_t which, std::uint8_t what) {
  const auto count = H5Aget_num_attrs(file);
  if (count <= 0) return;
  const hid_t attribute = H5Aopen_by_idx(file, ".", H5_INDEX_NAME, H5_ITER_INC, which % static_cast<unsigned>(count),
                                         H5P_DEFAULT, H5P_DEFAULT);
  const double value = odd_numbers[what % odd_numbers.size()];
  std::array<double, 16> values{};
  values.fill(value);
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, values.data());
  H5Aclose(attribute);
}

/// One edit of a file; what HDF5 itself refuses is no edit.
void edit(const fs::path& path, const std::uint8_t* bytes) {
  if (!fs::is_regular_file(path)) return;
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  if (file < 0) return;
  std::vector<std::string> names;
  names_below(file, names);
  const auto& name = names.empty() ? std::string() : names[bytes[1] % names.size()];
  switch (names.empty() ? 3 : bytes[0] / 8 % 4) {
    case 0:
      change_value(file, name, bytes[2], bytes[3]);
      break;
    case 1:
      change_length(file, name, bytes[2]);
      break;
    case 2:
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      break;
    default:
      change_attribute(file, bytes[1], bytes[2]);
  }
  H5Fclose(file);
  seal(path.string());
}

constexpr std::array files = {"run.h5",           "analysis.h5",      "frames/000000.h5", "track/000000.h5",
                              "checkpoints/0.h5", "checkpoints/1.h5", "run.h5",           "run.h5"};

/// A refusal is an InputError or RunError, with reasons of one line each.
void attempt(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    for (const auto& line : error.problems()) {
      if (line.empty() || line.find('\n') != std::string::npos) std::abort();
    }
  } catch (const RunError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  make_good_folders();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t most_edits = 4;
  const auto folder = place() / "changed";
  fs::remove_all(folder);
  fs::copy(place() / (size % 2 == 0 ? "whole" : "cut"), folder, fs::copy_options::recursive);
  for (std::size_t k = 0; k + 4 <= size && k < 4 * most_edits; k += 4) {
    edit(folder / files[data[k] % files.size()], data + k);
  }
  attempt([&] { analyse(read_record<2>(folder.string())); });
  ExportOrder order;
  order.folder = folder.string();
  for (const auto* format : {"csv", "vtk", "ovito"}) {
    order.to = format;
    attempt([&] { export_run(order); });
  }
  attempt([&] {
    auto found = find_interrupted(folder.string());
    if (found.finished) return;
    Simulation simulation(found.scene, 1);
    const auto resumed = resumed_folder(folder.string(), found, simulation);
  });
  return 0;
}
