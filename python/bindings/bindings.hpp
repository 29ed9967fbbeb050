// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace py = pybind11;

// What each file adds to the module repose_compiled. The Python package gives it its public form.
void bind_theory(py::module_& module);
void bind_scene(py::module_& module);
void bind_simulation(py::module_& module);
void bind_view(py::module_& module);
