// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace repose {

/// An attribute of a group, made from a `From`; see Column.
template <class From>
struct Attribute {
  std::string name;
  std::string unit;
  std::string meaning;
  std::function<void(Hdf5File&, const std::string& object, const From&)> write;
  std::function<void(const Hdf5Reader&, const std::string& object, From&)> read = {};  ///< empty: follows from others
};

template <class From>
using Attributes = std::vector<Attribute<From>>;

/// `entry` is a member of From or a function of it that gives a text, a number or a std::vector of numbers. The
/// attribute is read back where that refers to a text or number of From itself.
template <class From, class Entry>
Attribute<From> attribute(const std::string& name, Entry entry, const std::string& unit, const std::string& meaning) {
  using Result = std::invoke_result_t<const Entry&, From&>;
  using Value = std::remove_cvref_t<Result>;
  Attribute<From> made{name, unit, meaning, {}};
  made.write = [=](Hdf5File& file, const std::string& object, const From& from) {
    if constexpr (std::is_integral_v<Value>) {
      file.attribute(object, name, static_cast<std::int64_t>(std::invoke(entry, from)));
    } else {
      file.attribute(object, name, std::invoke(entry, from));
    }
  };
  if constexpr (std::is_lvalue_reference_v<Result> && !std::is_const_v<std::remove_reference_t<Result>>) {
    made.read = [=](const Hdf5Reader& file, const std::string& object, From& from) {
      auto& value = std::invoke(entry, from);
      if constexpr (std::is_integral_v<Value>) {
        value = static_cast<Value>(file.integer(object, name));
      } else if constexpr (std::is_floating_point_v<Value>) {
        value = file.number(object, name);
      } else {
        value = file.text(object, name);
      }
    };
  }
  return made;
}

template <class From, class Value>
Attribute<From> attribute(const std::string& name, Value From::*member, const std::string& unit,
                          const std::string& meaning) {
  return attribute<From, Value From::*>(name, member, unit, meaning);
}

template <class From, class Part, class Get>
Attributes<From> attributes_of(const Attributes<Part>& attributes, Get part) {
  Attributes<From> made;
  for (const auto& one : attributes) {
    Attribute<From> whole{one.name, one.unit, one.meaning, {}};
    whole.write = [=](Hdf5File& file, const std::string& object, const From& from) {
      one.write(file, object, std::invoke(part, from));
    };
    made.push_back(std::move(whole));
  }
  return made;
}

template <class From>
void write_attributes(Hdf5File& file, const std::string& object, const Attributes<From>& attributes, const From& from) {
  for (const auto& attribute : attributes) attribute.write(file, object, from);
}

/// Throws InputError where one is missing.
template <class From>
void read_attributes(const Hdf5Reader& file, const std::string& object, const Attributes<From>& attributes,
                     From& from) {
  for (const auto& attribute : attributes) {
    if (attribute.read) attribute.read(file, object, from);
  }
}

}  // namespace repose
