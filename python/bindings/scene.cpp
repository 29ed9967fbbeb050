// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/api/scene.hpp"

#include "bindings.hpp"

#include "repose/scene/reference.hpp"
#include "repose/scene/starting_scene.hpp"

#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

namespace {

using repose::api::Scene;
using repose::api::Settings;
using repose::api::Toml;

/// Keys with their values as in a scene file.
using Texts = std::vector<std::pair<std::string, std::string>>;

Settings settings_of(const Texts& texts) {
  Settings settings;
  for (const auto& [key, text] : texts) settings.emplace_back(key, Toml{text});
  return settings;
}

/// The keys of scenes as tuples: key, kind of its value, unit, what is allowed, default, meaning.
py::list scene_keys() {
  py::list all;
  for (const auto& key : repose::all_keys()) {
    all.append(py::make_tuple(key.key, key.kind, key.unit, key.allowed, key.fallback, key.about));
  }
  return all;
}

/// Name and title of the scenes that the program carries along.
py::list example_names() {
  py::list all;
  for (const auto& kind : repose::starting_kinds()) all.append(py::make_tuple(kind.name, kind.title));
  return all;
}

}  // namespace

void bind_scene(py::module_& module) {
  py::class_<Scene>(module, "Scene")
      .def(py::init([](const std::string& text, const Texts& settings) {
             return Scene::from_text(text, settings_of(settings));
           }),
           py::arg("text"), py::arg("settings"))
      .def_static(
          "from_file",
          [](const std::string& path, const Texts& settings) { return Scene::from_file(path, settings_of(settings)); },
          py::arg("path"), py::arg("settings"))
      .def("text", &Scene::text);
  module.def("scene_keys", &scene_keys);
  module.def("example_names", &example_names);
  module.def("example_text", &repose::starting_scene, py::arg("name"));
}
