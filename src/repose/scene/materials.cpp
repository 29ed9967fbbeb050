// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/materials.hpp"

#include "repose/scene/keys.hpp"
#include "repose/scene/material_library.hpp"
#include "repose/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace repose {

namespace {

void check_material_names(const std::vector<Material>& materials, Problems& problems) {
  constexpr std::size_t most = 64;
  if (materials.size() > most) problems.problem("material", fmt::format(": at most {} materials", most));
  std::set<std::string> names;
  for (std::size_t k = 0; k < materials.size(); ++k) {
    const auto key = fmt::format("material[{}].name", k);
    const auto& name = materials[k].name;
    const bool known = problems.sound(fmt::format("material[{}].library", k));
    if (name.empty() && known && problems.sound(key)) problems.problem(key, ": missing: a material needs a name");
    if (!name.empty() && !names.insert(name).second)
      problems.problem(key, fmt::format(" = \"{}\": is used twice", name));
  }
}

bool has_density(const Material& material) { return !std::isnan(material.density); }

/// Whether masses follow from the densities of the materials.
bool by_density(const Scene& scene) {
  return scene.units == "SI" && std::isnan(scene.grains.mass) && !scene.materials.empty() &&
         scene.materials.front().density > 0.0;
}

/// A number that the library gives where the scene does not.
void number_of_library(const char* name, std::optional<double>& value, const MeasuredNumber& known,
                       const Bounds& bounds, std::string_view unit, std::string_view about, Parameters& entry) {
  double number = value.value_or(known.value);
  entry.number(name, number, {known.value, "of the library"}, bounds, unit, about);
  value = number;
}

void density_key(Material& material, const LibraryMaterial* known, bool si, Parameters& entry) {
  if (!si) {
    entry.number("density", material.density, 1.0, positive, "",
                 "relative to that of a grain of grains.mass and grains.diameter");
    return;
  }
  constexpr auto about = "instead of grains.mass: a grain of diameter d has the mass of a sphere, density pi d^3/6";
  auto density = has_density(material) ? material.density : std::optional<double>();
  if (known != nullptr) {
    number_of_library("density", density, known->density, positive, "M/L^3", about, entry);
  } else {
    entry.optional_number("density", density, {"", "that of grains.mass"}, positive, "M/L^3", about);
  }
  material.density = density.value_or(unset);
}

void moduli_keys(Material& material, const LibraryMaterial* known, Parameters& entry) {
  constexpr auto about_young = "E: hertz takes its stiffness from it";
  constexpr auto about_poisson = "nu, with young_modulus";
  constexpr Bounds ratios{.low = -1.0, .high = 0.5, .low_allowed = false};
  if (known != nullptr) {
    number_of_library("young_modulus", material.young_modulus, known->young_modulus, positive, "M/(L T^2)", about_young,
                      entry);
    number_of_library("poisson_ratio", material.poisson_ratio, known->poisson_ratio, ratios, "", about_poisson, entry);
    return;
  }
  entry.optional_number("young_modulus", material.young_modulus, {"", "none: by the stiffness of the law"}, positive,
                        "M/(L T^2)", about_young);
  entry.optional_number("poisson_ratio", material.poisson_ratio, {"", "none"}, ratios, "", about_poisson);
}

}  // namespace

void material_keys(Scene& scene, Parameters& keys) {
  const bool si = scene.units == "SI";
  const bool moduli = scene.method->traits().force_laws;
  static const auto library = library_words();
  table_keys(keys, "material", scene.materials, [&](Parameters& entry, Material& material, std::size_t) {
    if (si) {
      entry.choice("library", material.library, "none", library,
                   "takes what is left out below from that material: docs/reference/materials.md");
    }
    const auto* known = si ? library_material(material.library) : nullptr;
    entry.text("name", material.name, {known != nullptr ? known->name : "", "\"\"; that of the library"},
               "name of the material; the first one is the default everywhere");
    density_key(material, known, si, entry);
    if (moduli) moduli_keys(material, known, entry);
  });
}

