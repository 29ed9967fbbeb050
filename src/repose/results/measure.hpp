// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/statistics.hpp"
#include "repose/record/record.hpp"
#include "repose/results/results.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace repose {

/// What measures are computed from: a run, and what the analysis found in it.
struct Measured {
  const Record& record;
  const Results& results;
};

/// What a method must have for a measure to mean anything.
enum class Needs { nothing, forces, solver, collisions, deposition };
bool has(const Scene& scene, Needs needs);

/// An object of summary.json: the measures whose names begin with its own are its keys.
struct Object {};

/// A value of summary.json; std::monostate is null. Numbers that are not finite are null too.
using MeasureValue = std::variant<std::monostate, Object, double, std::int64_t, std::string, std::vector<double>,
                                  std::vector<std::string>, Estimate>;

/// A key of summary.json. Numbers of the grains are also columns of sweeps and rows of `measures` in analysis.h5.
struct Measure {
  enum class Kind { object, number, estimate, text, list };

  std::string name;  ///< dotted: "core.solid_fraction" is a key of the object "core"
  std::string unit;
  std::string meaning;
  Kind kind = Kind::number;
  std::function<MeasureValue(const Measured&)> value;
  Needs needs = Needs::nothing;                      ///< null for methods without it
  std::function<bool(const Measured&)> exists = {};  ///< the key is left out where this is false
  bool of_grains = true;                             ///< false: describes the run or its settings
};

MeasureValue measure_value(Object);
MeasureValue measure_value(double value);
MeasureValue measure_value(std::string value);
MeasureValue measure_value(std::vector<double> value);
MeasureValue measure_value(std::vector<std::string> value);
MeasureValue measure_value(const Estimate& value);
template <class T>
requires std::is_integral_v<T> MeasureValue measure_value(T value) { return static_cast<std::int64_t>(value); }
template <std::size_t N>
MeasureValue measure_value(const std::array<double, N>& value) {
  return std::vector<double>(value.begin(), value.end());
}
template <class T>
MeasureValue measure_value(const std::optional<T>& value) {
  return value ? measure_value(*value) : MeasureValue{};
}

template <class T>
struct MeasureKind {
  static constexpr auto kind = std::is_arithmetic_v<T> ? Measure::Kind::number : Measure::Kind::list;
};
template <>
struct MeasureKind<Object> {
  static constexpr auto kind = Measure::Kind::object;
};
template <>
struct MeasureKind<Estimate> {
  static constexpr auto kind = Measure::Kind::estimate;
};
template <>
struct MeasureKind<std::string> {
  static constexpr auto kind = Measure::Kind::text;
};
template <class T>
struct MeasureKind<std::optional<T>> : MeasureKind<T> {};

/// `entry` gives a number, an Estimate, a text, a list of numbers or texts, or an Object from Measured, or a
/// std::optional of one.
template <class Entry>
Measure measure(std::string name, std::string unit, std::string meaning, Entry entry, Needs needs = Needs::nothing) {
  using Value = std::remove_cvref_t<std::invoke_result_t<const Entry&, const Measured&>>;
  return {std::move(name),
          std::move(unit),
          std::move(meaning),
          MeasureKind<Value>::kind,
          [entry](const Measured& run) { return measure_value(std::invoke(entry, run)); },
          needs};
}

/// The measure describes the run or its settings, not the grains.
Measure of_run(Measure measure);

/// The key is left out where `exists` is false.
Measure only_where(std::function<bool(const Measured&)> exists, Measure measure);

/// A measure with its value in one run.
struct MeasuredValue {
  const Measure& measure;
  MeasureValue value;
};

/// All measures of a run, in the order of summary.json; those of an object that is null are left out.
std::vector<MeasuredValue> measured_values(const Measured& run);

}  // namespace repose
