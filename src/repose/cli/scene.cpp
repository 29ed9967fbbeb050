// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/scene/starting_scene.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

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

}  // namespace

Command add_scene(CLI::App& app) {
  auto kind = std::make_shared<std::string>();
  auto* command = app.add_subcommand("scene", "Print a commented scene to begin with; without KIND, list the kinds");
  command->add_option("KIND", *kind, "kind of scene, as in `repose scene heap > heap.toml`");
  return {command, [kind] {
            fmt::print("{}", kind->empty() ? list_of_kinds() : starting_scene(*kind));
            return 0;
          }};
}

}  // namespace repose
