// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/starting_scene.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/write.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace repose {
namespace {

TEST(StartingScene, MeansTheSameAsItsExample) {
  const auto kinds = starting_kinds();
  ASSERT_GT(kinds.size(), 15U);
  for (const auto& kind : kinds) {
    const auto text = starting_scene(kind.name);
    EXPECT_EQ(scene_text(scene_from_text(text, kind.name)), scene_text(scene_from_text(kind.text, kind.name)));
    EXPECT_FALSE(kind.title.empty()) << kind.name;
  }
}

// Every line that sets a key tells its meaning, and so does every one that could.
TEST(StartingScene, EveryKeyHasAComment) {
  for (const auto& kind : starting_kinds()) {
    const auto text = starting_scene(kind.name);
    for (std::size_t at = text.find("\ntitle = ") + 1; at < text.size(); at = text.find('\n', at) + 1) {
      const auto line = text.substr(at, text.find('\n', at) - at);
      if (line.find(" = ") == std::string::npos) continue;
      EXPECT_NE(line.find("  # "), std::string::npos) << kind.name << ": " << line;
    }
  }
}

// What the example leaves out stands there as a comment; it is not set.
TEST(StartingScene, DefaultsAreComments) {
  const auto text = starting_scene("heap");
  EXPECT_NE(text.find("\nfriction = 0.5  # Coulomb coefficient mu\n"), std::string::npos);
  EXPECT_NE(text.find("\n# skin = 0.3  # [L] extra reach"), std::string::npos);
  EXPECT_EQ(text.find("\nskin = "), std::string::npos);
}

TEST(StartingScene, ScenesThatNeedFilesAreLeftOut) {
  const auto kinds = starting_kinds();
  const auto any = [&](const std::string& name) {
    return std::any_of(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.name == name; });
  };
  EXPECT_TRUE(any("hopper") && any("deposition-cd"));
  EXPECT_FALSE(any("from-file") || any("from-run"));
  EXPECT_THROW(starting_scene("castle"), InputError);
}

}  // namespace
}  // namespace repose
