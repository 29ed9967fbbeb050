// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace repose {

/// Asks the system to back memory that nothing has used yet by huge pages, where it has them. A fault for each small
/// page of a large array costs more than to fill the array.
void prefer_huge_pages(const void* data, std::size_t bytes);

/// The same for the whole capacity of an array.
template <class T>
void prefer_huge_pages(const std::vector<T>& values) {
  prefer_huge_pages(values.data(), values.capacity() * sizeof(T));
}

}  // namespace repose