void check_materials(const Scene& scene, Problems& problems) {
  check_material_names(scene.materials, problems);
  for (std::size_t k = 0; scene.has_moduli() && k < scene.materials.size(); ++k) {
    const auto require = [&](const char* name, const std::optional<double>& value) {
      const auto key = fmt::format("material[{}].{}", k, name);
      if (value || !problems.sound(key)) return;
      problems.problem(key, ": missing: every material has young_modulus and poisson_ratio, or none has");
    };
    require("young_modulus", scene.materials[k].young_modulus);
    require("poisson_ratio", scene.materials[k].poisson_ratio);
  }
}

void check_masses(const Scene& scene, Problems& problems) {
  if (scene.units != "SI" || !problems.sound("grains.mass")) return;
  for (std::size_t k = 0; k < scene.materials.size(); ++k) {
    if (!problems.sound(fmt::format("material[{}].library", k))) return;
  }
  const bool any = std::any_of(scene.materials.begin(), scene.materials.end(), has_density);
  if (!std::isnan(scene.grains.mass)) {
    if (!any) return;
    return problems.problem("grains.mass", fmt::format(" = {}: follows from the density of the materials, which in SI "
                                                       "is in kg/m^3; give one of the two",
                                                       scene.grains.mass));
  }
  if (!any) {
    return problems.problem("grains.mass",
                            ": missing: m: of a grain of that diameter; or the density of every material, in kg/m^3");
  }
  for (std::size_t k = 0; k < scene.materials.size(); ++k) {
    if (has_density(scene.materials[k])) continue;
    problems.problem(fmt::format("material[{}].density", k),
                     ": missing: in SI every material has a density [kg/m^3], or none has");
  }
}

std::string describe_materials(const Scene& scene) {
  const bool si = scene.units == "SI";
  const auto names = scene.material_names();
  std::string text = fmt::format("units            {}\n", si ? "SI: m, kg, s, N, Pa" : "reduced: d, m and g are 1");
  for (std::size_t k = 0; k < names.size(); ++k) {
    const double mass = scene.mass_of(scene.grains.diameter, names[k]);
    text += fmt::format("grain            {}diameter {:g}{}, mass {:.4g}{}, weight {:.4g}{}",
                        scene.materials.empty() ? "" : names[k] + ": ", scene.grains.diameter, si ? " m" : "", mass,
                        si ? " kg" : "", mass * scene.gravity, si ? " N" : "");
    if (scene.has_moduli()) {
      const auto elastic = scene.elasticity(k);
      text += fmt::format(", Young's modulus {:g}{}, Poisson's ratio {:g}", elastic.young_modulus, si ? " Pa" : "",
                          elastic.poisson_ratio);
    }
    text += "\n";
  }
  return text;
}

bool Scene::has_moduli() const {
  return std::any_of(materials.begin(), materials.end(),
                     [](const Material& one) { return one.young_modulus || one.poisson_ratio; });
}

Elasticity Scene::elasticity(std::size_t material) const {
  Elasticity found;
  if (material >= materials.size()) return found;
  const auto& one = materials[material];
  if (one.young_modulus && *one.young_modulus > 0.0 && std::isfinite(*one.young_modulus)) {
    found.young_modulus = *one.young_modulus;
  }
  if (one.poisson_ratio && *one.poisson_ratio > -1.0 && *one.poisson_ratio <= 0.5) {
    found.poisson_ratio = *one.poisson_ratio;
  }
  return found;
}

double Scene::nominal_mass() const {
  if (!std::isnan(grains.mass)) return grains.mass;
  if (!by_density(*this)) return 1.0;
  const double d = grains.diameter;
  return materials.front().density * (std::numbers::pi / 6.0) * (d * d * d);
}

double Scene::mass_of(double diameter, const std::string& material) const {
  double density = materials.empty() ? 1.0 : materials[material_number(material)].density;
  if (by_density(*this)) density /= materials.front().density;
  if (std::isnan(density)) density = 1.0;
  const double size = diameter / grains.diameter;
  const double discs = size * size;
  return density * nominal_mass() * (dimension == 3 ? discs * size : discs);
}

}  // namespace repose
