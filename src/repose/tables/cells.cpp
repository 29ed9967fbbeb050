// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/tables/cells.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace repose {

namespace {

constexpr const char* white = " \t\r";

template <class T>
std::optional<T> whole_cell(std::string_view cell) {
  if (cell.starts_with('+') && !cell.starts_with("+-")) cell.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::string in_lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), lower);
  return result;
}

struct Unit {
  std::string_view name;
  double factor;
};
// "\u00b5" and "\u03bc" are the two signs for micro.
constexpr Unit lengths[] = {{"m", 1.0},     {"km", 1e3},       {"dm", 1e-1},      {"cm", 1e-2},    {"mm", 1e-3},
                            {"um", 1e-6},   {"\u00b5m", 1e-6}, {"\u03bcm", 1e-6}, {"nm", 1e-9},    {"micron", 1e-6},
                            {"metre", 1.0}, {"meter", 1.0},    {"in", 0.0254},    {"inch", 0.0254}};
constexpr Unit masses[] = {{"kg", 1.0}, {"g", 1e-3}, {"mg", 1e-6}, {"ug", 1e-9}, {"\u00b5g", 1e-9}, {"t", 1e3}};
constexpr Unit times[] = {{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"\u00b5s", 1e-6}, {"min", 60.0}};
constexpr std::string_view rates[] = {"1/s", "rad/s", "s^-1", "s-1", "rads-1"};

template <std::size_t Count>
std::optional<double> factor_in(const Unit (&units)[Count], std::string_view name) {
  const auto* found = std::find_if(std::begin(units), std::end(units), [&](const auto& u) { return u.name == name; });
  return found == std::end(units) ? std::nullopt : std::optional<double>(found->factor);
}

bool without_unit(std::string_view unit) { return unit == "-" || unit == "1" || unit == "d" || unit == "none"; }

/// Cuts the unit in brackets off the end of a name.
ColumnName with_unit(std::string_view text) {
  text = trimmed(text);
  for (const auto& [open, close] : {std::pair('(', ')'), std::pair('[', ']')}) {
    const auto begin = text.rfind(open);
    if (begin == std::string_view::npos || !text.ends_with(close)) continue;
    const auto inner = trimmed(text.substr(begin + 1, text.size() - begin - 2));
    const auto name = trimmed(text.substr(0, begin));
    if (!name.empty()) return {std::string(name), std::string(inner)};
  }
  const auto slash = text.find('/');
  if (slash != std::string_view::npos && slash > 0) {
    const auto unit = trimmed(text.substr(slash + 1));
    if (!unit.empty() && is_unit(unit)) return {std::string(trimmed(text.substr(0, slash))), std::string(unit)};
  }
  return {std::string(text), ""};
}

}  // namespace

