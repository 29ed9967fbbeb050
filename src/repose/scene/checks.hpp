// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/reader.hpp"
#include "repose/scene/scene.hpp"

namespace repose {

// What one key alone cannot tell, by subject, one source file each. Problems go to the reader; keys that are wrong by
// themselves already are left alone.

void check_laws(const Scene& scene, Reader& reader);
void check_species(const Scene& scene, Reader& reader);
void check_boundaries(const Scene& scene, Reader& reader);
void check_sources(const Scene& scene, Reader& reader);
void check_rigid(const Scene& scene, Reader& reader);
void check_deposition(const Scene& scene, Reader& reader);
void check_packing(const Scene& scene, Reader& reader);
void check_stop(const Scene& scene, Reader& reader);

}  // namespace repose
