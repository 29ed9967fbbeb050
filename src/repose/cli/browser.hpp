// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace repose {

/// Opens an address in the browser of the desktop. Returns whether there is a desktop and a program that opens.
bool open_in_browser(const std::string& address);

}  // namespace repose
