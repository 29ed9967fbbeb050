// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/cli/python.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/whole_file.hpp"
#include "repose/theory/models.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
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
  if (kind != ".png" && kind != ".svg" && kind != ".pdf") {
    throw InputError(fmt::format("{}: must end in .png, .svg or .pdf", file));
  }
}

void write_table(const std::string& file, const std::string& csv) {
  WholeFile whole{file};
  whole.write(csv);
  whole.commit();
}

int act(const TheoryOptions& options) {
  if (options.list) {
    fmt::print("{}", theory::list_of_models());
    return 0;
  }
  if (options.model.empty()) throw InputError("repose theory: which model? `repose theory --list` names them");
  const bool to_file = !options.csv.empty() && options.csv != "-";
  if (to_file) check_folder_of(options.csv);
  if (!options.plot.empty()) check_picture(options.plot);
  const auto model = theory::make_model(options.model, split(options.settings));
  const auto table = theory::predict(model);
  if (to_file) {
    write_table(options.csv, as_csv(model, table));
  } else if (options.csv == "-" || options.plot.empty()) {
    fmt::print("{}", as_csv(model, table));
    std::fflush(stdout);
  }
  if (options.plot.empty()) return 0;
  std::vector<std::string> words = {options.model, "--plot", options.plot};
  for (const auto& setting : options.settings) {
    words.emplace_back("--set");
    words.push_back(setting);
  }
  hand_over_to_python("repose.draw_theory", words);
}

}  // namespace

Command add_theory(CLI::App& app) {
  auto options = std::make_shared<TheoryOptions>();
  auto* command = app.add_subcommand("theory", "A stress model of the literature as a table or a picture");
  command->add_option("MODEL", options->model, "Which; --list names them");
  command->add_option("--set", options->settings, "A parameter of the model, key=value; may be repeated")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  command->add_option("--csv", options->csv, "File for the table; - (the default without --plot) prints it");
  command->add_option("--plot", options->plot, "File for a picture: .png, .svg or .pdf");
  command->add_flag("--list", options->list, "Name models, parameters with defaults and units, and sources");
  return {command, [options] { return act(*options); }};
}

}  // namespace repose
