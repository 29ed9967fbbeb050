// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/checks.hpp"

#include <fmt/format.h>

namespace repose {

void check_stop(const Scene& scene, Reader& reader) {
  if (!scene.stop.time && !scene.stop.at_rest && reader.sound("stop.time") && reader.sound("stop.at_rest")) {
    reader.problem("stop", ": missing: give time, at_rest or both; the run ends at whichever comes first");
  }
  if (scene.stop.at_rest && scene.gravity == 0.0 && reader.sound("stop.at_rest") && reader.sound("gravity")) {
    reader.problem(
        "stop.at_rest",
        fmt::format(" = {}: is measured in grain weights and needs gravity > 0; use stop.time", *scene.stop.at_rest));
  }
}

}  // namespace repose
