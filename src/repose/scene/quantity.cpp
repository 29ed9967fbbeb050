// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/quantity.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>

namespace repose {

namespace {

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;

/// The units of the library udunits2, read once. Null where its table is missing.
const ut_system* unit_system() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    return ut_read_xml(nullptr);
  }();
  return system;
}

Unit parsed(const std::string& text) {
  return {ut_parse(const_cast<ut_system*>(unit_system()), text.c_str(), UT_ASCII), &ut_free};
}

/// The unit of a key in SI; nothing where it is no unit of measurement, such as "diameters".
std::optional<std::string> in_si(std::string_view unit) {
  if (unit == "deg") return "degree";
  std::string text;
  for (const char c : unit) {
    if (c == 'L') {
      text += "m";
    } else if (c == 'M') {
      text += "kg";
    } else if (c == 'T') {
      text += "s";
    } else if (std::string_view("0123456789/^() ").find(c) != std::string_view::npos) {
      text += c;
    } else {
      return std::nullopt;
    }
  }
  if (text.empty() || text.find("(1/2)") != std::string::npos) return std::nullopt;
  return text;
}

}  // namespace

bool begins_as_number(std::string_view text) {
  const auto first = text.find_first_not_of("+-.");
  return first != std::string_view::npos && first <= 2 && text[first] >= '0' && text[first] <= '9';
}

double number_of_quantity(const std::string& text, std::string_view unit) {
  const auto wanted_text = in_si(unit);
  if (!wanted_text) throw InputError("must be a plain number");
  if (unit_system() == nullptr)
    throw InputError("no table of units (Debian's package libudunits2-data): must be a number");
  const auto wanted = parsed(*wanted_text);
  const auto given = parsed(text);
  if (!given) throw InputError(fmt::format("is no quantity that is known; must be a number in {}", *wanted_text));
  if (ut_are_convertible(given.get(), wanted.get()) == 0) {
    throw InputError(fmt::format("is of another kind; must be a quantity in {}", *wanted_text));
  }
  const std::unique_ptr<cv_converter, decltype(&cv_free)> converter(ut_get_converter(given.get(), wanted.get()),
                                                                    &cv_free);
  const double number = cv_convert_double(converter.get(), 1.0);
  return std::strtod(fmt::format("{:.15g}", number).c_str(), nullptr);
}

}  // namespace repose
