// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace repose {

inline constexpr int exit_run_trouble = 1;
inline constexpr int exit_bad_input = 2;
inline constexpr int exit_interrupted = 130;

/// One verb of the program: its options are registered, `act` does it and returns the exit status.
struct Command {
  CLI::App* app = nullptr;
  std::function<int()> act;
};

Command add_run(CLI::App& app);
Command add_check(CLI::App& app);
Command add_resume(CLI::App& app);
Command add_sweep(CLI::App& app);
Command add_analyse(CLI::App& app);
Command add_export(CLI::App& app);
Command add_solve(CLI::App& app);
Command add_theory(CLI::App& app);
Command add_plot(CLI::App& app);
Command add_reference(CLI::App& app);
Command add_scene(CLI::App& app);

}  // namespace repose
