// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/starting_scene.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/for_method.hpp"
#include "repose/scene/keys.hpp"
#include "repose/scene/reader.hpp"
#include "repose/scene/scene.hpp"
#include "repose/scene/writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace repose {

namespace {

/// The lines of comment that a text begins with.
std::string first_comment(const std::string& text) {
  std::size_t end = 0;
  while (end < text.size() && text[end] == '#') end = std::min(text.find('\n', end), text.size() - 1) + 1;
  return text.substr(0, end);
}

constexpr std::string_view how_to =
    "#\n"
    "# A line that begins with # shows a key with its default: take the # away to change it. `repose check FILE` "
    "tells\n"
    "# what would run, `repose run FILE` runs it, `repose reference scene` lists all keys.\n";

}  // namespace

std::vector<StartingKind> starting_kinds() {
  std::vector<StartingKind> kinds;
  for (const auto& example : example_scenes()) {
    const std::string text(example.text);
    const auto root = parsed_toml(text, std::string(example.name));
    if (root.at_path("start.from").is_string()) continue;
    kinds.push_back({std::string(example.name), root["title"].value_or(std::string()), text});
  }
  return kinds;
}

std::string starting_scene(std::string_view kind) {
  const auto kinds = starting_kinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.name == kind; });
  if (found == kinds.end()) {
    std::vector<std::string> names;
    for (const auto& one : kinds) names.push_back(one.name);
    throw InputError(fmt::format("{}: no such kind of scene; must be {}", kind, fmt::join(names, " | ")));
  }
  auto root = parsed_toml(found->text, found->name);
  std::vector<std::string> problems;
  apply_keys_for_method(root, found->name, problems);
  REPOSE_ASSERT(problems.empty());
  Reader reader(root, found->name);
  Scene scene;
  show_keys(scene, reader);
  Writer writer([&](const auto& item) {
    if (reader.given(item.name)) return Writer::Line::full;
    // The first entry of a list shows the keys that it could have besides.
    const auto entry = item.name.find('[');
    const bool later = entry != std::string_view::npos && item.name.substr(entry, 3) != "[0]";
    return later ? Writer::Line::none : Writer::Line::comment;
  });
  show_keys(scene, writer);
  return first_comment(found->text) + std::string(how_to) + writer.out();
}

}  // namespace repose
