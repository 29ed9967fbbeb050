// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/contact_problem/contact_problem_groups.hpp"

#include <string>
#include <vector>

namespace repose {

/// What is wrong with the tables of a contact problem: for each kind of mistake a line with the first wrong row and
/// their number. Empty where all is right.
std::vector<std::string> contact_problem_mistakes(const std::string& path, const std::vector<BodyRow>& bodies,
                                                  const std::vector<ContactRow>& contacts);

}  // namespace repose
