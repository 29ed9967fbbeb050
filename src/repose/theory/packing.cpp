// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/packing.hpp"

#include <fmt/format.h>

#include <numbers>

namespace repose::theory {

namespace {

using std::numbers::pi;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double isostatic_coordination(int dimension, bool friction) {
  // Each of the z/2 contacts per grain carries 1 force component (d with friction). A grain has d equations of force
  // balance, and with friction also d(d - 1)/2 of torque balance.
  const double forces = friction ? dimension : 1.0;
  const double balances = dimension + (friction ? 0.5 * dimension * (dimension - 1) : 0.0);
  return 2.0 * balances / forces;
}

std::vector<PackingFact> packing_facts() {
  const std::string counted = "number of forces equals number of balances; mean over grains that carry force";
  return {
      {"hexagonal", 2, pi / (2.0 * std::numbers::sqrt3), 0.0, 6.0, "pi/(2 sqrt 3), eq. (8); the densest of discs"},
      {"square", 2, pi / 4.0, 0.0, 4.0, "pi/4"},
      {"random close (steepest descent)", 2, 0.82, 0.005, 4.0,
       "Bratberg 2003 quotes Meakin and Jullien as random close packing; it is deposition onto a disordered base, "
       "where "
       "each disc rolls down until it rests on two"},
      {"random close (pair correlations)", 2, 0.82, 0.02, unknown, "Berryman 1983, Phys. Rev. A 27, 1053"},
      {"maximally random jammed", 2, 0.826, unknown, unknown,
       "Atkinson, Stillinger and Torquato 2014, Proc. Natl. Acad. Sci. USA 111, 18436; with rattlers"},
      {"ballistic deposition", 2, 0.3568, 0.0001, 2.0,
       "Meakin and Jullien, quoted by Bratberg, Radjai and Hansen 2002; the thesis prints 0.3586"},
      {"isostatic without friction", 2, unknown, unknown, isostatic_coordination(2, false), counted},
      {"isostatic with friction", 2, unknown, unknown, isostatic_coordination(2, true), counted},
      {"face-centred cubic", 3, pi / (3.0 * std::numbers::sqrt2), 0.0, 12.0,
       "pi/(3 sqrt 2); the densest of spheres (Hales 2005, Ann. Math. 162, 1065); called body-centred in the thesis"},
      {"hexagonal close", 3, pi / (3.0 * std::numbers::sqrt2), 0.0, 12.0, "pi/(3 sqrt 2); equally dense"},
      {"body-centred cubic", 3, pi * std::numbers::sqrt3 / 8.0, 0.0, 8.0, "pi sqrt 3/8"},
      {"simple cubic", 3, pi / 6.0, 0.0, 6.0, "pi/6"},
      {"tunneled crystal", 3, pi * std::numbers::sqrt2 / 9.0, 0.0, 7.0,
       "pi sqrt 2/9; close packing without a third of its spheres, the least dense strictly jammed packing known "
       "(Torquato and Stillinger 2007, J. Appl. Phys. 102, 093511)"},
      {"random close (as in the thesis)", 3, 0.635, 0.0005, unknown,
       "Scott 1960, Nature 188, 908, quoted by Bratberg 2003; extrapolated to infinite cylinders"},
      {"random close (steel balls)", 3, 0.6366, 0.0005, unknown, "Scott and Kilgour 1969, J. Phys. D 2, 863"},
      {"random close (pair correlations)", 3, 0.64, 0.02, unknown, "Berryman 1983, Phys. Rev. A 27, 1053"},
      {"maximally random jammed", 3, 0.64, unknown, unknown,
       "Torquato, Truskett and Debenedetti 2000, Phys. Rev. Lett. 84, 2064"},
      {"jamming of frictionless spheres", 3, 0.639, 0.001, isostatic_coordination(3, false),
       "O'Hern, Silbert, Liu and Nagel 2003, Phys. Rev. E 68, 011306; limit of zero pressure, contacts without "
       "rattlers"},
      {"random loose (no gravity)", 3, 0.555, 0.005, unknown,
       "Onoda and Liniger 1990, Phys. Rev. Lett. 64, 2727; spheres that sank in liquids of nearly their density"},
      {"random loose (rough spheres)", 3, 0.550, 0.001, unknown,
       "Jerkins et al. 2008, Phys. Rev. Lett. 101, 018301; limit of zero pressure"},
      {"isostatic without friction", 3, unknown, unknown, isostatic_coordination(3, false), counted},
      {"isostatic with friction", 3, unknown, unknown, isostatic_coordination(3, true), counted},
  };
}

void parameters(Packing& packing, Parameters& to) {
  to.choice("dimension", packing.dimension, {"all", "2", "3"}, "discs, spheres, or both");
}

Table evaluate(const Packing& packing) {
  Column names{.name = "name", .unit = "", .about = "kind of packing", .values = {}, .words = {}};
  Column dimensions{.name = "dimension", .unit = "1", .about = "2: discs, 3: spheres", .values = {}, .words = {}};
  Column fractions{
      .name = "solid_fraction", .unit = "1", .about = "area or volume of grains over total", .values = {}, .words = {}};
  Column errors{.name = "error",
                .unit = "1",
                .about = "error of solid_fraction, from the source; 0: exact",
                .values = {},
                .words = {}};
  Column coordinations{.name = "coordination", .unit = "1", .about = "contacts per grain", .values = {}, .words = {}};
  Column sources{.name = "source", .unit = "", .about = "formula or publication", .values = {}, .words = {}};
  for (const auto& fact : packing_facts()) {
    if (packing.dimension != "all" && packing.dimension != fmt::format("{}", fact.dimension)) continue;
    names.words.push_back(fact.name);
    dimensions.values.push_back(fact.dimension);
    fractions.values.push_back(fact.solid_fraction);
    errors.values.push_back(fact.error);
    coordinations.values.push_back(fact.coordination);
    sources.words.push_back(fact.source);
  }
  return {{names, dimensions, fractions, errors, coordinations, sources},
          {{"fabric_trace", 1.0, "1", "trace of the fabric tensor <n n>, (4)"},
           {"anisotropy_bound", 2.0, "1", "largest a = 2 (l1 - l2) in 2D: all contacts in one direction"},
           {"anisotropy_bound_one_harmonic", 1.0, "1",
            "largest A of P = (1 + A cos 2(theta - theta_c))/(2 pi), (3), which equals a: P >= 0"},
           {"single_file_fraction", 2.0 / 3.0, "1", "spheres on top of each other in a tube of their diameter"}}};
}

}  // namespace repose::theory
