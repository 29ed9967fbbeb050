// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace repose {

/// Named arrays of 32-bit numbers behind a JSON header, as a page reads them: docs/reference/view.md.
class ArrayMessage {
 public:
  /// `header` gets the key `arrays`.
  explicit ArrayMessage(nlohmann::ordered_json header) : header_(std::move(header)) {
    header_["arrays"] = nlohmann::ordered_json::object();
  }

  void add(const std::string& name, const std::vector<float>& values, std::size_t columns = 1);
  void add(const std::string& name, const std::vector<std::uint32_t>& values, std::size_t columns = 1);
  void add(const std::string& name, const std::vector<double>& values, std::size_t columns = 1);
  /// Values as 16-bit numbers between their least and their largest; as floats where one of them is not finite.
  void add_packed(const std::string& name, const std::vector<float>& values, std::size_t columns = 1);
  void add_packed(const std::string& name, const std::vector<std::uint32_t>& values, std::size_t columns = 1);

  std::string bytes() const;

 private:
  nlohmann::ordered_json& entry(const std::string& name, const char* type, std::size_t rows, std::size_t columns);
  void append(const void* data, std::size_t size);

  nlohmann::ordered_json header_;
  std::string data_;
};

}  // namespace repose
