// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace repose {

/// A surface of triangles, each by the numbers of its vertices, counter-clockwise about its normal.
struct Surface {
  std::vector<Vec<3>> vertices;  ///< [L]
  std::vector<std::array<std::uint32_t, 3>> facets;
};

/// A vertex of the file at p is taken to lie at scale p + shift.
struct StlOptions {
  double scale = 1.0;
  Vec<3> shift{};  ///< [L]
};

inline constexpr std::size_t most_stl_facets = 100000;

/// Reads an STL file, binary or text. Vertices within 1e-9 of the size of the surface are one; the normals of the file
/// do not count. Facets keep their order. Throws InputError, one line per problem, if the file cannot be read or is no
/// STL file, has no facet or more than 100 000, or has a facet without an area: one whose height is below 1e-9 of the
/// size. Facets are counted from 1. Validated by tests/unit/stl_file_test.cpp.
Surface read_stl(const std::string& path, const StlOptions& options = {});

}  // namespace repose
