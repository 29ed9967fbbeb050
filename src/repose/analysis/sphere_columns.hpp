// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

namespace repose {

/// An upright column through a sphere of radius 1.
struct SphereColumn {
  double x = 0.0;     ///< of the column from the centre
  double y = 0.0;     ///< likewise
  double half = 0.0;  ///< half its height
};

/// Columns of equal cross-section that fill a sphere, `across` of them along its diameter.
inline std::vector<SphereColumn> columns_of_sphere(int across = 40) {
  std::vector<SphereColumn> columns;
  for (int i = 0; i < across; ++i) {
    for (int j = 0; j < across; ++j) {
      const double x = (2.0 * i + 1.0) / across - 1.0;
      const double y = (2.0 * j + 1.0) / across - 1.0;
      const double rest = 1.0 - x * x - y * y;
      if (rest > 0.0) columns.push_back({x, y, std::sqrt(rest)});
    }
  }
  return columns;
}

}  // namespace repose
