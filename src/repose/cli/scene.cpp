// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/scene/starting_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace repose {

namespace {

std::string list_of_kinds() {
  const auto kinds = starting_kinds();
  std::size_t width = 0;
  for (const auto& kind : kinds) width = std::max(width, kind.name.size());
  std::string list;
  for (const auto& kind : kinds) list += fmt::format("{:{}}  {}\n", kind.name, width, kind.title);
  return list;
}

std::vector<std::string> names_of_kinds() {
  std::vector<std::string> names;
  for (const auto& kind : starting_kinds()) names.push_back(kind.name);
  return names;
}

int print_scene(const std::string& kind) {
  say("{}", kind.empty() ? list_of_kinds() : starting_scene(kind));
  return 0;
}

}  // namespace

Verb scene_verb() {
  auto kind = std::make_shared<std::string>();
  return {
      .name = "scene",
      .about = "Print a commented scene to start from",
      .details = "Without KIND the kinds are listed.",
      .arguments = {{.name = "KIND", .about = "Kind of scene", .target = kind.get(), .suggestions = names_of_kinds}},
      .examples = {{"repose scene", "List the kinds"},
                   {"repose scene heap > my-heap.toml", "Start a scene of a heap"},
                   {"repose check my-heap.toml", "See what it would run, after editing it"}},
      .act = [kind] { return print_scene(*kind); }};
}

}  // namespace repose
