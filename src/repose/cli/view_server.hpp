// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <string>

namespace repose {

class Answers;

/// Serves a view to browsers on this machine alone: 127.0.0.1, below a random token, reads only.
class ViewServer {
 public:
  /// Takes the port, or any free one for 0. Throws InputError where it is taken.
  ViewServer(std::shared_ptr<Answers> answers, int port);
  ~ViewServer();
  ViewServer(const ViewServer&) = delete;
  ViewServer& operator=(const ViewServer&) = delete;

  /// The address of the page, with its token.
  std::string address() const;

  /// Answers until `stop` becomes true.
  void serve(const std::atomic<bool>& stop);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace repose
