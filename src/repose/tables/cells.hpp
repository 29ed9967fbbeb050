// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace repose {

// A cell as a value; none if it is anything else, not finite or out of range. A number may have a decimal comma and a
// Fortran exponent (1.0D+00); a whole number may be written as 1.0.
std::optional<double> number_of(std::string_view cell);
std::optional<std::int64_t> integer_of(std::string_view cell);
std::optional<bool> truth_of(std::string_view cell);  ///< 0, 1, true, false, yes, no, in any case

/// A cell without the blanks and quotes around it.
std::string_view trimmed(std::string_view cell);

/// A cell as messages show it: cut after 40 characters.
std::string shown(std::string_view cell);

/// In place of a separator: any number of blanks and tabs.
inline constexpr char blanks = ' ';

/// The cells of a line. Separators within quotes are text.
void split(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// The separator of a line of names: semicolon, tab, comma or blanks, the first that occurs in it.
char separator_of_names(std::string_view line);

/// A name at the head of a column, and its unit: "x (mm)", "x [mm]", "x / mm".
struct ColumnName {
  std::string name;
  std::string unit;  ///< "": none is given
};

/// The names in a line, with this separator. Blanks before a unit do not separate.
std::vector<ColumnName> column_names(std::string_view line, char separator);

/// A name in lower case, without blanks and the signs _ - . : between its words.
std::string plain_name(std::string_view name);

/// A unit of length, mass, time, velocity or rate in SI; none if it is unknown. "-" and "1" are 1.
std::optional<double> unit_of_length(std::string_view unit);    ///< [m]
std::optional<double> unit_of_mass(std::string_view unit);      ///< [kg]
std::optional<double> unit_of_velocity(std::string_view unit);  ///< [m/s]
bool is_unit(std::string_view unit);                            ///< any of these, a rate, or none

}  // namespace repose
