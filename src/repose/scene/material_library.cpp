// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/material_library.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace repose {

namespace {

constexpr std::string_view callister =
    "Callister, Materials Science and Engineering, 7th ed. (2007), appendix B; the error is half the range there, or "
    "that between it and bearing steel (7810 kg/m^3, 203 GPa)";
constexpr std::string_view callister_glass =
    "Callister (2007), appendix B; beads of Foerster et al., Phys. Fluids 6 (1994) 1108: 2530 kg/m^3, 71 GPa, 0.22";
constexpr std::string_view quartz =
    "quartz: bulk modulus 37 GPa, shear modulus 44 GPa, Mavko, Mukerji and Dvorkin, The Rock Physics Handbook, "
    "2nd ed. (2009); the error covers the other values there";

std::vector<std::string> row_of(const LibraryMaterial& material, std::string_view key, const MeasuredNumber& number,
                                std::string_view unit) {
  return {fmt::format("`{}`", material.name), fmt::format("`{}`", key), fmt::format("{:g}", number.value),
          fmt::format("{:g}", number.error),  std::string(unit),        std::string(number.source)};
}

}  // namespace

const std::vector<LibraryMaterial>& material_library() {
  static const std::vector<LibraryMaterial> library = {
      {"steel",
       "plain and low-alloy steel, as of bearing balls",
       {7850.0, 40.0, callister},
       {207e9, 4e9, callister},
       {0.30, 0.01, callister}},
      {"glass",
       "soda-lime glass",
       {2500.0, 30.0, callister_glass},
       {69e9, 2e9, callister_glass},
       {0.23, 0.01, callister_glass}},
      {"acrylic",
       "PMMA, cast or moulded",
       {1190.0, 10.0, "Callister (2007), appendix B; the error covers data sheets, 1180 to 1200"},
       {2.74e9, 0.5e9, "Callister (2007), appendix B: 2.24 to 3.24 GPa"},
       {0.37, 0.03, "data sheets of manufacturers: 0.34 to 0.40"}},
      {"sand",
       "grains of quartz, each a solid crystal; cracks and rough surfaces make real grains softer",
       {2650.0, 10.0, quartz},
       {94.5e9, 2e9, quartz},
       {0.074, 0.01, quartz}},
      {"sugar",
       "crystals of sucrose",
       {1588.0, 8.0, "CRC Handbook of Chemistry and Physics; the error covers other editions, 1580 to 1590"},
       {35.5e9, 2.5e9,
        "nanoindentation, 38 GPa on (100) and 33 GPa on (001): Ramos and Bahr, J. Mater. Res. 22 (2007) 2037"},
       {0.25, 0.1, "a guess: no measurement is known to us"}}};
  return library;
}

const LibraryMaterial* library_material(std::string_view name) {
  const auto& library = material_library();
  const auto found = std::find_if(library.begin(), library.end(), [&](const auto& one) { return one.name == name; });
  return found == library.end() ? nullptr : &*found;
}

std::vector<Word> library_words() {
  std::vector<Word> words{{"none", "no numbers from the library"}};
  for (const auto& material : material_library()) words.emplace_back(material.name, material.about);
  return words;
}

ReferenceTable material_library_reference() {
  ReferenceTable table{"materials", {"material", "key", "value", "error", "unit", "source"}, {}};
  for (const auto& material : material_library()) {
    table.rows.push_back(row_of(material, "density", material.density, "kg/m^3"));
    table.rows.push_back(row_of(material, "young_modulus", material.young_modulus, "Pa"));
    table.rows.push_back(row_of(material, "poisson_ratio", material.poisson_ratio, ""));
  }
  return table;
}

}  // namespace repose
