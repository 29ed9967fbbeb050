// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <string>

namespace repose {

/// `repose view` of a folder as a program of its own, so that it takes nothing from the run that it shows.
class ViewerProcess {
 public:
  /// Starts it. Throws RunError.
  explicit ViewerProcess(const std::string& folder);
  /// Ends it.
  ~ViewerProcess();
  ViewerProcess(const ViewerProcess&) = delete;
  ViewerProcess& operator=(const ViewerProcess&) = delete;

  /// Waits until it ends by itself or Ctrl-C comes.
  void wait();

 private:
  pid_t process_ = -1;
};

}  // namespace repose
