// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/reference.hpp"

#include "repose/cli/commands.hpp"
#include "repose/core/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace repose {

namespace {

/// A page of the reference that is made from the lists that the program reads and writes by.
struct Page {
  const char* name;
  std::function<std::string()> text;
};

const std::vector<Page>& pages() {
  static const std::vector<Page> all = {{"scene", scene_reference}};
  return all;
}

}  // namespace

Command add_reference(CLI::App& app) {
  auto page = std::make_shared<std::string>();
  auto* command = app.add_subcommand("reference", "Print the tables of a page of the reference, in Markdown");
  command->add_option("PAGE", *page, "page, as in `repose reference scene`")->required();
  return {command, [page] {
            std::vector<std::string> names;
            for (const auto& one : pages()) {
              if (one.name == *page) {
                fmt::print("{}", one.text());
                return 0;
              }
              names.emplace_back(one.name);
            }
            throw InputError(fmt::format("{}: no such page; must be {}", *page, fmt::join(names, " | ")));
          }};
}

}  // namespace repose
