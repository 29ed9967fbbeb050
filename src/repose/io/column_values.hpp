// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

// For io/columns.hpp: how a value of a row becomes numbers of a file, and these the value again.

namespace repose {

/// Numbers that a value is made of.
template <class Value>
inline constexpr std::size_t width_of = 1;
template <int D>
inline constexpr std::size_t width_of<Vec<D>> = D;
template <class T, std::size_t N>
inline constexpr std::size_t width_of<std::array<T, N>> = N;
template <class... T>
inline constexpr std::size_t width_of<std::tuple<T...>> = sizeof...(T);

template <class Value>
struct PartOf {
  using Type = Value;
};
template <int D>
struct PartOf<Vec<D>> {
  using Type = double;
};
template <class T, std::size_t N>
struct PartOf<std::array<T, N>> {
  using Type = T;
};
template <class T, class... Others>
struct PartOf<std::tuple<T, Others...>> {
  using Type = std::remove_cvref_t<T>;
};

/// What files have for a part: bytes for flags, 64 bits for counts.
template <class T>
using KeptPart = std::conditional_t<std::is_same_v<T, bool>, std::uint8_t,
                                    std::conditional_t<std::is_integral_v<T> && (sizeof(T) > 2), std::int64_t, T>>;
template <class Value>
using KeptAs = KeptPart<typename PartOf<Value>::Type>;

template <class Kept>
inline constexpr std::string_view type_name = "";
template <>
inline constexpr std::string_view type_name<float> = "float32";
template <>
inline constexpr std::string_view type_name<std::int64_t> = "int64";
template <>
inline constexpr std::string_view type_name<std::uint16_t> = "uint16";
template <>
inline constexpr std::string_view type_name<std::uint8_t> = "uint8";
template <>
inline constexpr std::string_view type_name<std::string> = "text";

/// Whether an entry gives the row's own value, which can be assigned to.
template <class Result>
inline constexpr bool refers_to_row =
    std::is_lvalue_reference_v<Result> && !std::is_const_v<std::remove_reference_t<Result>>;
template <class... T>
inline constexpr bool refers_to_row<std::tuple<T...>> = (refers_to_row<T> && ...);

template <class Value, class Use>
void for_each_part(Value&& value, const Use& use) {
  using Plain = std::remove_cvref_t<Value>;
  if constexpr (width_of<Plain> == 1) {
    use(value);
  } else if constexpr (requires { value[0]; }) {
    for (std::size_t k = 0; k < width_of<Plain>; ++k) use(value[static_cast<int>(k)]);
  } else {
    std::apply([&](auto&... part) { (use(part), ...); }, value);
  }
}

template <class Kept, class Value>
void append_parts(std::vector<Kept>& values, const Value& value) {
  for_each_part(value, [&](const auto& part) { values.push_back(static_cast<Kept>(part)); });
}

template <class Value, class Kept>
void assign_parts(Value&& value, const Kept* next) {
  for_each_part(value, [&](auto& part) { part = static_cast<std::remove_cvref_t<decltype(part)>>(*next++); });
}

template <class Kept>
void write_values(Hdf5File& file, const std::string& path, const std::vector<Kept>& values, std::size_t width,
                  const std::string& unit, const std::string& meaning) {
  if constexpr (std::is_same_v<Kept, std::string>) {
    file.texts(path, values, meaning);
  } else {
    file.dataset(path, values, width, unit, meaning);
  }
}

template <class Kept>
std::vector<Kept> read_values(const Hdf5Reader& file, const std::string& path, std::size_t width) {
  if constexpr (std::is_same_v<Kept, std::string>) {
    return file.texts(path);
  } else {
    return file.dataset<Kept>(path, width);
  }
}

}  // namespace repose
