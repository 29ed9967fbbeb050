// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/cli/python.hpp"
#include "repose/comparison/base_overlay.hpp"
#include "repose/core/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace repose {

namespace {

std::string per_degree(const Agreement& agreement) {
  if (agreement.degrees == 0) return "not defined";
  return fmt::format("{:.4g} ({:.4g} / {})", agreement.chi_square / static_cast<double>(agreement.degrees),
                     agreement.chi_square, agreement.degrees);
}

void print(const std::vector<BaseOverlay>& all) {
  for (const auto& base : all) {
    if (!base.point.empty()) fmt::print("{}{}\n", base.point, base.problem.empty() ? "" : ": " + base.problem);
    for (const auto& comparison : base.models) {
      fmt::print("{}\n", comparison.label());
      for (const auto& [name, agreement] : {std::pair{"normal", &comparison.normal}, {"shear", &comparison.shear}}) {
        fmt::print("  {:<8} chi-square per degree {}, rms residual {:.3g} grain weights, {:.3g} of the mean load\n",
                   name, per_degree(*agreement), agreement->rms, agreement->rms_over_mean);
      }
    }
  }
  std::fflush(stdout);
}

}  // namespace

Command add_plot(CLI::App& app) {
  auto arguments = std::make_shared<std::vector<std::string>>();
  auto folder = std::make_shared<std::string>();
  auto theory = std::make_shared<std::vector<std::string>>();
  auto* command = app.add_subcommand("plot", "Draw the standard pictures of a run folder or a sweep");
  command->add_option("DIR", *folder, "Run folder or sweep folder")->required();
  const auto pass_on = [&](const std::string& option, const std::string& about) {
    command->add_option_function<std::string>(
        option,
        [arguments, option](const std::string& value) {
          arguments->push_back(option);
          arguments->push_back(value);
        },
        about);
  };
  pass_on("--only", "Pictures to draw; a wrong name lists them");
  pass_on("--format", "png,svg");
  pass_on("--dpi", "Resolution of PNG");
  pass_on("--frame", "A saved frame instead of the last state");
  command
      ->add_option("--theory", *theory,
                   "A model of base forces to be laid on the heap, MODEL or MODEL:key=value,key=value; may be repeated")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  return {command, [arguments, folder, theory]() -> int {
            if (!theory->empty()) {
              if (std::ranges::find(*arguments, "--frame") != arguments->end()) {
                throw InputError("--theory: is laid on the end of the run, not on a --frame");
              }
              print(overlay_theory(*folder, *theory));
            }
            arguments->insert(arguments->begin(), *folder);
            hand_over_to_python("repose.plot", *arguments);
          }};
}

}  // namespace repose
