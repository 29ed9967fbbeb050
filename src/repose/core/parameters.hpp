// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/coordinates.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace repose {

/// What a number may be.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_allowed = true;
  bool high_allowed = true;
  bool infinite_allowed = false;

  /// Whether a number lies within, and is finite unless infinity is allowed.
  bool hold(double x) const;
  std::string range() const;  ///< ">= 0 and < 1"; "a finite number" without any bound
  std::string text() const;   ///< "must be >= 0 and < 1"
};
inline constexpr Bounds any{};
inline constexpr Bounds positive{.low = 0.0, .low_allowed = false};
inline constexpr Bounds not_negative{.low = 0.0};
inline constexpr Bounds not_negative_or_infinite{.low = 0.0, .infinite_allowed = true};
inline constexpr Bounds at_least_one{.low = 1.0};
inline constexpr Bounds zero_to_one{.low = 0.0, .high = 1.0};
inline constexpr Bounds fraction{.low = 0.0, .high = 1.0, .high_allowed = false};

/// What a whole number may be.
struct WholeBounds {
  std::int64_t low = 0;
  std::int64_t high = std::numeric_limits<std::int64_t>::max();

  bool hold(std::int64_t n) const { return n >= low && n <= high; }
  std::string range() const;  ///< ">= 2", or "from 2 to 100"
  std::string text() const;   ///< "must be >= 2"
};

/// A number that has no value yet. As a default: the parameter must be given.
inline constexpr double unset = std::numeric_limits<double>::quiet_NaN();
inline constexpr double required = unset;

/// A default, and for the reference the rule by which it follows from other parameters, as in "0.3 d".
template <class T>
struct DefaultOf {
  T value;
  std::string_view rule;

  template <std::convertible_to<T> U>
  DefaultOf(const U& only) : value(only) {}  // NOLINT(google-explicit-constructor)
  DefaultOf(T by_rule, std::string_view said) : value(by_rule), rule(said) {}
};
using Default = DefaultOf<double>;

/// One of the words that a parameter may be, perhaps with its meaning.
struct Word {
  std::string_view name;
  std::string_view about;

  Word(const char* only) : name(only) {}         // NOLINT(google-explicit-constructor)
  Word(std::string_view only) : name(only) {}    // NOLINT(google-explicit-constructor)
  Word(const std::string& only) : name(only) {}  // NOLINT(google-explicit-constructor)
  Word(std::string_view known, std::string_view meaning) : name(known), about(meaning) {}
};

/// What holds where a number is not given.
struct Without {
  std::string_view word;     ///< stands for it in a file, as "auto"; "": the parameter is left out
  std::string_view meaning;  ///< for the reference
};

/// Visits parameters one by one, in order: of a scene, a force law or a theory model. What reads them fills the values
/// in; what writes, lists or documents them reads the values. So a parameter is described once, where its struct is:
/// name, value, default, bounds, unit in M, L, T, and `about`, one line for the user.
class Parameters {
 public:
  struct Number {
    double& value;
    Default fallback;
    Bounds bounds;
  };
  struct OptionalNumber {
    std::optional<double>& value;
    Without without;
    Bounds bounds;
  };
  struct Whole {
    std::int64_t& value;
    std::optional<std::int64_t> fallback;  ///< none: it must be given
    WholeBounds bounds;
  };
  struct Flag {
    std::optional<bool>& value;
    DefaultOf<bool> fallback;
  };
  struct Text {
    std::string& value;
    std::optional<DefaultOf<std::string_view>> fallback;  ///< none: it must be given
  };
  struct Choice {
    std::string& value;
    DefaultOf<std::string_view> fallback;  ///< "": it must be given
    const std::vector<Word>& words;
  };
  struct Vector {
    std::span<double> value;
    std::optional<std::vector<double>> fallback;  ///< of as many numbers; none: it must be given
  };
  struct List {
    std::vector<double>& values;
    bool may_be_empty = false;  ///< it is then empty without being given
  };

  struct Item {
    std::string_view name;
    std::string_view unit;
    std::string_view about;
    std::variant<Number, OptionalNumber, Whole, Flag, Text, Choice, Vector, List> value;
  };

  virtual ~Parameters() = default;

  // Without a default, that of a parameter is the value that it has before the visit; not a number, or an empty text:
  // it must be given.

