// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/study/study.hpp"

#include "repose/cli/common_arguments.hpp"
#include "repose/cli/python.hpp"
#include "repose/cli/run_sweep.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/signals.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/sweep/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

namespace fs = std::filesystem;

namespace repose {

namespace {

struct StudyOptions {
  std::string action;
  std::vector<std::string> names;
  std::string studies;
  std::string out;
  std::string page;
  int processes = 0;
  bool quick = false;
  bool quiet = false;

  SweepForm form() const { return quick ? SweepForm::quick : SweepForm::full; }
  /// The results of both forms never mix.
  std::string folder() const { return out.empty() ? (quick ? "studies-quick" : "studies-full") : out; }
};

/// The folder of the studies: the one that is named, else that of an installation or of the sources of the program.
std::string studies_folder(const StudyOptions& options) {
  if (!options.studies.empty()) return options.studies;
  std::error_code error;
  const auto here = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* folder : {"../share/repose/studies", "../../studies"}) {
    const auto found = fs::weakly_canonical(here / folder, error);
    if (fs::is_directory(found, error)) return found.string();
  }
  throw InputError("no folder of studies beside the program (--studies DIR names it)");
}

std::string result_folder(const StudyOptions& options, const std::string& study) {
  const auto dot = study.find('.');
  return fmt::format("{}/{}/{}", options.folder(), study.substr(0, dot), study.substr(dot + 1));
}

/// OUT/GROUP/ensembles/NAME
std::string ensemble_folder(const StudyOptions& options, const Study& study) {
  return fmt::format("{}/{}/ensembles/{}", options.folder(), study.name.substr(0, study.name.find('.')),
                     fs::path(study.ensemble).stem().string());
}

int list(const StudyOptions& options, const std::vector<StudyFile>& chosen) {
  for (const auto& file : chosen) {
    const auto study = read_study(file, options.form());
    std::string what = "models of theory";
    if (!study.ensemble.empty()) {
      what = fmt::format("{} runs", study.plan.points.size() * study.plan.seeds.size());
    }
    const auto claims = study.plan.claims.size() + study.profile_claims.size() + study.model_claims.size();
    say("{:28}  {:3} claims, {:16}  {} ({})\n", study.name, claims, what, study.title, study.source);
  }
  return 0;
}

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", folder, error.message()));
}

/// Whether a study on this ensemble needs force ranges.
bool needs_range(const std::vector<Study>& studies, const std::string& ensemble) {
  return std::any_of(studies.begin(), studies.end(),
                     [&](const Study& study) { return study.force_range && study.ensemble == ensemble; });
}

/// The results of an ensemble; where `wanted`, with the range of base forces that equilibrium allows rigid grains. It
/// is computed again only if a member lacks it.
SweepTable table_of(const std::string& path, bool wanted) {
  const SweepFolder folder(path);
  auto table = folder.table();
  if (!wanted) return table;
  const auto name = std::string("force_range.degree");
  const auto found = std::find(table.measures.begin(), table.measures.end(), name) - table.measures.begin();
  const auto lacks = [&](const MemberRow& member) {
    if (member.status != "finished") return false;
    if (folder.plan().points[member.point].scene.method->solver() == nullptr) return false;
    const auto column = static_cast<std::size_t>(found);
    return column >= member.values.size() || std::isnan(member.values[column]);
  };
  if (std::none_of(table.members.begin(), table.members.end(), lacks)) return table;
  folder.analyse({.force_range = true});
  return folder.table();
}

/// Throws InputError if two ensembles of one group have the same file name, and so would share a folder.
void check_ensembles(const StudyOptions& options, const std::vector<Study>& studies) {
  std::map<std::string, std::string> files;
  for (const auto& study : studies) {
    if (study.ensemble.empty()) continue;
    const auto& first = files.emplace(ensemble_folder(options, study), study.ensemble).first->second;
    if (first == study.ensemble) continue;
    throw InputError(fmt::format("{}: ensemble = {}: has the name of {}; give one of them another", study.file,
                                 study.ensemble, first));
  }
}

