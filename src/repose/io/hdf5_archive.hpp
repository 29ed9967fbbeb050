// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"

#include <fmt/format.h>

namespace repose {

/// Stores state in a group of an HDF5 file.
class ArchiveWriter final : public Archive {
 public:
  ArchiveWriter(Hdf5File& file, std::string group) : file_(file), group_(std::move(group)) {}
  bool restoring() const override { return false; }

 private:
  void block(const std::string& name, std::size_t item, std::size_t count, const void* data,
             const std::function<void*(std::size_t count)>&) override {
    file_.bytes(group_ + "/" + name, item, count, data);
  }
  void refuse(const std::string&) const override {}

  Hdf5File& file_;
  std::string group_;
};

/// Restores state from a group of an HDF5 file.
class ArchiveReader final : public Archive {
 public:
  ArchiveReader(const Hdf5Reader& file, std::string group) : file_(file), group_(std::move(group)) {}
  bool restoring() const override { return true; }

 private:
  void block(const std::string& name, std::size_t item, std::size_t, const void*,
             const std::function<void*(std::size_t count)>& room) override {
    file_.bytes(group_ + "/" + name, item, room);
  }
  void refuse(const std::string& name) const override {
    throw InputError(fmt::format("{}: {}/{}: does not fit the rest of the state", file_.path(), group_, name));
  }

  const Hdf5Reader& file_;
  std::string group_;
};

}  // namespace repose
