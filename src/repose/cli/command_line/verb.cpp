// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/command_line/verb.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>

namespace repose {

namespace {

template <class Number>
std::string wanted_number(const Bound& bound) {
  const std::string kind = std::is_integral_v<Number> ? "a whole number" : "a number";
  const bool from = std::isfinite(bound.least);
  const bool to = std::isfinite(bound.most);
  if (from && to) return fmt::format("must be {} from {:g} to {:g}", kind, bound.least, bound.most);
  if (from) return fmt::format("must be {} >= {:g}", kind, bound.least);
  if (to) return fmt::format("must be {} <= {:g}", kind, bound.most);
  return "must be " + kind;
}

template <class Number>
std::string store_number(const Argument& argument, const std::string& text, Number& target) {
  Number value{};
  const auto* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const auto as_double = static_cast<double>(value);
  const bool inside = std::isfinite(as_double) && as_double >= argument.bound.least && as_double <= argument.bound.most;
  if (error != std::errc{} || stop != end || !inside) return wanted_number<Number>(argument.bound);
  target = value;
  return "";
}

struct Store {
  const Argument& argument;
  const std::string& text;

  std::string operator()(bool* target) const {
    *target = true;
    return "";
  }
  std::string operator()(std::string* target) const {
    *target = text;
    return "";
  }
  std::string operator()(std::optional<std::string>* target) const {
    *target = text;
    return "";
  }
  std::string operator()(std::vector<std::string>* target) const {
    target->push_back(text);
    return "";
  }
  std::string operator()(std::optional<std::int64_t>* target) const {
    return store_number(argument, text, target->emplace());
  }
  template <class Number>
  std::string operator()(Number* target) const {
    return store_number(argument, text, *target);
  }
};

}  // namespace

std::string store(const Argument& argument, const std::string& text) {
  if (!argument.choices.empty() && std::ranges::find(argument.choices, text) == argument.choices.end()) {
    return fmt::format("must be one of {}", fmt::join(argument.choices, ", "));
  }
  return std::visit(Store{argument, text}, argument.target);
}

std::string held_value(const Argument& argument) {
  return std::visit(
      [](const auto* target) -> std::string {
        using Type = std::remove_cvref_t<decltype(*target)>;
        if constexpr (std::is_arithmetic_v<Type> || std::is_same_v<Type, std::string>) {
          return fmt::format("{}", *target);
        } else {
          return "";
        }
      },
      argument.target);
}

}  // namespace repose
