// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/core/errors.hpp"
#include "repose/run/exporting.hpp"

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
  if (order.out.empty()) order.out = order.folder + "/export/" + order.to;
  const auto files = export_run(order);
  if (options.quiet) return 0;
  for (const auto& file : files) fmt::print("{}/{}\n", order.out, file);
  if (order.to == "vtk") fmt::print("ParaView opens the .pvd files: grains as Point Gaussian or Glyph by diameter\n");
  if (order.to == "ovito") fmt::print("OVITO opens grains.dump; contacts.dump by Load trajectory, as bonds\n");
  return 0;
}

}  // namespace

Command add_export(CLI::App& app) {
  auto options = std::make_shared<ExportOptions>();
  auto* command = app.add_subcommand("export", "Write a run for ParaView, OVITO or as tables");
  command->add_option("DIR", options->order.folder, "Run folder")->required();
  command->add_option("--to", options->order.to, "vtk (ParaView), ovito (LAMMPS dumps) or csv (every table)")
      ->required()
      ->check(CLI::IsMember({"vtk", "ovito", "csv"}));
  command->add_option("--out", options->order.out, "Folder to write (default: DIR/export/FORMAT)");
  command->add_option("--frames", options->frames, "all saved frames and the last state, or the last state alone")
      ->check(CLI::IsMember({"all", "last"}));
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  return {command, [options] { return act(*options); }};
}

}  // namespace repose
