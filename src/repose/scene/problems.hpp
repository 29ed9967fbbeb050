// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace repose {

/// Gathers what is wrong with a scene that one key alone cannot tell. A check leaves alone what is wrong by itself.
class Problems {
 public:
  virtual ~Problems() = default;

  /// Adds a problem with a key; `what` follows the key in the message, as in " = -1: must be > 0".
  virtual void problem(const std::string& key, const std::string& what) = 0;

  /// Whether nothing is wrong with a key so far.
  virtual bool sound(const std::string& key) const = 0;

  /// Whether nothing is wrong at all so far.
  virtual bool none() const = 0;
};

/// What is wrong with a title, as it follows the key in a message; "" if nothing is. Files keep titles as attributes,
/// for which HDF5 has 64 kB.
std::string title_problem(const std::string& title);

}  // namespace repose
