// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/janssen_fit.hpp"

#include "repose/core/errors.hpp"
#include "repose/tables/file_problems.hpp"
#include "repose/tables/number_table.hpp"
#include "repose/theory/column_walls.hpp"
#include "repose/theory/screening_fit.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace repose::theory {

namespace {

/// Names of the column of standard deviations.
const std::vector<std::string> error_names = {"apparent_mass_error", "mass_error", "error", "sigma", "err",
                                              "standard_error",      "stderr",     "std",   "sd",    "uncertainty"};

struct Data {
  ApparentMasses masses;
  std::string error_name;  ///< of its column in the file
  std::vector<std::string> left_out;
};

Data read_masses(const JanssenFit& fit) {
  const NumberTable file(fit.file, {"height", "apparent_mass"});
  Data data;
  auto& masses = data.masses;
  masses.height = file.numbers("height");
  masses.mass = file.numbers("apparent_mass");
  const auto error = file.find(error_names);
  if (error) masses.error = file.numbers(*error);
  FileProblems problems(fit.file);
  for (std::size_t row = 0; row < file.rows(); ++row) {
    if (masses.height[row] < 0.0) {
      problems.add(file.line(row), fmt::format("height = {}: must be >= 0 (L)", masses.height[row]));
    }
    if (error && masses.error[row] <= 0.0) {
      problems.add(file.line(row), fmt::format("{} = {}: must be > 0 (M)", file.name(*error), masses.error[row]));
    }
  }
  problems.check();
  if (static_cast<std::int64_t>(file.rows()) < fit.parameters) {
    throw InputError(fmt::format("{}: has {} row{}; {} parameters need as many", fit.file, file.rows(),
                                 file.rows() == 1 ? "" : "s", fit.parameters));
  }
  if (error) data.error_name = file.name(*error);
  for (std::size_t k = 0; k < file.columns(); ++k) {
    const bool used = k == file.find({"height"}) || k == file.find({"apparent_mass"}) || k == error;
    if (!used) data.left_out.push_back(file.name(k).empty() ? fmt::format("column {}", k + 1) : file.name(k));
  }
  return data;
}

}  // namespace

void parameters(JanssenFit& fit, Parameters& to) {
  to.text("file", fit.file,
          "table with columns height (L), apparent_mass (M) and optionally apparent_mass_error, error or sigma (M)");
  to.integer("parameters", fit.parameters, {.low = 1, .high = 2}, "2: lambda_1 and lambda_2; 1: both are equal");
  to.choice("direction", fit.direction, column_directions(),
            "rest: the walls carry weight; pushed-up: the same friction holds the grains down");
  to.number("mass_per_height", fit.mass_per_height, positive, "M/L", "mass of the grains per height, rho c area");
}

Table evaluate(const JanssenFit& fit) {
  const auto read = read_masses(fit);
  const auto& data = read.masses;
  const auto result = fit_screening(
      {.mass_per_height = fit.mass_per_height, .sense = wall_sense(fit.direction), .parameters = fit.parameters}, data);
  const bool weighted = !data.error.empty();
  std::vector<double> residuals;
  for (std::size_t row = 0; row < data.mass.size(); ++row) residuals.push_back(data.mass[row] - result.fitted[row]);
  const auto freedom = static_cast<double>(result.degrees_of_freedom);
  const double chance = weighted && freedom > 0.0 ? boost::math::gamma_q(0.5 * freedom, 0.5 * result.chi_square)
                                                  : std::numeric_limits<double>::quiet_NaN();
  const std::string scaled =
      weighted ? "standard error, from those of the data" : "standard error, from the scatter of the residuals";
  Table table{{{"height", "L", "as in the file", data.height, {}},
               {"apparent_mass", "M", "as in the file", data.mass, {}},
               {"fitted", "M", "apparent mass by the fitted law", result.fitted, {}},
               {"residual", "M", "apparent_mass minus fitted", residuals, {}}},
              {{"lambda_1", result.lambda_1, "L", "length that sets the size of the mass"},
               {"lambda_1_error", result.lambda_1_error, "L", scaled},
               {"lambda_2", result.lambda_2, "L", "length over which the mass changes"},
               {"lambda_2_error", result.lambda_2_error, "L", scaled},
               {"ratio", result.lambda_1 / result.lambda_2, "1", "lambda_1/lambda_2"},
               {"correlation", result.correlation, "1", "correlation of the errors of lambda_1 and lambda_2"},
               {"chi_square", result.chi_square, weighted ? "1" : "M^2",
                weighted ? "sum of squares of residuals over errors" : "sum of squares of residuals"},
               {"degrees_of_freedom", freedom, "1", "rows minus parameters"},
               {"chance", chance, "1", "probability of a chi_square at least as large if law and errors are right"},
               {"rms_residual", result.rms_residual, "M", "root of the mean square of the residuals"}}};
  if (weighted) {
    table.columns.push_back({"apparent_mass_error", "M", "as in the file", data.error, {}});
    table.notes.push_back(fmt::format("errors of the masses: column {}", read.error_name));
  } else {
    table.notes.push_back(
        fmt::format("errors of the masses: none in the file; names of their column: {}", fmt::join(error_names, ", ")));
  }
  if (!read.left_out.empty()) {
    table.notes.push_back(fmt::format("columns left out: {}", fmt::join(read.left_out, ", ")));
  }
  return table;
}

}  // namespace repose::theory
