// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/scene/toml_file.hpp"
#include "repose/scene/toml_text.hpp"
#include "repose/sweep/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;

namespace repose {

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
      files.push_back({name, text_of_file((fs::path(path).parent_path() / *given).string())});
    }
    table.insert_or_assign("scene", name);
  };
  bring(root);
  if (auto* points = root.get_as<toml::array>("point")) {
    for (auto& point : *points) {
      if (auto* table = point.as_table()) bring(*table);
    }
  }
  // The file as its author wrote it, with its comments; only the paths are exchanged.
  std::string exchanged = text;
  for (const auto& [given, name] : names) {
    for (const auto& old_text : {toml_quoted(given), fmt::format("'{}'", given)}) {
      for (auto at = exchanged.find(old_text); at != std::string::npos; at = exchanged.find(old_text, at + 1)) {
        exchanged.replace(at, old_text.size(), toml_quoted(name));
      }
    }
  }
  if (parsed_toml(exchanged, path) != root) {
    throw InputError(fmt::format("{}: scene: a path must be written plainly, and stand for nothing but a scene", path));
  }
  const bool says_quick = form == SweepForm::quick && !root.contains("form");
  files.front() = {"sweep.toml", (says_quick ? "form = \"quick\"\n" : "") + exchanged};
  return files;
}

}  // namespace repose