int run(const StudyOptions& options, const std::vector<StudyFile>& chosen) {
  // All files are read before anything runs, so that a mistake in the last one is found first.
  std::vector<Study> studies;
  std::vector<std::string> problems;
  for (const auto& file : chosen) {
    try {
      studies.push_back(read_study(file, options.form()));
    } catch (const InputError& error) {
      problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    }
  }
  if (!problems.empty()) throw InputError(problems);
  check_ensembles(options, studies);
  std::map<std::string, SweepTable> tables;  // by folder of the ensemble
  std::vector<std::string> names;
  int status = 0;
  for (const auto& study : studies) {
    const auto folder = study.ensemble.empty() ? "" : ensemble_folder(options, study);
    if (!study.ensemble.empty() && !tables.contains(folder)) {
      make_folder(fs::path(folder).parent_path().string());
      const SweepRun ensemble{.file = study.ensemble,
                              .folder = folder,
                              .form = options.form(),
                              .processes = options.processes,
                              .quiet = options.quiet,
                              .with_result = false};
      status = std::max(status, run_sweep(ensemble));
      if (interrupted) return exit_interrupted;
      tables.emplace(folder, table_of(folder, needs_range(studies, study.ensemble)));
    }
    const auto place = result_folder(options, study.name);
    make_folder(place);
    const auto json =
        study_json(study, options.form(), folder.empty() ? SweepTable{} : tables.at(folder), folder, place);
    write_text_file(place + "/study.json", json);
    if (!options.quiet) say("{}", study_text(json));
    names.push_back(study.name);
  }
  std::vector<std::string> words{options.folder(), fmt::format("{}", status)};
  words.insert(words.end(), names.begin(), names.end());
  hand_over_to_python("repose.draw_study", words);
}

int act(const StudyOptions& options) {
  const auto chosen = chosen_studies(find_studies(studies_folder(options)),
                                     options.names.empty() ? std::vector<std::string>{"all"} : options.names);
  if (options.action == "list") return list(options, chosen);
  if (options.action == "run") {
    if (options.names.empty()) throw InputError("repose study run: give the studies to run; all runs every one");
    return run(options, chosen);
  }
  std::vector<std::string> words{options.folder(), options.page};
  for (const auto& study : chosen) words.push_back(study.name);
  hand_over_to_python("repose.study_page", words);
}

}  // namespace

Verb study_verb() {
  auto options = std::make_shared<StudyOptions>();
  options->page = "studies.md";
  return {.name = "study",
          .about = "Reproduce published figures and numbers, with a verdict on each statement",
          .details =
              "A study holds what a document states against an ensemble of runs or a model. Studies share their "
              "ensembles, which continue after a stop of any kind. page writes a page with all verdicts and figures.",
          .arguments = {{.name = "ACTION",
                         .about = "list, run or page",
                         .target = &options->action,
                         .required = true,
                         .choices = {"list", "run", "page"}},
                        {.name = "STUDY",
                         .about = "Names such as baxter1997.fig3, or baxter1997 for all of it, or all",
                         .target = &options->names},
                        {.name = "--quick",
                         .about = "Small ensembles: minutes instead of hours, with wider intervals",
                         .target = &options->quick},
                        {.name = "--out",
                         .value = "DIR",
                         .about = "Folder of the results (default: studies-full, or studies-quick)",
                         .target = &options->out,
                         .completes = Completion::folders},
                        {.name = "--studies",
                         .value = "DIR",
                         .about = "Folder of the study files (default: those of the program)",
                         .target = &options->studies,
                         .completes = Completion::folders},
                        {.name = "--page",
                         .value = "FILE",
                         .about = "Page that page writes (default: studies.md)",
                         .target = &options->page,
                         .completes = Completion::files},
                        threads_argument(options->processes, "Runs side by side, at most one per core (default)"),
                        quiet_argument(options->quiet)},
          .examples = {{"repose study list", "List all studies"},
                       {"repose study run bratberg2003.thesis-fig10 --quick", "Reproduce one figure, here of theory"},
                       {"repose study page all --quick", "Write a page with all verdicts and figures"}},
          .act = [options] { return act(*options); }};
}

}  // namespace repose
