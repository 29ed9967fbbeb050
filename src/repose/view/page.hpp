// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace repose {

/// The page of a view: view/dist/page.html, which view/build.mjs makes.
std::string_view view_page();

/// The page with answers in it, which needs no server: `data` is a JSON object of answers by address, in which arrays
/// are base64 of their deflated bytes.
std::string page_with(const std::string& data);

}  // namespace repose
