// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace repose {

/// HDF5 files of Repose begin with a seal: a block of this size, which HDF5 leaves to its users, with the length and
/// the hash of the rest.
inline constexpr std::size_t seal_size = 512;

/// Writes the seal into the block at the start of a file. Throws RunError.
void seal(const std::string& path);

/// Whether a file begins with a seal, broken or not.
bool is_sealed(const std::string& path);

/// The problem of a sealed file that must not be read; "" if it is as it was written.
std::string broken_seal(const std::string& path);

}  // namespace repose
