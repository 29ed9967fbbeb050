// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.hpp"
#include "repose/core/errors.hpp"

PYBIND11_MODULE(repose_compiled, module) {
  module.doc() = "Compiled part of the Python package repose; use repose itself.";
  py::register_exception<repose::InputError>(module, "InputError", PyExc_ValueError).doc() =
      "A scene, a setting or a folder is wrong: a ValueError with a line for each problem, in the words of the "
      "program.";
  py::register_exception<repose::RunError>(module, "RunError", PyExc_RuntimeError).doc() =
      "A run cannot continue or cannot be written: a RuntimeError that says why.";
  bind_theory(module);
  bind_scene(module);
  bind_simulation(module);
  bind_view(module);
}
