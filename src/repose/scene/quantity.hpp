// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace repose {

/// Whether a text begins as a number does, and so is meant as a quantity such as "5 mm".
bool begins_as_number(std::string_view text);

/// The number of a quantity such as "5 mm", "2 g/cm^3" or "70 GPa" in the unit of a key, "L", "M/L^3" or "deg", where
/// L, M and T stand for metre, kilogram and second. Rounded to 15 digits, so that "5 mm" is 5e-3. Throws InputError,
/// without the place: what the text is not.
double number_of_quantity(const std::string& text, std::string_view unit);

}  // namespace repose