  void number(std::string_view name, double& value, const Default& fallback, const Bounds& bounds,
              std::string_view unit, std::string_view about) {
    show({name, unit, about, Number{value, fallback, bounds}});
  }
  void number(std::string_view name, double& value, const Bounds& bounds, std::string_view unit,
              std::string_view about) {
    number(name, value, value, bounds, unit, about);
  }
  void optional_number(std::string_view name, std::optional<double>& value, const Without& without,
                       const Bounds& bounds, std::string_view unit, std::string_view about) {
    show({name, unit, about, OptionalNumber{value, without, bounds}});
  }
  void integer(std::string_view name, std::int64_t& value, std::optional<std::int64_t> fallback,
               const WholeBounds& bounds, std::string_view about) {
    show({name, "", about, Whole{value, fallback, bounds}});
  }
  void integer(std::string_view name, std::int64_t& value, const WholeBounds& bounds, std::string_view about) {
    integer(name, value, value, bounds, about);
  }
  void flag(std::string_view name, bool& value, const DefaultOf<bool>& fallback, std::string_view about) {
    std::optional<bool> shown = value;
    show({name, "", about, Flag{shown, fallback}});
    value = shown.value_or(fallback.value);
  }
  void flag(std::string_view name, bool& value, std::string_view about) { flag(name, value, value, about); }
  void flag(std::string_view name, std::optional<bool>& value, const DefaultOf<bool>& fallback,
            std::string_view about) {
    show({name, "", about, Flag{value, fallback}});
  }
  void text(std::string_view name, std::string& value, const DefaultOf<std::string_view>& fallback,
            std::string_view about) {
    show({name, "", about, Text{value, fallback}});
  }
  void text(std::string_view name, std::string& value, std::string_view about) {
    const std::string before = value;
    if (before.empty()) return show({name, "", about, Text{value, std::nullopt}});
    text(name, value, DefaultOf<std::string_view>(before), about);
  }
  void choice(std::string_view name, std::string& value, const DefaultOf<std::string_view>& fallback,
              const std::vector<Word>& words, std::string_view about) {
    show({name, "", about, Choice{value, fallback, words}});
  }
  void choice(std::string_view name, std::string& value, const std::vector<Word>& words, std::string_view about) {
    const std::string before = value;
    choice(name, value, std::string_view(before), words, about);
  }
  void vector(std::string_view name, std::array<double, 2>& value, std::optional<std::array<double, 2>> fallback,
              std::string_view unit, std::string_view about) {
    show({name, unit, about, Vector{value, numbers_of(fallback, 2)}});
  }
  /// The first `dimension` numbers.
  void vector(std::string_view name, Coordinates& value, std::int64_t dimension, std::optional<Coordinates> fallback,
              std::string_view unit, std::string_view about) {
    const auto count = static_cast<std::size_t>(dimension);
    show({name, unit, about, Vector{std::span(value).first(count), numbers_of(fallback, count)}});
  }
  void numbers(std::string_view name, std::vector<double>& values, std::string_view unit, std::string_view about) {
    show({name, unit, about, List{values}});
  }
  void numbers_if_any(std::string_view name, std::vector<double>& values, std::string_view unit,
                      std::string_view about) {
    show({name, unit, about, List{values, true}});
  }

  /// One number that may be given under one of several names; the first is the default.
  struct Alternative {
    std::string_view name;
    Bounds bounds;
    std::string_view unit;
    std::string_view about;
  };
  virtual void one_of(const std::vector<Alternative>& alternatives, std::size_t& chosen, double& value,
                      double fallback);

  /// A list of tables: `resize` takes how many there are to be, 0 for as many as there are, and returns how many there
  /// are then; `each` visits one of them.
  virtual void tables(std::string_view name, const std::function<std::size_t(std::size_t)>& resize,
                      const std::function<void(Parameters& entry, std::size_t index)>& each);

  /// Whether anything is given under a name. What is not given may then be as elsewhere.
  virtual bool given(std::string_view /*name*/) const { return true; }

 protected:
  virtual void show(const Item& item) = 0;
  friend class Prefixed;

 private:
  template <std::size_t N>
  static std::optional<std::vector<double>> numbers_of(const std::optional<std::array<double, N>>& from,
                                                       std::size_t count) {
    if (!from) return std::nullopt;
    return std::vector<double>(from->begin(), from->begin() + static_cast<std::ptrdiff_t>(count));
  }
};

/// Shows parameters with a prefix before their names: "stiffness" as "contact.normal.stiffness".
class Prefixed final : public Parameters {
 public:
  Prefixed(std::string prefix, Parameters& to) : prefix_(std::move(prefix)), to_(to) {}

  void one_of(const std::vector<Alternative>& alternatives, std::size_t& chosen, double& value,
              double fallback) override;
  void tables(std::string_view name, const std::function<std::size_t(std::size_t)>& resize,
              const std::function<void(Parameters& entry, std::size_t index)>& each) override;
  bool given(std::string_view name) const override { return to_.given(named(name)); }

 private:
  void show(const Item& item) override;
  std::string named(std::string_view name) const { return prefix_ + std::string(name); }

  std::string prefix_;
  Parameters& to_;
};

/// Gives a parameter its default. Without one it gets something within its bounds, and false is returned.
bool take_default(const Parameters::Item& item);

/// Whether a parameter has no value yet: a number that is none, an empty text or list. Whole numbers always have one.
bool is_unset(const Parameters::Item& item);

/// The value of a parameter; "" where it has none.
std::string value_text(const Parameters::Item& item);

/// What a parameter may be: "> 0", "from 1 to 10", "row | plane", "a | list | of words"; "" for any.
std::string allowed_text(const Parameters::Item& item);

/// The default of a parameter by its rule or else as a value; "" where it must be given.
std::string default_text(const Parameters::Item& item);

}  // namespace repose
