// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <vector>

namespace repose {

/// Wall time by stage. A stage within another one counts for itself alone, so that the seconds of all stages sum to the
/// time since the profile was made. For one thread: the one that leads a team.
class Profile {
 public:
  struct Line {
    std::string_view name;
    double seconds = 0.0;
    long calls = 0;
  };

  /// A stage at work until the end of its scope. `name` is a literal. Without a profile it does nothing.
  class [[nodiscard]] Stage {
   public:
    Stage(Profile* profile, std::string_view name) : profile_(profile) {
      if (profile_ != nullptr) outer_ = profile_->enter(name);
    }
    ~Stage() {
      if (profile_ != nullptr) profile_->leave(outer_);
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

   private:
    Profile* profile_;
    std::size_t outer_ = 0;
  };

  /// In the order in which they first began; last the time outside all stages, called "other".
  std::vector<Line> lines() {
    count();
    auto all = lines_;
    std::rotate(all.begin(), all.begin() + 1, all.end());
    return all;
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// Counts the time up to now for the present stage.
  void count() {
    const auto now = Clock::now();
    lines_[present_].seconds += std::chrono::duration<double>(now - since_).count();
    since_ = now;
  }

  std::size_t enter(std::string_view name) {
    count();
    const auto found = std::find_if(lines_.begin(), lines_.end(), [&](const auto& line) { return line.name == name; });
    const auto outer = present_;
    present_ = static_cast<std::size_t>(found - lines_.begin());
    if (found == lines_.end()) lines_.push_back({name});
    ++lines_[present_].calls;
    return outer;
  }

  void leave(std::size_t outer) {
    count();
    present_ = outer;
  }

  std::vector<Line> lines_{{"other"}};
  std::size_t present_ = 0;
  Clock::time_point since_ = Clock::now();
};

}  // namespace repose
