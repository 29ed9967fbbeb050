// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/writer.hpp"

#include "repose/scene/toml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <vector>

namespace repose {

namespace {

/// A value as TOML writes it; "" where there is none to write.
class TomlValue {
 public:
  std::string operator()(const Parameters::Number& it) const { return toml_number(it.value); }
  std::string operator()(const Parameters::OptionalNumber& it) const {
    if (it.value) return toml_number(*it.value);
    return it.without.word.empty() ? "" : toml_quoted(it.without.word);
  }
  std::string operator()(const Parameters::Whole& it) const { return fmt::format("{}", it.value); }
  std::string operator()(const Parameters::Flag& it) const { return *it.value ? "true" : "false"; }
  std::string operator()(const Parameters::Text& it) const { return toml_quoted(it.value); }
  std::string operator()(const Parameters::Choice& it) const { return toml_quoted(it.value); }
  std::string operator()(const Parameters::Vector& it) const { return list_of(it.value); }
  std::string operator()(const Parameters::List& it) const { return list_of(it.values); }

 private:
  static std::string list_of(std::span<const double> values) {
    std::string list;
    for (const double value : values) list += (list.empty() ? "" : ", ") + toml_number(value);
    return fmt::format("[{}]", list);
  }
};

/// ": hooke, hertz", or with meanings ": row (fixed discs side by side), none (nothing)"; "" if there is nothing to
/// choose, or the text on the key has told it.
std::string words_of(const Parameters::Choice& choice, std::string_view about) {
  const auto told = [&](const Word& word) { return about.find(word.name) != std::string_view::npos; };
  if (choice.words.size() < 2 || std::all_of(choice.words.begin(), choice.words.end(), told)) return "";
  std::vector<std::string> words;
  for (const auto& word : choice.words) {
    words.push_back(word.about.empty() ? std::string(word.name) : fmt::format("{} ({})", word.name, word.about));
  }
  return fmt::format(": {}", fmt::join(words, ", "));
}

/// "[L] between the centres".
std::string comment_on(const Parameters::Item& item) {
  const auto* choice = std::get_if<Parameters::Choice>(&item.value);
  return fmt::format("{}{}{}", item.unit.empty() ? "" : fmt::format("[{}] ", item.unit), item.about,
                     choice == nullptr ? "" : words_of(*choice, item.about));
}

/// The header of a table inside the present entry of a list: TOML names no places there.
std::string without_places(std::string section) {
  for (auto open = section.find('['); open != std::string::npos; open = section.find('[')) {
    section.erase(open, section.find(']', open) - open + 1);
  }
  return section;
}

}  // namespace

void Writer::show(const Item& item) {
  const auto line = choose_(item);
  auto value = std::visit(TomlValue(), item.value);
  if (line == Line::none || (line == Line::full && value.empty())) return;
  if (value.empty()) value = "...";
  const std::string key(item.name);
  const auto dot = key.rfind('.');
  const std::string section = dot == std::string::npos ? "" : key.substr(0, dot);
  if (section != section_) {
    section_ = section;
    out_ += fmt::format("\n[{}]\n", without_places(section));
  }
  out_ += fmt::format("{}{} = {}  # {}\n", line == Line::comment ? "# " : "",
                      dot == std::string::npos ? key : key.substr(dot + 1), value, comment_on(item));
}

void Writer::tables(std::string_view name, const std::function<std::size_t(std::size_t)>& resize,
                    const std::function<void(Parameters& entry, std::size_t index)>& each) {
  const auto count = resize(0);
  for (std::size_t k = 0; k < count; ++k) {
    out_ += fmt::format("\n[[{}]]\n", name);
    section_ = fmt::format("{}[{}]", name, k);
    Prefixed entry(section_ + ".", *this);
    each(entry, k);
  }
}

}  // namespace repose
