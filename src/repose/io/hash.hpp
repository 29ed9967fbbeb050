// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace repose {

/// The XXH3-128 hash of a stream of bytes, as 32 hexadecimal digits.
class Hash {
 public:
  Hash();
  ~Hash();
  Hash(const Hash&) = delete;
  Hash& operator=(const Hash&) = delete;

  void add(const void* data, std::size_t size);
  template <class T>
  void add(const std::vector<T>& values) {
    add(values.data(), values.size() * sizeof(T));
  }
  std::string text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The hash of a text.
std::string hash_of(std::string_view text);

}  // namespace repose
