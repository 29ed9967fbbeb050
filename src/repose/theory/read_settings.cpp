// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/read_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// "must be > 0 and < 60 (deg)".
std::string must_be(const Parameters::Item& item) {
  const bool with_unit = !item.unit.empty() && item.unit != "1";
  return fmt::format("must be {}{}", allowed_text(item), with_unit ? fmt::format(" ({})", item.unit) : "");
}

}  // namespace

SettingsReader::SettingsReader(const std::vector<std::pair<std::string, std::string>>& settings) {
  for (const auto& [name, value] : settings) {
    if (!settings_.emplace(name, value).second) problems_.push_back(fmt::format("{} = {}: is set twice", name, value));
  }
}

void SettingsReader::show(const Item& item) {
  known_.emplace(item.name);
  const auto found = settings_.find(item.name);
  if (found == settings_.end()) return missing(item);
  std::visit([&](const auto& kind) { read(item, found->second, kind); }, item.value);
}

void SettingsReader::missing(const Item& item) {
  if (const auto* number = std::get_if<Number>(&item.value); number != nullptr && std::isnan(number->value)) {
    problems_.push_back(fmt::format("{}: must be given: {}; {}", item.name, item.about, must_be(item)));
  }
  if (const auto* text = std::get_if<Text>(&item.value); text != nullptr && text->value.empty()) {
    problems_.push_back(fmt::format("{}: must be given: {}", item.name, item.about));
  }
}

void SettingsReader::complain(const Item& item, const std::string& written, const std::string& what) {
  problems_.push_back(fmt::format("{} = {}: {}", item.name, written, what));
}

void SettingsReader::read(const Item& item, const std::string& written, const Number& number) {
  double value = 0.0;
  if (!read_all(written, value) || std::isnan(value)) {
    complain(item, written, "is not a number; " + must_be(item));
  } else if (!number.bounds.hold(value)) {
    complain(item, written, must_be(item));
  } else {
    number.value = value;
  }
}

void SettingsReader::read(const Item& item, const std::string& written, const OptionalNumber& number) {
  read(item, written, Number{number.value.emplace(), required, number.bounds});
}

void SettingsReader::read(const Item& item, const std::string& written, const Whole& whole) {
  std::int64_t value = 0;
  if (!read_all(written, value)) {
    complain(item, written, "is not a whole number; " + must_be(item));
  } else if (!whole.bounds.hold(value)) {
    complain(item, written, must_be(item));
  } else {
    whole.value = value;
  }
}

void SettingsReader::read(const Item& item, const std::string& written, const Choice& choice) {
  const auto known = std::ranges::any_of(choice.words, [&](const auto& word) { return word.name == written; });
  if (!known) return complain(item, written, must_be(item));
  choice.value = written;
}

void SettingsReader::read(const Item& item, const std::string& written, const Text& text) {
  if (written.empty()) return missing(item);
  text.value = written;
}

std::string problem_of(std::string_view model, std::string_view problem) {
  return fmt::format("{}: {}", model, problem);
}

std::vector<std::string> SettingsReader::problems(std::string_view model) const {
  std::vector<std::string> all;
  for (const auto& problem : problems_) all.push_back(problem_of(model, problem));
  for (const auto& [name, value] : settings_) {
    if (!known_.contains(name)) {
      all.push_back(fmt::format("{}: {}: no such parameter; must be {}", model, name, fmt::join(known_, " | ")));
    }
  }
  return all;
}

}  // namespace repose::theory
