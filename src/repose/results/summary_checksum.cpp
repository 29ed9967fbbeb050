// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/io/hash.hpp"
#include "repose/results/summary.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace repose {

namespace {

constexpr std::string_view last_key = ",\n  \"checksum\": ";
/// No text inside a JSON document has a line break, so that only a key of the summary itself begins so.
constexpr std::string_view theory_key = ",\n  \"theory\": ";

/// The end of a summary whose text begins so: the hash of that, under the last key.
std::string ending(std::string_view beginning) { return fmt::format("{}\"{}\"\n}}\n", last_key, hash_of(beginning)); }

}  // namespace

std::string with_checksum(std::string json) {
  json.resize(json.rfind("\n}"));
  return json + ending(json);
}

bool is_whole_summary(std::string_view text) {
  const auto end = text.rfind(last_key);
  return end != std::string_view::npos && text.substr(end) == ending(text.substr(0, end));
}

std::string with_theory(const std::string& text, const std::string& theory) {
  REPOSE_ASSERT(is_whole_summary(text));
  auto beginning = text.substr(0, text.rfind(last_key));
  if (const auto older = beginning.find(theory_key); older != std::string::npos) beginning.resize(older);
  if (!theory.empty()) beginning += std::string{theory_key} + theory;
  return beginning + ending(beginning);
}

std::string summary_status(const std::string& text) {
  if (!is_whole_summary(text)) return "";
  const auto json = nlohmann::json::parse(text, nullptr, false);
  return json.is_object() ? json.value("status", std::string()) : std::string();
}

}  // namespace repose
