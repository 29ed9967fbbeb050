// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/reference.hpp"

#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/contact_problem/contact_problem_groups.hpp"
#include "repose/core/errors.hpp"
#include "repose/results/reference.hpp"
#include "repose/scene/material_library.hpp"
#include "repose/scene/reference.hpp"
#include "repose/sweep/groups.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace repose {

namespace {

/// A page of docs/reference, and its text or the tables in it.
struct Page {
  const char* name;
  std::string (*text)();
};
constexpr Page pages[] = {
    {"scene", scene_reference},
    {"run-folder", [] { return markdown_of(run_folder_reference()); }},
    {"summary", [] { return markdown_of(summary_reference()); }},
    {"analysis", [] { return markdown_of(analysis_reference()); }},
    {"contact-problem", [] { return markdown_of(contact_problem_reference()); }},
    {"materials", [] { return markdown_of(material_library_reference()); }},
    {"sweep", [] { return markdown_of(sweep_reference()); }},
};

std::vector<std::string> names_of_pages() {
  std::vector<std::string> names;
  for (const auto& page : pages) names.emplace_back(page.name);
  return names;
}

int act(const std::string& name) {
  for (const auto& page : pages) {
    if (name.empty()) say("{}\n", page.name);
    if (name != page.name) continue;
    say("{}", page.text());
    return 0;
  }
  if (!name.empty()) throw InputError(fmt::format("{}: no such page (`repose reference` lists them)", name));
  return 0;
}

}  // namespace

Verb reference_verb() {
  auto page = std::make_shared<std::string>();
  return {
      .name = "reference",
      .about = "Print the tables of a reference page as Markdown",
      .details =
          "The tables come from the lists by which the program reads scenes and writes files. Without PAGE "
          "the pages are listed.",
      .arguments = {{.name = "PAGE", .about = "Name of a page", .target = page.get(), .suggestions = names_of_pages}},
      .examples = {{"repose reference", "List the pages"},
                   {"repose reference scene", "Print every key of a scene: unit, default, bounds, meaning"}},
      .act = [page] { return act(*page); }};
}

}  // namespace repose
