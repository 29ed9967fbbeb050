// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/statistics.hpp"
#include "repose/record/record.hpp"
#include "repose/results/results.hpp"
#include "repose/results/sphere_results.hpp"

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
template <int D>
struct MeasuredIn {
  const Record<D>& record;
  const Results<D>& results;
};
using Measured = MeasuredIn<2>;

/// What a method must have for a measure to mean anything.
enum class Needs { nothing, forces, solver, collisions, deposition };
bool has(const Scene& scene, Needs needs);

/// An object of summary.json: the measures whose names begin with its own are its keys.
struct Object {};

/// A value of summary.json; std::monostate is null. Numbers that are not finite are null too.
using MeasureValue = std::variant<std::monostate, Object, double, std::int64_t, std::string, std::vector<double>,
                                  std::vector<std::string>, Estimate>;

/// What there is to know of a key of summary.json without a run.
struct KnownMeasure {
  enum class Kind { object, number, estimate, text, list };

  std::string name;  ///< dotted: "core.solid_fraction" is a key of the object "core"
  std::string unit;
  std::string meaning;
  Kind kind = Kind::number;
  Needs needs = Needs::nothing;  ///< null for methods without it
  bool of_grains = true;         ///< false: describes the run or its settings
};

/// A key of summary.json. Numbers of the grains are also columns of sweeps and rows of `measures` in analysis.h5.
template <int D>
struct MeasureIn : KnownMeasure {
  std::function<MeasureValue(const MeasuredIn<D>&)> value;
  std::function<bool(const MeasuredIn<D>&)> exists;  ///< the key is left out where this is false; none: never
};
using Measure = MeasureIn<2>;

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
  static constexpr auto kind = std::is_arithmetic_v<T> ? KnownMeasure::Kind::number : KnownMeasure::Kind::list;
};
template <>
struct MeasureKind<Object> {
  static constexpr auto kind = KnownMeasure::Kind::object;
};
template <>
struct MeasureKind<Estimate> {
  static constexpr auto kind = KnownMeasure::Kind::estimate;
};
template <>
struct MeasureKind<std::string> {
  static constexpr auto kind = KnownMeasure::Kind::text;
};
template <class T>
struct MeasureKind<std::optional<T>> : MeasureKind<T> {};

/// `entry` gives a number, an Estimate, a text, a list of numbers or texts, or an Object from Measured, or a
/// std::optional of one.
template <int D = 2, class Entry>
MeasureIn<D> measure(std::string name, std::string unit, std::string meaning, Entry entry,
                     Needs needs = Needs::nothing) {
  using Value = std::remove_cvref_t<std::invoke_result_t<const Entry&, const MeasuredIn<D>&>>;
  MeasureIn<D> made;
  made.name = std::move(name);
  made.unit = std::move(unit);
  made.meaning = std::move(meaning);
  made.kind = MeasureKind<Value>::kind;
  made.needs = needs;
  made.value = [entry](const MeasuredIn<D>& run) { return measure_value(std::invoke(entry, run)); };
  return made;
}

/// The measure describes the run or its settings, not the grains.
template <int D>
MeasureIn<D> of_run(MeasureIn<D> measure) {
  measure.of_grains = false;
  return measure;
}

/// The key is left out where `exists` is false.
template <int D>
MeasureIn<D> only_where(std::type_identity_t<std::function<bool(const MeasuredIn<D>&)>> exists, MeasureIn<D> measure) {
  measure.exists = std::move(exists);
  return measure;
}

/// A measure with its value in one run.
struct MeasuredValue {
  const KnownMeasure& measure;
  MeasureValue value;
};

/// All measures of a run, in the order of summary.json; those of an object that is null are left out.
template <int D>
std::vector<MeasuredValue> measured_values(const MeasuredIn<D>& run);

}  // namespace repose
