// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/export.hpp"

#include "repose/cli/common_arguments.hpp"
#include "repose/cli/python.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/folders.hpp"
#include "repose/record/record_file.hpp"
#include "repose/view/exported_page.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace repose {

namespace {

struct ExportOptions {
  ExportOrder order;
  std::string frames = "all";
  bool quiet = false;
  std::optional<std::string> picture;  // of a movie, as the three below
  std::optional<std::string> format;
  std::optional<std::string> fps;
  std::optional<std::string> dpi;
};

/// The options of a movie that are given.
std::vector<std::pair<std::string, std::string>> movie_options(const ExportOptions& options) {
  std::vector<std::pair<std::string, std::string>> given;
  const auto add = [&](const char* name, const std::optional<std::string>& value) {
    if (value) given.emplace_back(name, *value);
  };
  add("--picture", options.picture);
  add("--format", options.format);
  add("--fps", options.fps);
  add("--dpi", options.dpi);
  return given;
}

/// Checks the folders, and leaves the movie to Python.
void make_movie(const ExportOptions& options) {
  const auto& order = options.order;
  if (options.frames != "all") throw InputError("--frames: a movie has all frames");
  read_run_facts(order.folder);
  const auto out = order.out.empty() ? order.folder + "/export/movie" : order.out;
  if (const auto problems = folder_problems(out); !problems.empty()) throw InputError(problems);
  if (!order.out.empty() && !order.overwrite && path_exists(out) && !std::filesystem::is_empty(out)) {
    throw InputError(fmt::format("{}: folder is not empty; choose another --out, or --overwrite", out));
  }
  std::vector<std::string> words = {order.folder, out};
  for (const auto& [name, value] : movie_options(options)) words.insert(words.end(), {name, value});
  if (options.quiet) words.emplace_back("--quiet");
  hand_over_to_python("repose.movie", words);
}

int act(const ExportOptions& options) {
  if (options.order.to == "movie") make_movie(options);
  if (const auto given = movie_options(options); !given.empty()) {
    throw InputError(fmt::format("{}: for --to movie alone", given.front().first));
  }
  auto order = options.order;
  order.frames = options.frames == "all";
  const auto done = order.to == "html" ? export_run(order, export_page) : export_run(order);
  if (options.quiet) return 0;
  for (const auto& file : done.files) say("{}/{}\n", done.folder, file);
  if (order.to == "csv" || order.to == "contact-problem") return 0;
  say("{} {} of the run. ", done.moments, done.moments == 1 ? "state" : "states");
  if (order.to == "vtk") say("ParaView opens the .pvd files: grains as Point Gaussian or Glyph by diameter\n");
  if (order.to == "html") say("A browser opens run.html from disk\n");
  if (order.to == "ovito") say("OVITO opens grains.dump; contacts.dump by Load trajectory, as bonds\n");
  return 0;
}

}  // namespace

Verb export_verb() {
  auto options = std::make_shared<ExportOptions>();
  return {
      .name = "export",
      .about = "Write a run for ParaView or OVITO, as CSV tables, as one page or as a contact problem",
      .details =
          "vtk is for ParaView; ovito writes LAMMPS dumps; csv writes every table; html writes one page that a browser "
          "opens from disk, with all that `repose view` shows; movie draws the frames, with ffmpeg where it is "
          "installed; "
          "contact-problem writes the next step of a run of "
          "contact dynamics, for `repose solve` and other solvers.",
      .arguments = {folder_argument(options->order.folder, "Run folder"),
                    {.name = "--to",
                     .value = "FORMAT",
                     .about = "Format",
                     .target = &options->order.to,
                     .required = true,
                     .choices = {"vtk", "ovito", "csv", "html", "movie", "contact-problem"}},
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
                    {.name = "--picture",
                     .value = "NAME",
                     .about = "Of a movie: what it draws (default: forces)",
                     .target = &options->picture,
                     .choices = {"heap", "forces", "density"}},
                    {.name = "--format",
                     .value = "KIND",
                     .about = "Of a movie (default: mp4)",
                     .target = &options->format,
                     .choices = {"mp4", "webm", "gif"}},
                    {.name = "--fps",
                     .value = "N",
                     .about = "Of a movie: frames per second, 1 to 120 (default: 25)",
                     .target = &options->fps},
                    {.name = "--dpi",
                     .value = "N",
                     .about = "Of a movie: resolution, 10 to 1200 (default: 150, a width of 1050)",
                     .target = &options->dpi},
                    overwrite_argument(options->order.overwrite, "Write into a folder that is not empty"),
                    quiet_argument(options->quiet)},
      .examples = {{"repose export heap --to vtk", "Write heap/export/vtk for ParaView"},
                   {"repose export heap --to csv --out tables", "Write every table of the run into tables"},
                   {"repose export heap --to html", "Write heap/export/html/run.html, to send to a colleague"},
                   {"repose export heap --to movie --picture heap --fps 12", "Draw the saved frames as a movie"}},
      .act = [options] { return act(*options); }};
}

}  // namespace repose
