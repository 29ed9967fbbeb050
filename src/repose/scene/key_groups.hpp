// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/keys.hpp"

namespace repose {

// The keys of a scene by subject, one source file each; `go_through` calls them in this order.

/// An array of tables [[key]], one per entry of a list.
template <class Entry>
void table_keys(Keys& keys, const std::string& key, std::vector<Entry>& list,
                const std::function<void(const std::string& prefix, Entry& entry, std::size_t index)>& each) {
  keys.tables(
      key,
      [&](std::size_t count) {
        if (count > 0) list.resize(count);
        return list.size();
      },
      [&](const std::string& prefix, std::size_t k) { each(prefix, list[k], k); });
}

/// The name of a material of the scene.
void material_key(const std::string& key, std::string& material, const Scene& scene, Keys& keys);

/// contact.*, materials and their pairs: the force laws (law_keys.cpp).
void law_keys(Scene& scene, Keys& keys);
/// Species of grains (species_keys.cpp).
void species_keys(Scene& scene, Keys& keys);
/// base, box and planes (boundary_keys.cpp).
void boundary_keys(Scene& scene, Keys& keys);
/// The start, placed grains and the source (source_keys.cpp).
void source_keys(Scene& scene, Keys& keys);
/// stop, output and analysis (run_keys.cpp).
void run_keys(Scene& scene, Keys& keys);

}  // namespace repose
