// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/python.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/named_file.hpp"
#include "repose/theory/models.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace repose {

namespace {

struct TheoryOptions {
  std::string model;
  std::vector<std::string> settings;
  std::string csv;
  std::string plot;
  bool list = false;
};

std::vector<theory::Setting> split(const std::vector<std::string>& settings) {
  std::vector<theory::Setting> pairs;
  std::vector<std::string> problems;
  for (const auto& setting : settings) {
    if (auto pair = theory::read_setting(setting)) {
      pairs.push_back(std::move(*pair));
    } else {
      problems.push_back(fmt::format("--set {}: must be key=value", setting));
    }
  }
  if (!problems.empty()) throw InputError(problems);
  return pairs;
}

void check_folder_of(const std::string& file) {
  std::error_code error;
  const auto folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder, error)) {
    throw InputError(fmt::format("{}: no such folder: {}", file, folder.string()));
  }
  if (std::filesystem::is_directory(file, error)) throw InputError(fmt::format("{}: is a folder", file));
}

void check_picture(const std::string& file) {
  check_folder_of(file);
  const auto kind = std::filesystem::path{file}.extension();
  if (kind != ".png" && kind != ".svg" && kind != ".pdf" && kind != ".eps") {
    throw InputError(fmt::format("{}: must end in .png, .svg, .pdf or .eps", file));
  }
}

int act(const TheoryOptions& options) {
  if (options.list) {
    say("{}", theory::list_of_models());
    return 0;
  }
  if (options.model.empty())
    throw InputError("repose theory: MODEL is missing (`repose theory --list` names the models)");
  const bool to_file = !options.csv.empty() && options.csv != "-";
  if (to_file) check_folder_of(options.csv);
  if (!options.plot.empty()) check_picture(options.plot);
  const auto model = theory::make_model(options.model, split(options.settings));
  const auto table = theory::predict(model);
  if (to_file) {
    write_named_file(options.csv, as_csv(model, table));
  } else if (options.csv == "-" || options.plot.empty()) {
    say("{}", as_csv(model, table));
  }
  if (options.plot.empty()) return 0;
  std::vector<std::string> words = {options.model, "--plot", options.plot};
  for (const auto& setting : options.settings) {
    words.emplace_back("--set");
    words.push_back(setting);
  }
  hand_over_to_python("repose.draw_theory", words);
}

std::vector<std::string> names_of_models() {
  std::vector<std::string> names;
  for (const auto& model : theory::default_models()) names.emplace_back(theory::text_of(model).name);
  return names;
}

}  // namespace

Verb theory_verb() {
  auto options = std::make_shared<TheoryOptions>();
  return {.name = "theory",
          .about = "Print or draw a stress model of the literature",
          .details = "--list names the models, their parameters with defaults and units, and their sources.",
          .arguments = {{.name = "MODEL",
                         .about = "Model to evaluate",
                         .target = &options->model,
                         .suggestions = names_of_models},
                        {.name = "--set",
                         .value = "KEY=VALUE",
                         .about = "Set a parameter of the model",
                         .target = &options->settings},
                        {.name = "--csv",
                         .value = "FILE",
                         .about = "File to write the table to; - prints it, as does a call without --plot",
                         .target = &options->csv,
                         .completes = Completion::files},
                        {.name = "--plot",
                         .value = "FILE",
                         .about = "File to draw a picture to: .png, .svg, .pdf or .eps",
                         .target = &options->plot,
                         .completes = Completion::files},
                        {.name = "--list", .about = "List models, parameters and sources", .target = &options->list}},
          .examples = {{"repose theory --list", "List all models"},
                       {"repose theory pile-continuum --set slope_deg=30", "Print the base pressure of a pile"},
                       {"repose theory osl --set model=ife --set angle_deg=32 --csv ife.csv --plot ife.png",
                        "Write oriented stress linearity as a table and a picture"}},
          .act = [options] { return act(*options); }};
}

}  // namespace repose
