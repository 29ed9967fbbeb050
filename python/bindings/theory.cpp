// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.hpp"

#include "repose/theory/models.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

namespace {

using namespace repose;

/// A table for Python: (columns, numbers), lists of (name, unit, about, value); the value of a column is an array of
/// numbers or a list of words.
py::tuple as_python(const theory::Table& table) {
  py::list columns;
  for (const auto& column : table.columns) {
    py::object values =
        column.words.empty()
            ? py::object{py::array_t<double>(static_cast<py::ssize_t>(column.values.size()), column.values.data())}
            : py::object{py::cast(column.words)};
    columns.append(py::make_tuple(column.name, column.unit, column.about, values));
  }
  py::list numbers;
  for (const auto& number : table.numbers) {
    numbers.append(py::make_tuple(number.name, number.unit, number.about, number.value));
  }
  return py::make_tuple(columns, numbers);
}

/// Name, description, source and parameters of a model; parameters as tuples in the order of Parameter in theory.py.
py::dict describe(const theory::Model& model) {
  const auto text = theory::text_of(model);
  py::list parameters;
  for (const auto& parameter : theory::parameters_of(model)) {
    parameters.append(
        py::make_tuple(parameter.name, parameter.value, parameter.unit, parameter.allowed, parameter.about));
  }
  py::dict all;
  all["name"] = std::string{text.name};
  all["about"] = std::string{text.about};
  all["source"] = std::string{text.source};
  all["parameters"] = parameters;
  return all;
}

}  // namespace

void bind_theory(py::module_& module) {
  module.def("theory_descriptions", [] {
    py::list all;
    for (const auto& model : theory::default_models()) all.append(describe(model));
    return all;
  });
  module.def("theory_prediction", [](const std::string& name, const std::vector<theory::Setting>& settings) {
    const auto model = theory::make_model(name, settings);
    return py::make_tuple(describe(model), as_python(theory::predict(model)));
  });
}
