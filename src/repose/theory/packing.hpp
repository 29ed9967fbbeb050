// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <limits>
#include <string>
#include <vector>

namespace repose::theory {

/// Known solid fractions and coordination numbers of packings of equal discs and spheres: lattices, random packings,
/// isostatic counts. Source: Bratberg's thesis (2003), sections 2.1 and 2.2, and the sources named in the rows.
/// Validated by tests/theory/packing_test.cpp, which builds the lattices.
struct Packing {
  std::string dimension = "all";  ///< all | 2 | 3

  static constexpr ModelText text{.name = "packing",
                                  .about = "Solid fractions and coordination numbers of packings of equal grains",
                                  .source = "Bratberg 2003 (thesis), sections 2.1-2.2; sources of the rows"};
};

/// One packing; unknown numbers are NaN.
struct PackingFact {
  std::string name;
  int dimension = 0;
  double solid_fraction = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();  ///< error of solid_fraction; 0: exact
  double coordination = std::numeric_limits<double>::quiet_NaN();
  std::string source;
};
std::vector<PackingFact> packing_facts();

/// The number of contacts per grain for which forces and balances are equal in number: 2 d without friction; d + 1 with
/// friction, where each contact has d force components and each grain also balances torques.
double isostatic_coordination(int dimension, bool friction);

void parameters(Packing& packing, Parameters& to);

/// A table with the columns name, dimension, solid_fraction, error, coordination and source.
Table evaluate(const Packing& packing);

}  // namespace repose::theory
