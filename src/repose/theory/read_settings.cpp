// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/read_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace repose::theory {

namespace {

/// Whether all of the text was read as a number of this kind.
template <class T>
bool read_all(const std::string& text, T& value) {
  const auto* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc{} && result.ptr == end;
}

std::string with_unit(const Bounds& bounds, std::string_view unit) {
  return unit.empty() || unit == "1" ? bounds.text() : fmt::format("{} ({})", bounds.text(), unit);
}

}  // namespace

SettingsReader::SettingsReader(const std::vector<std::pair<std::string, std::string>>& settings) {
  for (const auto& [name, value] : settings) {
    if (!settings_.emplace(name, value).second) complain(name, value, "is set twice");
  }
}

const std::string* SettingsReader::take(std::string_view name) {
  known_.emplace(name);
  const auto found = settings_.find(name);
  return found == settings_.end() ? nullptr : &found->second;
}

void SettingsReader::complain(std::string_view name, const std::string& written, const std::string& what) {
  problems_.push_back(fmt::format("{} = {}: {}", name, written, what));
}

void SettingsReader::read(std::string_view name, const std::string& written, double& value, const Bounds& bounds,
                          std::string_view unit) {
  double number = 0.0;
  if (!read_all(written, number) || std::isnan(number)) {
    complain(name, written, fmt::format("is not a number; {}", with_unit(bounds, unit)));
  } else if (!bounds.holds(number) || (std::isinf(number) && !bounds.infinite_allowed)) {
    complain(name, written, with_unit(bounds, unit));
  } else {
    value = number;
  }
}

void SettingsReader::number(std::string_view name, double& value, const Bounds& bounds, std::string_view unit,
                            std::string_view about) {
  if (const auto* written = take(name)) {
    read(name, *written, value, bounds, unit);
  } else if (std::isnan(value)) {
    problems_.push_back(fmt::format("{}: must be given: {}; {}", name, about, with_unit(bounds, unit)));
  }
}

void SettingsReader::optional_number(std::string_view name, std::optional<double>& value,
                                     std::string_view /*otherwise*/, const Bounds& bounds, std::string_view unit,
                                     std::string_view /*about*/) {
  if (const auto* written = take(name)) read(name, *written, value.emplace(), bounds, unit);
}

void SettingsReader::integer(std::string_view name, std::int64_t& value, const WholeBounds& bounds,
                             std::string_view /*about*/) {
  const auto* written = take(name);
  if (written == nullptr) return;
  std::int64_t number = 0;
  if (!read_all(*written, number)) {
    complain(name, *written, fmt::format("is not a whole number; {}", bounds.text()));
  } else if (number < bounds.low || number > bounds.high) {
    complain(name, *written, bounds.text());
  } else {
    value = number;
  }
}

void SettingsReader::choice(std::string_view name, std::string& value, const std::vector<std::string>& words,
                            std::string_view /*about*/) {
  const auto* written = take(name);
  if (written == nullptr) return;
  if (std::ranges::find(words, *written) == words.end()) {
    complain(name, *written, fmt::format("must be {}", fmt::join(words, " | ")));
  } else {
    value = *written;
  }
}

void SettingsReader::text(std::string_view name, std::string& value, std::string_view about) {
  if (const auto* written = take(name)) value = *written;
  if (value.empty()) problems_.push_back(fmt::format("{}: must be given: {}", name, about));
}

std::vector<std::string> SettingsReader::problems(std::string_view model) const {
  std::vector<std::string> all;
  for (const auto& problem : problems_) all.push_back(fmt::format("{}: {}", model, problem));
  for (const auto& [name, value] : settings_) {
    if (!known_.contains(name)) {
      all.push_back(fmt::format("{}: {}: no such parameter; must be {}", model, name, fmt::join(known_, " | ")));
    }
  }
  return all;
}

}  // namespace repose::theory
