// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/species.hpp"

#include "repose/scene/keys.hpp"
#include "repose/scene/scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>

namespace repose {

void grain_keys(Scene& scene, Parameters& keys) {
  auto& grains = scene.grains;
  const bool si = scene.units == "SI";
  keys.number("grains.diameter", grains.diameter, {si ? required : 1.0, "1; must be given in SI"}, positive, "L",
              "d: of the largest grains and of base grains");
  if (si) {
    auto mass = std::isnan(grains.mass) ? std::optional<double>() : grains.mass;
    keys.optional_number("grains.mass", mass, {"", "by the density of the first material"}, positive, "M",
                         "m: of a grain of that diameter, where materials have no density");
    grains.mass = mass.value_or(unset);
  } else {
    keys.number("grains.mass", grains.mass, 1.0, positive, "M", "m: of a grain of that diameter");
  }
  keys.number("grains.polydispersity", grains.polydispersity, fraction, "", "p: diameters uniform in [(1 - p) d, d]");
  keys.choice("grains.shares", grains.fractions_by, {"number", "mass"},
              "whether species.share is a fraction of the number or of the mass of the grains");
}

void species_keys(Scene& scene, Parameters& keys) {
  table_keys(keys, "species", scene.species, [&](Parameters& entry, Species& species, std::size_t k) {
    entry.text("name", species.name, {fmt::format("species {}", k), "\"species k\""}, "name of the species");
    entry.number("share", species.fraction, positive, "", "fraction of the grains, over the sum of all shares");
    material_key("material", species.material, scene, entry);
    kind_key("sizes.kind", species.sizes, sizes_kinds(), any_kind, "fixed", "distribution of the diameters", entry);
    Prefixed below("sizes.", entry);
    species.sizes->keys(scene.grains.diameter, below);
  });
}

void check_species(const Scene& scene, Problems& problems) {
  constexpr std::size_t most = 64;
  const auto& grains = scene.grains;
  if (scene.species.size() > most) problems.problem("species", fmt::format(": at most {} species", most));
  if (!scene.species.empty() && grains.polydispersity > 0.0 && problems.sound("grains.polydispersity")) {
    problems.problem(
        "grains.polydispersity",
        fmt::format(" = {}: must be 0 with [[species]], which have sizes of their own", grains.polydispersity));
  }
  check_masses(scene, problems);
  std::set<std::string> names;
  for (std::size_t k = 0; k < scene.species.size(); ++k) {
    const auto& species = scene.species[k];
    const auto key = fmt::format("species[{}].name", k);
    if (!names.insert(species.name).second && problems.sound(key)) {
      problems.problem(key, fmt::format(" = \"{}\": is used twice", species.name));
    }
    species.sizes->check(fmt::format("species[{}].sizes.", k), problems);
  }
}

std::string describe_species(const Species& species, const Scene& scene) {
  const auto& sizes = *species.sizes;
  return fmt::format("species          {}: share {:g} by {}, {}, diameters {:g} to {:g}\n", species.name,
                     species.fraction, scene.grains.fractions_by, sizes.describe(), sizes.smallest(), sizes.largest());
}

}  // namespace repose
