// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace repose {

/// A scene of the folder examples, as the program carries it along.
struct ExampleScene {
  std::string_view name;  ///< of the file, without .toml
  std::string_view text;
};

/// All of them, by name. The build makes the list from the files.
const std::vector<ExampleScene>& example_scenes();

/// A scene to begin with.
struct StartingKind {
  std::string name;
  std::string title;
  std::string text;  ///< the example that it is made from
};

/// The examples that need no file but their own, by name.
std::vector<StartingKind> starting_kinds();

/// A scene of this kind to begin with: what the example sets, and as comments all else that can be set, each key with
/// its unit and meaning, for the method of the example alone. Throws InputError if there is no such kind.
std::string starting_scene(std::string_view kind);

}  // namespace repose
