// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/view/arrays.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace repose {

static_assert(std::endian::native == std::endian::little, "arrays are sent as they lie in memory");

namespace {

constexpr std::size_t word = 4;  // bytes: arrays begin at multiples of it

}  // namespace

nlohmann::ordered_json& ArrayMessage::entry(const std::string& name, const char* type, std::size_t rows,
                                            std::size_t columns) {
  auto shape = nlohmann::ordered_json::array({rows / columns});
  if (columns > 1) shape.push_back(columns);
  auto& made = header_["arrays"][name];
  made = {{"type", type}, {"shape", shape}, {"offset", data_.size()}};
  return made;
}

void ArrayMessage::append(const void* data, std::size_t size) {
  data_.append(static_cast<const char*>(data), size);
  data_.append((word - data_.size() % word) % word, '\0');
}

void ArrayMessage::add(const std::string& name, const std::vector<float>& values, std::size_t columns) {
  entry(name, "f32", values.size(), columns);
  append(values.data(), values.size() * sizeof(float));
}

void ArrayMessage::add(const std::string& name, const std::vector<std::uint32_t>& values, std::size_t columns) {
  entry(name, "u32", values.size(), columns);
  append(values.data(), values.size() * sizeof(std::uint32_t));
}

void ArrayMessage::add(const std::string& name, const std::vector<double>& values, std::size_t columns) {
  add(name, std::vector<float>(values.begin(), values.end()), columns);
}

void ArrayMessage::add_packed(const std::string& name, const std::vector<float>& values, std::size_t columns) {
  const auto finite = [](float x) { return std::isfinite(x); };
  if (values.empty() || !std::all_of(values.begin(), values.end(), finite)) return add(name, values, columns);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double scale = (double{*high} - double{*low}) / 65535.0;
  std::vector<std::uint16_t> packed;
  packed.reserve(values.size());
  for (const float x : values) {
    const double steps = scale > 0.0 ? std::round((double{x} - double{*low}) / scale) : 0.0;
    packed.push_back(static_cast<std::uint16_t>(std::clamp(steps, 0.0, 65535.0)));
  }
  auto& made = entry(name, "u16", values.size(), columns);
  made["low"] = *low;
  made["scale"] = scale;
  append(packed.data(), packed.size() * sizeof(std::uint16_t));
}

void ArrayMessage::add_packed(const std::string& name, const std::vector<std::uint32_t>& values, std::size_t columns) {
  const auto most = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  if (most > std::numeric_limits<std::uint16_t>::max()) return add(name, values, columns);
  const auto keep = [&](const auto& packed, const char* type) {
    entry(name, type, values.size(), columns);
    append(packed.data(), packed.size() * sizeof(packed[0]));
  };
  if (most > std::numeric_limits<std::uint8_t>::max()) {
    keep(std::vector<std::uint16_t>(values.begin(), values.end()), "u16");
  } else {
    keep(std::vector<std::uint8_t>(values.begin(), values.end()), "u8");
  }
}

std::string ArrayMessage::bytes() const {
  auto text = header_.dump();
  text.append((word - text.size() % word) % word, ' ');
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string all = "RPV1";
  all.append(reinterpret_cast<const char*>(&length), sizeof length);
  return all + text + data_;
}

}  // namespace repose
