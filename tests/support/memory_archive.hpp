// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/core/errors.hpp"

#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace repose::testing {

/// An archive that keeps bytes by name, in memory.
class MemoryArchive final : public Archive {
 public:
  bool restore = false;
  bool restoring() const override { return restore; }

 protected:
  void block(const std::string& name, std::size_t item, std::size_t count, const void* data,
             const std::function<void*(std::size_t)>& room) override {
    auto& kept = kept_[name];
    if (!restore) {
      const auto* bytes = static_cast<const char*>(data);
      kept.assign(bytes, bytes + item * count);
    } else if (auto* to = room(kept.size() / item); !kept.empty()) {
      std::memcpy(to, kept.data(), kept.size());
    }
  }
  void refuse(const std::string& name) const override { throw RunError(name); }

 private:
  std::map<std::string, std::vector<char>> kept_;
};

}  // namespace repose::testing
