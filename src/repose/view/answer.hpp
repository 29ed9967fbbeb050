// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace repose {

/// What a view says to an address below its token: docs/reference/view.md.
struct Answer {
  int status = 200;  ///< of HTTP
  std::string type = "application/json";
  std::string body;
};

inline Answer json_answer(std::string text) { return {200, "application/json", std::move(text)}; }
inline Answer arrays_answer(std::string bytes) { return {200, "application/octet-stream", std::move(bytes)}; }
/// One line that says why there is nothing.
inline Answer nothing(const std::string& why) { return {404, "text/plain; charset=utf-8", why + "\n"}; }

}  // namespace repose
