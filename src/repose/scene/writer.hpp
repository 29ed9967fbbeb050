// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"

#include <functional>
#include <string>

namespace repose {

/// Writes the keys that it is shown as TOML: each with its unit and meaning, under the header of its table.
class Writer final : public Parameters {
 public:
  /// How a key is written.
  enum class Line {
    full,     ///< with its value
    comment,  ///< as a comment, so that the default holds
    none
  };
  using Choose = std::function<Line(const Item& item)>;

  explicit Writer(Choose choose) : choose_(std::move(choose)) {}

  void tables(std::string_view name, const std::function<std::size_t(std::size_t)>& resize,
              const std::function<void(Parameters& entry, std::size_t index)>& each) override;

  const std::string& out() const { return out_; }

 private:
  void show(const Item& item) override;

  Choose choose_;
  std::string out_;
  std::string section_;
};

}  // namespace repose
