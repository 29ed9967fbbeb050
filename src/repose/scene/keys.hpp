// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"

#include <vector>

namespace repose {

struct Scene;

/// Shows every key of a scene, in order, as a dotted path: "contact.normal.stiffness". The reader fills the scene in,
/// the writer writes it out, the reference lists what there is.
void show_keys(Scene& scene, Parameters& keys);

/// An array of tables [[key]], one per entry of a list. `each` takes the keys of an entry, the entry and its number.
template <class Entry, class Each>
void table_keys(Parameters& keys, std::string_view key, std::vector<Entry>& list, const Each& each) {
  keys.tables(
      key,
      [&](std::size_t count) {
        if (count > 0) list.resize(count);
        return list.size();
      },
      [&](Parameters& entry, std::size_t k) { each(entry, list[k], k); });
}

}  // namespace repose
