// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/python.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/comparison/base_overlay.hpp"
#include "repose/core/errors.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace repose {

namespace {

struct PlotOptions {
  std::string folder;
  std::optional<std::string> only;
  std::optional<std::string> format;
  std::optional<std::string> dpi;
  std::optional<std::string> frame;
  bool same_axes = false;
  bool own_axes = false;
  std::vector<std::string> theory;
};

std::string per_degree(const Agreement& agreement) {
  if (agreement.degrees == 0) return "not defined";
  return fmt::format("{:.4g} ({:.4g} / {})", agreement.chi_square / static_cast<double>(agreement.degrees),
                     agreement.chi_square, agreement.degrees);
}

void print(const std::vector<BaseOverlay>& all) {
  for (const auto& base : all) {
    if (!base.point.empty()) say("{}{}\n", base.point, base.problem.empty() ? "" : ": " + base.problem);
    for (const auto& comparison : base.models) {
      say("{}\n", comparison.label());
      for (const auto& [name, agreement] : {std::pair{"normal", &comparison.normal}, {"shear", &comparison.shear}}) {
        say("  {:<8} chi-square per degree {}, rms residual {:.3g} grain weights, {:.3g} of the mean load\n", name,
            per_degree(*agreement), agreement->rms, agreement->rms_over_mean);
      }
    }
  }
}

int act(const PlotOptions& options) {
  if (!options.theory.empty()) {
    if (options.frame) throw InputError("--theory: is overlaid on the end of the run, not on a --frame");
    print(overlay_theory(options.folder, options.theory));
  }
  std::vector<std::string> words = {options.folder};
  for (const auto& [name, value] : {std::pair{"--only", &options.only},
                                    {"--format", &options.format},
                                    {"--dpi", &options.dpi},
                                    {"--frame", &options.frame}}) {
    if (*value) words.insert(words.end(), {name, **value});
  }
  if (options.same_axes && options.own_axes) throw InputError("--same-axes and --own-axes exclude each other");
  if (options.same_axes) words.emplace_back("--same-axes");
  if (options.own_axes) words.emplace_back("--own-axes");
  hand_over_to_python("repose.plot", words);
}

}  // namespace

Verb plot_verb() {
  auto options = std::make_shared<PlotOptions>();
  return {.name = "plot",
          .about = "Draw the standard pictures of a run or a sweep",
          .details =
              "The pictures are written into DIR/pictures. --theory also prints how far each model is from the "
              "measured base forces: chi-square and residuals.",
          .arguments = {folder_argument(options->folder, "Run folder or sweep folder"),
                        {.name = "--only",
                         .value = "NAMES",
                         .about = "Pictures to draw, separated by commas; an unknown name lists them",
                         .target = &options->only},
                        {.name = "--format",
                         .value = "KINDS",
                         .about = "png, svg, pdf, eps, separated by commas (default: png,svg)",
                         .target = &options->format,
                         .suggestions =
                             [] {
                               return std::vector<std::string>{"png", "svg", "pdf", "eps", "png,svg"};
                             }},
                        {.name = "--dpi",
                         .value = "N",
                         .about = "Resolution of PNG, 10 to 2400 (default: 200)",
                         .target = &options->dpi},
                        {.name = "--frame",
                         .value = "NNNNNN",
                         .about = "Saved frame to draw instead of the last state; all: every one",
                         .target = &options->frame},
                        {.name = "--same-axes",
                         .about = "Size, axes and scale of forces of all frames and the last state (default of frames)",
                         .target = &options->same_axes},
                        {.name = "--own-axes",
                         .about = "Size, axes and scale of the state alone (default of the last state)",
                         .target = &options->own_axes},
                        {.name = "--theory",
                         .value = "MODEL[:KEY=VALUE,...]",
                         .about = "Model of base forces to overlay on the measured ones",
                         .target = &options->theory}},
          .examples = {{"repose plot heap", "Draw the run in the folder heap"},
                       {"repose plot heap --only heap,chains --format png --dpi 300", "Draw two pictures for print"},
                       {"repose plot heap --frame all --only heap --format png", "Draw the frames of a movie"},
                       {"repose plot heap --theory pile-continuum --theory osl:model=fpa",
                        "Compare the base forces with two models"}},
          .act = [options] { return act(*options); }};
}

}  // namespace repose
