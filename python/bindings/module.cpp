// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.hpp"

#include "repose/core/errors.hpp"

PYBIND11_MODULE(repose_compiled, module) {
  module.doc() = "Compiled part of the Python package repose; use repose itself.";
  py::register_exception<repose::InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<repose::RunError>(module, "RunError", PyExc_RuntimeError);
  bind_theory(module);
  bind_scene(module);
  bind_simulation(module);
}
