// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.hpp"
#include "repose/view/exported_page.hpp"

void bind_view(py::module_& module) {
  module.def(
      "exported_page",
      [](const std::string& folder, bool frames) {
        const py::gil_scoped_release others_may_run;
        return repose::exported_page(folder, frames).text;
      },
      "The page of `repose view` with a run in it, all its frames or the last state alone; ValueError.");
}
