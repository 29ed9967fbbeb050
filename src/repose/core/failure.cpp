// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/failure.hpp"

#include "repose/core/errors.hpp"

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

namespace repose {

std::string message_of(const std::exception& failure) {
  const auto is = [&]<class Kind>(const Kind*) { return dynamic_cast<const Kind*>(&failure) != nullptr; };
  if (is(static_cast<InputError*>(nullptr)) || is(static_cast<RunError*>(nullptr))) return failure.what();
  if (is(static_cast<std::bad_alloc*>(nullptr)) || is(static_cast<std::length_error*>(nullptr))) {
    return "repose: not enough memory for this";
  }
  if (const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&failure)) {
    return of_file->path1().string() + ": " + of_file->code().message();
  }
  if (const auto* of_system = dynamic_cast<const std::system_error*>(&failure)) {
    return "repose: the system refuses: " + of_system->code().message();
  }
  return "repose: an error that it does not expect; this is a bug, please report it with the command and its files";
}

}  // namespace repose