std::optional<double> number_of(std::string_view cell) {
  auto value = whole_cell<double>(cell);
  constexpr std::size_t longest = 64;
  if (!value && cell.size() <= longest && cell.find_first_of(",dD") != std::string_view::npos) {
    char copy[longest];
    bool digit = false;  // before the exponent
    bool comma = false;
    for (std::size_t k = 0; k < cell.size(); ++k) {
      char c = cell[k];
      digit |= std::isdigit(static_cast<unsigned char>(c)) != 0;
      if (digit && (c == 'd' || c == 'D')) c = 'e';
      if (c == ',' && !comma) {
        c = '.';
        comma = true;
      }
      copy[k] = c;
    }
    value = whole_cell<double>({copy, cell.size()});
  }
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> integer_of(std::string_view cell) {
  if (const auto whole = whole_cell<std::int64_t>(cell)) return whole;
  constexpr double largest = 9007199254740992.0;  // 2^53: beyond it a double is not exact
  const auto number = number_of(cell);
  if (!number || std::fabs(*number) > largest || *number != std::floor(*number)) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

std::optional<bool> truth_of(std::string_view cell) {
  const auto word = in_lower_case(cell);
  if (word == "true" || word == "yes" || word == "t" || word == "y") return true;
  if (word == "false" || word == "no" || word == "f" || word == "n") return false;
  const auto number = number_of(cell);
  if (!number || (*number != 0.0 && *number != 1.0)) return std::nullopt;
  return *number == 1.0;
}

std::string_view trimmed(std::string_view cell) {
  const auto begin = cell.find_first_not_of(white);
  if (begin == std::string_view::npos) return {};
  cell = cell.substr(begin, cell.find_last_not_of(white) - begin + 1);
  const bool quoted = cell.size() >= 2 && (cell.front() == '"' || cell.front() == '\'') && cell.back() == cell.front();
  return quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

std::string shown(std::string_view cell) {
  constexpr std::size_t longest = 40;
  std::string text(cell.substr(0, longest));
  if (cell.size() > longest) text.append("...");
  return text;
}

void split(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  const bool by_blanks = separator == blanks;
  const auto separates = [&](char c) { return by_blanks ? c == ' ' || c == '\t' || c == '\r' : c == separator; };
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] == '"') quoted = !quoted;
    if (!separates(line[k]) || quoted) continue;
    if (!by_blanks || k > begin) cells.push_back(trimmed(line.substr(begin, k - begin)));
    begin = k + 1;
  }
  if (!by_blanks || line.size() > begin) cells.push_back(trimmed(line.substr(begin)));
}

char separator_of_names(std::string_view line) {
  for (const char separator : {';', '\t', ','}) {
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (c == separator && !quoted) return separator;
    }
  }
  return blanks;
}

std::vector<ColumnName> column_names(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  split(line, separator, cells);
  std::vector<ColumnName> names;
  if (separator != blanks) {
    for (const auto& cell : cells) names.push_back(with_unit(cell));
    return names;
  }
  std::vector<std::string> words;
  bool open = false;  // within the brackets of a unit
  for (const auto& cell : cells) {
    const bool unit = open || (!words.empty() && (cell.starts_with('(') || cell.starts_with('[')));
    if (unit) {
      words.back() += ' ' + std::string(cell);
    } else {
      words.emplace_back(cell);
    }
    const auto& word = words.back();
    open = std::count(word.begin(), word.end(), '(') > std::count(word.begin(), word.end(), ')') ||
           std::count(word.begin(), word.end(), '[') > std::count(word.begin(), word.end(), ']');
  }
  for (const auto& word : words) names.push_back(with_unit(word));
  return names;
}

std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (c != ' ' && c != '_' && c != '-' && c != '.' && c != ':' && c != '"') plain += lower(c);
  }
  return plain;
}

std::optional<double> unit_of_length(std::string_view unit) {
  return without_unit(unit) ? 1.0 : factor_in(lengths, unit);
}

std::optional<double> unit_of_mass(std::string_view unit) { return without_unit(unit) ? 1.0 : factor_in(masses, unit); }

std::optional<double> unit_of_velocity(std::string_view unit) {
  if (without_unit(unit)) return 1.0;
  std::string plain;
  for (const char c : unit) {
    if (c != ' ' && c != '*' && c != '^') plain += c;
  }
  auto slash = plain.find('/');
  std::string time;
  if (slash != std::string::npos) {
    time = plain.substr(slash + 1);
  } else if (plain.ends_with("s-1")) {
    slash = plain.size() - 3;
    time = "s";
  }
  if (slash == std::string::npos) return std::nullopt;
  const auto length = factor_in(lengths, plain.substr(0, slash));
  const auto second = factor_in(times, time);
  return length && second ? std::optional<double>(*length / *second) : std::nullopt;
}

bool is_unit(std::string_view unit) {
  return unit_of_length(unit) || unit_of_mass(unit) || unit_of_velocity(unit) || factor_in(times, unit) ||
         std::find(std::begin(rates), std::end(rates), unit) != std::end(rates);
}

}  // namespace repose
