// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/toml_file.hpp"
#include "repose/sweep/plan.hpp"

#include <string>

namespace repose {

/// Gives a sweep file the form that is wanted: [quick] replaces seeds and values of [set] and [vary] in the quick form,
/// and is removed in both. A file with the key form = "quick", as folders of quick sweeps have, has that form. Throws
/// InputError where [quick] is wrong; `path` is that of the file.
void take_form(toml::table& root, SweepForm form, const std::string& path);

}  // namespace repose
