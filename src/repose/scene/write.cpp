// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/write.hpp"

#include "repose/scene/keys.hpp"
#include "repose/scene/writer.hpp"

namespace repose {

std::string scene_text(const Scene& scene) {
  Scene copy = scene;  // showing the keys may write into a scene; on a complete one it changes nothing
  Writer writer([](const auto&) { return Writer::Line::full; });
  show_keys(copy, writer);
  return writer.out();
}

std::string given_text(const Scene& scene) {
  Scene copy = scene;
  Writer writer([](const auto& item) {
    if (!is_unset(item)) return Writer::Line::full;
    take_default(item);  // which keys follow may depend on it
    return Writer::Line::none;
  });
  show_keys(copy, writer);
  return writer.out();
}

}  // namespace repose
