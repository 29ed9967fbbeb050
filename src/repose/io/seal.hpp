// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace repose {

/// Our HDF5 files begin with a block of this size, which HDF5 leaves to its users: length and hash of what follows.
inline constexpr std::size_t seal_size = 512;

/// Writes the seal of a file that has room for it. Throws RunError.
void seal(const std::string& path);

/// Whether a file begins with a seal, be it broken.
bool is_sealed(const std::string& path);

/// What is wrong with a sealed file, which then must not be read; "" if it is as it was written.
std::string broken_seal(const std::string& path);

}  // namespace repose
