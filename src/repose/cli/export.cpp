// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/export.hpp"

#include "repose/cli/common_arguments.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"

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
  for (const auto& file : done.files) say("{}/{}\n", done.folder, file);
  if (order.to == "csv" || order.to == "contact-problem") return 0;
  say("{} {} of the run. ", done.moments, done.moments == 1 ? "state" : "states");
  if (order.to == "vtk") say("ParaView opens the .pvd files: grains as Point Gaussian or Glyph by diameter\n");
  if (order.to == "ovito") say("OVITO opens grains.dump; contacts.dump by Load trajectory, as bonds\n");
  return 0;
}

}  // namespace

Verb export_verb() {
  auto options = std::make_shared<ExportOptions>();
  return {.name = "export",
          .about = "Write a run for ParaView or OVITO, as CSV tables or as a contact problem",
          .details =
              "vtk is for ParaView; ovito writes LAMMPS dumps; csv writes every table; contact-problem writes "
              "the next step of a run of contact dynamics, for `repose solve` and other solvers.",
          .arguments = {folder_argument(options->order.folder, "Run folder"),
                        {.name = "--to",
                         .value = "FORMAT",
                         .about = "Format",
                         .target = &options->order.to,
                         .required = true,
                         .choices = {"vtk", "ovito", "csv", "contact-problem"}},
                        {.name = "--out",
                         .value = "DIR",
                         .about = "Folder to write (default: export/FORMAT in the run folder)",
                         .target = &options->order.out,
                         .completes = Completion::folders},
                        {.name = "--frames",
                         .value = "WHICH",
                         .about = "All saved frames and the last state, or the last state alone",
                         .target = &options->frames,
                         .shows_default = true,
                         .choices = {"all", "last"}},
                        overwrite_argument(options->order.overwrite, "Write into a folder that is not empty"),
                        quiet_argument(options->quiet)},
          .examples = {{"repose export heap --to vtk", "Write heap/export/vtk for ParaView"},
                       {"repose export heap --to csv --out tables", "Write every table of the run into tables"}},
          .act = [options] { return act(*options); }};
}

}  // namespace repose
