// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace repose {

/// The coarse-grained fields of the last state: `api/fields` of docs/reference/view.md. Throws InputError where the
/// analysis has none.
std::string field_arrays(const std::string& folder);

}  // namespace repose
