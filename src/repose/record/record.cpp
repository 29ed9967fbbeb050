// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/record.hpp"

#include <stdexcept>

namespace repose {

std::string status_text(Status status) {
  switch (status) {
    case Status::running:
      return "running";
    case Status::finished:
      return "finished";
    case Status::interrupted:
      return "interrupted";
    case Status::failed:
      return "failed";
  }
  return "";
}

Status status_of(const std::string& text) {
  for (const auto status : {Status::running, Status::finished, Status::interrupted, Status::failed}) {
    if (status_text(status) == text) return status;
  }
  throw std::out_of_range("no such status: " + text);
}

SolverAccount solver_account(const Record& record) {
  SolverAccount all;
  for (const auto& row : record.series) all += row.solver;
  return all;
}

}  // namespace repose
