// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/hdf5_handle.hpp"

namespace repose {

void set_up_hdf5() {
  static const bool once = [] {
    H5dont_atexit();
    return true;
  }();
  thread_local const bool in_this_thread = [] {  // each has a stack of errors of its own, which it would print
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return true;
  }();
  static_cast<void>(once && in_this_thread);
}

std::string hdf5_reason() {
  std::string found;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
        const std::string text = error->desc != nullptr ? error->desc : "";
        const std::string key = "error message = '";
        auto& reason = *static_cast<std::string*>(out);
        if (const auto begin = text.find(key); begin != std::string::npos && reason.empty()) {
          reason = text.substr(begin + key.size());
          reason = reason.substr(0, reason.find('\''));
        }
        return 0;
      },
      &found);
  return found.empty() ? "HDF5 library error" : found;
}

}  // namespace repose
