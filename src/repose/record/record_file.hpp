// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/hdf5_reader.hpp"
#include "repose/record/record.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose {

/// Writes run.h5; `frames` and `segments` name the files in frames/ and track/ that it links. The layout is described
/// in docs/reference/run-folder.md. Throws RunError.
template <int D>
void write_record(const std::string& path, const Record<D>& record, const std::vector<std::string>& frames,
                  const std::vector<std::string>& segments);

/// The header of a run.h5: how far the run came. Throws InputError.
RunFacts read_run_facts(const std::string& folder);

/// The number of dimensions of the run of a folder. Throws InputError.
std::int64_t run_dimension(const std::string& folder);

/// Throws InputError where the run of a folder is not of two dimensions; `what` needs these, as in "the view".
void refuse_spheres(const std::string& folder, const std::string& what);

/// Text of the scene of a run.h5, as it was run. Throws InputError.
std::string read_run_scene(const std::string& folder);

/// The last state of a run folder: the record without series, base and track. Throws as read_record does.
template <int D>
Record<D> read_last_state(const std::string& folder);

/// Reads the series of a run.h5 into a record that has its walls. Throws InputError.
template <int D>
void read_series(const Hdf5Reader& file, Record<D>& record);

/// Reads scene.toml and run.h5 of a run folder. Throws InputError if there is none, it is damaged, or of another number
/// of dimensions.
template <int D>
Record<D> read_record(const std::string& folder);

/// A damaged file may name grains or walls that do not exist. Throws InputError then; readers of contacts call this,
/// and nothing behind them checks again.
template <int D>
void check_partners(const std::string& path, const OrderedGrains<D>& grains, const Contacts<D>& contacts,
                    std::size_t walls);

/// Throws InputError if a file of a run folder belongs to another run than its run.h5.
void check_belongs(const Hdf5Reader& file, const RunFacts& run);

/// The base profile of a run.h5; empty where there is none. Throws InputError.
BaseProfile read_base(const Hdf5Reader& file);

}  // namespace repose
