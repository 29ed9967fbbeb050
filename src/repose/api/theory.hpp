// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/api/scene.hpp"
#include "repose/theory/table.hpp"

#include <string>
#include <vector>

namespace repose::api {

/// The names of the models of theory; see docs/theory/README.md.
std::vector<std::string> models();

/// The prediction of a model: columns of one length and single numbers, with units. Throws InputError with one line for
/// every problem of the settings.
repose::theory::Table predict(const std::string& model, const Settings& settings = {});

}  // namespace repose::api
