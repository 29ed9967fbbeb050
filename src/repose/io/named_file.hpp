// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace repose {

// Files that a user names, which may be links, pipes or devices.

/// The reason why a path cannot be read as a file, "is no regular file" or that of the system; "" if it can.
std::string why_not_readable(const std::string& path);

/// The path that links lead to; the file there need not exist.
std::string followed(const std::string& path);

/// Makes `text` the content of a file: of a regular one all at once, behind links; straight into a pipe or a device.
/// Throws RunError.
void write_named_file(const std::string& path, std::string_view text);

}  // namespace repose
