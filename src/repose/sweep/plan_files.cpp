// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/io/start_file.hpp"
#include "repose/scene/toml_file.hpp"
#include "repose/scene/toml_text.hpp"
#include "repose/sweep/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;

namespace repose {

namespace {

/// A text with other paths in place of those that it names, as its author wrote it otherwise. `root` is what the new
/// text must say. Throws InputError where it does not.
std::string with_paths(std::string text, const std::map<std::string, std::string>& names, const toml::table& root,
                       const std::string& path) {
  for (const auto& [given, name] : names) {
    for (const auto& old_text : {toml_quoted(given), fmt::format("'{}'", given)}) {
      for (auto at = text.find(old_text); at != std::string::npos; at = text.find(old_text, at + 1)) {
        text.replace(at, old_text.size(), toml_quoted(name));
      }
    }
  }
  if (parsed_toml(text, path) != root) {
    throw InputError(
        fmt::format("{}: a path of a scene or of a start must be written plainly, and stand for nothing else", path));
  }
  return text;
}

/// Adds a scene under a name, and what it starts from, to the files.
void bring_scene(const std::string& path, const std::string& name, std::vector<SweepFile>& files) {
  auto text = text_of_file(path);
  auto root = parsed_toml(text, path);
  auto* start = root.get_as<toml::table>("start");
  const auto from = start != nullptr ? start->get("from") : nullptr;
  const auto given = from != nullptr ? from->value_or(std::string()) : "";
  if (!given.empty()) {
    const auto file = start_file((fs::path(path).parent_path() / given).string());
    const auto copy = fmt::format("{}-start{}", fs::path(name).stem().string(), fs::path(file).extension().string());
    start->insert_or_assign("from", copy);
    text = with_paths(text, {{given, copy}}, root, path);
    files.push_back({.name = "scenes/" + copy, .text = "", .copy_of = file});
  }
  files.push_back({.name = name, .text = text});
}

}  // namespace

std::vector<SweepFile> self_contained(const std::string& path, SweepForm form) {
  const auto text = text_of_file(path);
  auto root = parsed_toml(text, path);
  std::vector<SweepFile> files(1);
  std::map<std::string, std::string> names;  // of scenes, by path as given
  const auto bring = [&](toml::table& table) {
    const auto given = table.get("scene") != nullptr ? table.get("scene")->value<std::string>() : std::nullopt;
    if (!given) return;
    auto& name = names[*given];
    if (name.empty()) {
      // The name of a point without keys is that of its scene, so a scene keeps its own wherever it can.
      const auto own = "scenes/" + fs::path(*given).filename().string();
      const auto taken = [&](const SweepFile& file) { return file.name == own; };
      name = std::none_of(files.begin(), files.end(), taken)
                 ? own
                 : fmt::format("scenes/{}-{}", names.size(), fs::path(*given).filename().string());
      bring_scene((fs::path(path).parent_path() / *given).string(), name, files);
    }
    table.insert_or_assign("scene", name);
  };
  bring(root);
  if (auto* points = root.get_as<toml::array>("point")) {
    for (auto& point : *points) {
      if (auto* table = point.as_table()) bring(*table);
    }
  }
  const auto exchanged = with_paths(text, names, root, path);
  const bool says_quick = form == SweepForm::quick && !root.contains("form");
  files.front() = {"sweep.toml", (says_quick ? "form = \"quick\"\n" : "") + exchanged};
  return files;
}

}  // namespace repose
