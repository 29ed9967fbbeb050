// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/checks.hpp"

#include <fmt/format.h>

namespace repose {

void check_laws(const Scene& scene, Reader& reader) {
  const bool continuous = std::holds_alternative<Continuous>(scene.contact.normal);
  if (continuous && scene.gravity == 0.0 && reader.sound("gravity")) {
    reader.problem("gravity", " = 0: the continuous law has its force scale from gravity; use hooke or gravity > 0");
  }
}

}  // namespace repose
