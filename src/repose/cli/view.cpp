// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/browser.hpp"
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/signals.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/cli/view_server.hpp"
#include "repose/io/folders.hpp"
#include "repose/record/record_file.hpp"
#include "repose/view/answers.hpp"

#include <cstdio>
#include <memory>

namespace repose {

namespace {

struct ViewOptions {
  std::string folder;
  int port = 0;
  bool no_browser = false;
};

int act(const ViewOptions& options) {
  if (path_exists(options.folder + "/run.h5")) refuse_spheres(options.folder, "the view");
  ViewServer server(std::make_shared<Answers>(options.folder), options.port);
  catch_signals();
  const auto address = server.address();
  say("{}\n", address);
  std::fflush(stdout);  // who reads the address from a pipe gets it before a browser has started
  if (!options.no_browser && !open_in_browser(address)) say("no browser was found: open the address above\n");
  say("Ctrl-C ends the view\n");
  std::fflush(stdout);
  server.serve(interrupted);
  return 0;
}

}  // namespace

Verb view_verb() {
  auto options = std::make_shared<ViewOptions>();
  return {.name = "view",
          .about = "Show a run or a sweep in the browser, also one that still runs",
          .details =
              "Serves a page to this machine alone, at an address with a random token, until Ctrl-C. The folder is "
              "only read. New frames of a run that is computed appear by themselves.",
          .arguments = {folder_argument(options->folder, "Run or sweep folder"),
                        {.name = "--port",
                         .value = "N",
                         .about = "Port to serve at (default: a free one)",
                         .target = &options->port,
                         .bound = {.least = 1, .most = 65535}},
                        {.name = "--no-browser",
                         .about = "Print the address, and open no browser",
                         .target = &options->no_browser}},
          .examples = {{"repose view heap", "Open the run in the folder heap"},
                       {"repose view heap --no-browser --port 8080",
                        "Print the address, as for a port that ssh forwards from another machine"}},
          .act = [options] { return act(*options); }};
}

}  // namespace repose
