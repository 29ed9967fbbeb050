// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/export.hpp"

#include "repose/cli/commands.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace repose {

namespace {

struct ExportOptions {
  ExportOrder order;
  std::string frames = "all";
  bool quiet = false;
};

int act(const ExportOptions& options) {
  auto order = options.order;
  order.frames = options.frames == "all";
  const auto done = export_run(order);
  if (options.quiet) return 0;
  for (const auto& file : done.files) fmt::print("{}/{}\n", done.folder, file);
  if (order.to == "csv" || order.to == "contact-problem") return 0;
  fmt::print("{} {} of the run. ", done.moments, done.moments == 1 ? "state" : "states");
  if (order.to == "vtk") fmt::print("ParaView opens the .pvd files: grains as Point Gaussian or Glyph by diameter\n");
  if (order.to == "ovito") fmt::print("OVITO opens grains.dump; contacts.dump by Load trajectory, as bonds\n");
  return 0;
}

}  // namespace

Command add_export(CLI::App& app) {
  auto options = std::make_shared<ExportOptions>();
  auto* command = app.add_subcommand("export", "Write a run for ParaView, OVITO, as tables or as a contact problem");
  command->add_option("DIR", options->order.folder, "Run folder")->required();
  command
      ->add_option("--to", options->order.to,
                   "vtk (ParaView), ovito (LAMMPS dumps), csv (every table) or contact-problem (the next step of "
                   "contact dynamics)")
      ->required()
      ->check(CLI::IsMember({"vtk", "ovito", "csv", "contact-problem"}));
  command->add_option("--out", options->order.out, "Folder to write (default: DIR/export/FORMAT)");
  command->add_option("--frames", options->frames, "all saved frames and the last state, or the last state alone")
      ->check(CLI::IsMember({"all", "last"}));
  command->add_flag("--overwrite", options->order.overwrite, "Write into a folder that is not empty");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  return {command, [options] { return act(*options); }};
}

}  // namespace repose
