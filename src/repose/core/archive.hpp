// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace repose {

/// Goes through the state of an object, name by name: a checkpoint keeps what it is shown or gives it back, bit for
/// bit. Each object has one function `exchange(Archive&)` for both, so that the two cannot drift apart.
class Archive {
 public:
  virtual ~Archive() = default;

  /// A number, or anything else that is its bytes.
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

  /// Whether the objects are being filled in.
  virtual bool restoring() const = 0;

  /// To be told whether what was given back under this name fits the rest; what does not is refused.
  void check(const std::string& name, bool fits) const {
    if (restoring() && !fits) refuse(name);
  }

 protected:
  /// `count` items of `item` bytes at `data`; when restoring, `room` makes room for as many as were kept.
  virtual void block(const std::string& name, std::size_t item, std::size_t count, const void* data,
                     const std::function<void*(std::size_t count)>& room) = 0;
  virtual void refuse(const std::string& name) const = 0;
};

}  // namespace repose
