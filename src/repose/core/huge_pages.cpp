// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/huge_pages.hpp"

#include <sys/mman.h>

#include <cstdint>

namespace repose {

void prefer_huge_pages(const void* data, std::size_t bytes) {
  constexpr std::uintptr_t huge = std::uintptr_t{1} << 21;
  const auto start = reinterpret_cast<std::uintptr_t>(data);
  const auto first = (start + huge - 1) / huge * huge;
  const auto last = (start + bytes) / huge * huge;
  if (first >= last) return;
  // A refusal costs speed alone.
  madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

}  // namespace repose
