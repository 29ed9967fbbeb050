// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstddef>
#include <span>

namespace repose {

namespace {

template <class... Functions>
struct Cases : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Cases(Functions...) -> Cases<Functions...>;

std::string number_text(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string vector_text(std::span<const double> value) { return fmt::format("[{}]", fmt::join(value, ", ")); }

}  // namespace

std::string coordinates_text(const Coordinates& numbers, std::int64_t dimension) {
  return vector_text(std::span(numbers).first(static_cast<std::size_t>(dimension)));
}

bool Bounds::hold(double x) const {
  const bool within = (low_allowed ? x >= low : x > low) && (high_allowed ? x <= high : x < high);
  return within && (std::isfinite(x) || infinite_allowed);
}

std::string Bounds::range() const {
  const bool low_given = std::isfinite(low);
  const bool high_given = std::isfinite(high);
  const auto* also = infinite_allowed ? ", or inf" : "";
  if (low_given && high_given) {
    return fmt::format("{} {} and {} {}", low_allowed ? ">=" : ">", low, high_allowed ? "<=" : "<", high);
  }
  if (low_given) return fmt::format("{} {}{}", low_allowed ? ">=" : ">", low, also);
  if (high_given) return fmt::format("{} {}", high_allowed ? "<=" : "<", high);
  return "a finite number";
}

std::string Bounds::text() const { return "must be " + range(); }

std::string WholeBounds::range() const {
  if (high == std::numeric_limits<std::int64_t>::max()) return fmt::format(">= {}", low);
  return fmt::format("from {} to {}", low, high);
}

std::string WholeBounds::text() const { return "must be " + range(); }

void Parameters::one_of(const std::vector<Alternative>& alternatives, std::size_t& chosen, double& value,
                        double fallback) {
  const auto& one = alternatives[chosen];
  number(one.name, value, chosen == 0 ? fallback : required, one.bounds, one.unit, one.about);
}

void Parameters::tables(std::string_view name, const std::function<std::size_t(std::size_t)>& resize,
                        const std::function<void(Parameters& entry, std::size_t index)>& each) {
  const auto count = resize(0);
  for (std::size_t k = 0; k < count; ++k) {
    Prefixed entry(fmt::format("{}[{}].", name, k), *this);
    each(entry, k);
  }
}

void Prefixed::one_of(const std::vector<Alternative>& alternatives, std::size_t& chosen, double& value,
                      double fallback) {
  std::vector<std::string> names;
  for (const auto& one : alternatives) names.push_back(named(one.name));
  auto all = alternatives;
  for (std::size_t k = 0; k < all.size(); ++k) all[k].name = names[k];
  to_.one_of(all, chosen, value, fallback);
}

void Prefixed::tables(std::string_view name, const std::function<std::size_t(std::size_t)>& resize,
                      const std::function<void(Parameters& entry, std::size_t index)>& each) {
  to_.tables(named(name), resize, each);
}

void Prefixed::show(const Item& item) {
  const auto name = named(item.name);
  to_.show({name, item.unit, item.about, item.value});
}

bool take_default(const Parameters::Item& item) {
  return std::visit(Cases{[](const Parameters::Number& it) {
                            const bool has = !std::isnan(it.fallback.value);
                            it.value = has ? it.fallback.value : 1.0;
                            return has;
                          },
                          [](const Parameters::OptionalNumber& it) {
                            it.value.reset();
                            return true;
                          },
                          [](const Parameters::Whole& it) {
                            it.value = it.fallback.value_or(it.bounds.low);
                            return it.fallback.has_value();
                          },
                          [](const Parameters::Flag& it) {
                            it.value = it.fallback.value;
                            return true;
                          },
                          [](const Parameters::Text& it) {
                            it.value = it.fallback ? it.fallback->value : "";
                            return it.fallback.has_value();
                          },
                          [](const Parameters::Choice& it) {
                            const bool has = !it.fallback.value.empty();
                            it.value = has ? it.fallback.value : it.words.front().name;
                            return has;
                          },
                          [](const Parameters::Vector& it) {
                            for (std::size_t k = 0; k < it.value.size(); ++k) {
                              it.value[k] = it.fallback ? (*it.fallback)[k] : 0.0;
                            }
                            return it.fallback.has_value();
                          },
                          [](const Parameters::List& it) {
                            it.values.clear();
                            return it.may_be_empty;
                          }},
                    item.value);
}

bool is_unset(const Parameters::Item& item) {
  return std::visit(
      Cases{[](const Parameters::Number& it) { return std::isnan(it.value); },
            [](const Parameters::OptionalNumber& it) { return !it.value; },
            [](const Parameters::Whole&) { return false; }, [](const Parameters::Flag& it) { return !it.value; },
            [](const Parameters::Text& it) { return it.value.empty(); },
            [](const Parameters::Choice& it) { return it.value.empty(); },
            [](const Parameters::Vector& it) { return std::isnan(it.value[0]); },
            [](const Parameters::List& it) { return it.values.empty(); }},
      item.value);
}

std::string value_text(const Parameters::Item& item) {
  return std::visit(
      Cases{[](const Parameters::Number& it) { return number_text(it.value); },
            [](const Parameters::OptionalNumber& it) { return it.value ? number_text(*it.value) : std::string(); },
            [](const Parameters::Whole& it) { return fmt::format("{}", it.value); },
            [](const Parameters::Flag& it) { return fmt::format("{}", it.value.value_or(it.fallback.value)); },
            [](const Parameters::Text& it) { return it.value; }, [](const Parameters::Choice& it) { return it.value; },
            [](const Parameters::Vector& it) { return vector_text(it.value); },
            [](const Parameters::List& it) { return fmt::format("[{}]", fmt::join(it.values, ", ")); }},
      item.value);
}

std::string allowed_text(const Parameters::Item& item) {
  return std::visit(Cases{[](const Parameters::Number& it) { return it.bounds.range(); },
                          [](const Parameters::OptionalNumber& it) { return it.bounds.range(); },
                          [](const Parameters::Whole& it) { return it.bounds.range(); },
                          [](const Parameters::Flag&) { return std::string("true | false"); },
                          [](const Parameters::Choice& it) {
                            std::vector<std::string_view> names;
                            for (const auto& word : it.words) names.push_back(word.name);
                            return fmt::format("{}", fmt::join(names, " | "));
                          },
                          [](const auto&) { return std::string(); }},
                    item.value);
}

std::string default_text(const Parameters::Item& item) {
  return std::visit(
      Cases{[](const Parameters::Number& it) {
              return it.fallback.rule.empty() ? number_text(it.fallback.value) : std::string(it.fallback.rule);
            },
            [](const Parameters::OptionalNumber& it) {
              return std::string(it.without.word.empty() ? it.without.meaning : it.without.word);
            },
            [](const Parameters::Whole& it) { return it.fallback ? fmt::format("{}", *it.fallback) : std::string(); },
            [](const Parameters::Flag& it) {
              return it.fallback.rule.empty() ? fmt::format("{}", it.fallback.value) : std::string(it.fallback.rule);
            },
            [](const Parameters::Text& it) {
              if (!it.fallback) return std::string();
              return std::string(it.fallback->rule.empty() ? it.fallback->value : it.fallback->rule);
            },
            [](const Parameters::Choice& it) {
              return std::string(it.fallback.rule.empty() ? it.fallback.value : it.fallback.rule);
            },
            [](const Parameters::Vector& it) { return it.fallback ? vector_text(*it.fallback) : std::string(); },
            [](const Parameters::List& it) { return std::string(it.may_be_empty ? "[]" : ""); }},
      item.value);
}

}  // namespace repose
