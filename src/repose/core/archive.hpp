// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace repose {

/// Visits the state of an object, name by name. A checkpoint being written stores each value that it visits; one being
/// restored sets it, to the bit. Each object has one function `exchange(Archive&)` for both directions, so that they
/// cannot drift apart.
class Archive {
 public:
  virtual ~Archive() = default;

  /// A number or any other trivially copyable value.
  template <class T>
  void value(const std::string& name, T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    block(name, sizeof(T), 1, &value,
          [&](std::size_t count) { return count == 1 ? static_cast<void*>(&value) : nullptr; });
  }

  template <class T>
  void array(const std::string& name, std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    block(name, sizeof(T), values.size(), values.data(), [&](std::size_t count) {
      values.resize(count);
      return static_cast<void*>(values.data());
    });
  }

  /// Whether the objects are being restored (true) or stored (false).
  virtual bool restoring() const = 0;

  /// When restoring, refuses the value of this name unless it fits the rest of the state.
  void check(const std::string& name, bool fits) const {
    if (restoring() && !fits) refuse(name);
  }

 protected:
  /// Stores or restores `count` items of `item` bytes at `data`. When restoring, `room(n)` returns memory for the n
  /// stored items, or null if n does not fit.
  virtual void block(const std::string& name, std::size_t item, std::size_t count, const void* data,
                     const std::function<void*(std::size_t count)>& room) = 0;
  virtual void refuse(const std::string& name) const = 0;
};

}  // namespace repose
