// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/io/reference_table.hpp"

#include <string_view>
#include <vector>

namespace repose {

/// A number of a material in SI, as somebody published it.
struct MeasuredNumber {
  double value;
  double error;  ///< half the range that samples or sources cover
  std::string_view source;
};

/// A material whose numbers come with Repose.
struct LibraryMaterial {
  std::string_view name;
  std::string_view about;
  MeasuredNumber density;        ///< [kg/m^3] of the solid, without pores between grains
  MeasuredNumber young_modulus;  ///< [Pa]
  MeasuredNumber poisson_ratio;
};

const std::vector<LibraryMaterial>& material_library();

/// The material of that name; nullptr for "none" and for a name that the library has not.
const LibraryMaterial* library_material(std::string_view name);

/// "none", and the names of the library.
std::vector<Word> library_words();

/// The table of docs/reference/materials.md: every number with its error and source.
ReferenceTable material_library_reference();

}  // namespace repose
