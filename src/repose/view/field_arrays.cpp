// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/view/field_arrays.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/hdf5_reader.hpp"
#include "repose/view/arrays.hpp"

#include <fmt/format.h>

namespace repose {

std::string field_arrays(const std::string& folder) {
  const Hdf5Reader file(folder + "/analysis.h5");
  if (!file.has("fields/x")) throw InputError(fmt::format("{}: the analysis has no fields", folder));
  ArrayMessage message(nlohmann::ordered_json{{"cell", file.number("fields", "cell")}});
  const auto x = file.dataset<double>("fields/x");
  message.add("x", x);
  message.add("y", file.dataset<double>("fields/y"));
  for (const auto* name : {"density", "solid_fraction", "stress_xx", "stress_xy", "stress_yx", "stress_yy",
                           "velocity_x", "velocity_y", "coordination"}) {
    const auto path = fmt::format("fields/{}", name);
    if (file.has(path)) message.add(name, file.table<double>(path, x.size()), x.size());
  }
  return message.bytes();
}

}  // namespace repose
