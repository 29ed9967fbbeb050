// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/view/answers.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/failure.hpp"
#include "repose/core/version.hpp"
#include "repose/io/folders.hpp"
#include "repose/view/page.hpp"
#include "repose/view/run_answers.hpp"
#include "repose/view/sweep_answers.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

namespace repose {

namespace {

std::string last_name(const std::string& folder) {
  const auto path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

}  // namespace

Answers::Answers(const std::string& folder) : folder_(folder) {
  if (!path_exists(folder)) throw InputError(fmt::format("{}: no such folder", folder));
  if (SweepFolder::is_one(folder)) {
    sweep_ = std::make_unique<SweepAnswers>(folder);
    return;
  }
  run_ = std::make_unique<RunAnswers>(folder);
  run_->state();
}

Answers::~Answers() = default;

Answer Answers::answer(const std::string& address) {
  if (address.empty()) return {200, "text/html; charset=utf-8", std::string(view_page())};
  if (!address.starts_with("api/")) return nothing(fmt::format("{}: no such address", address));
  const auto rest = address.substr(4);
  if (rest == "folder") {
    return json_answer(nlohmann::ordered_json{
        {"kind", sweep_ ? "sweep" : "run"}, {"name", last_name(folder_)}, {"repose_version", version}}
                           .dump());
  }
  const std::lock_guard lock(mutex_);
  try {
    return sweep_ ? sweep_->answer(rest) : run_->answer(rest);
  } catch (const std::exception& failure) {
    return {500, "text/plain; charset=utf-8", message_of(failure) + "\n"};
  }
}

bool Answers::has_events(const std::string& of) { return of.empty() || member(of) != nullptr; }

RunAnswers* Answers::member(const std::string& of) {
  constexpr std::string_view before = "members/";
  if (!sweep_ || !of.starts_with(before) || !of.ends_with('/')) return nullptr;
  return sweep_->member(of.substr(before.size(), of.size() - before.size() - 1));
}

std::string Answers::state(const std::string& of) {
  if (!path_exists(folder_)) return "";
  const std::lock_guard lock(mutex_);
  try {
    if (!of.empty()) return member(of)->state().dump();
    return (sweep_ ? sweep_->state() : run_->state()).dump();
  } catch (const std::exception&) {  // a file is being replaced: a later check tells
    return path_exists(folder_) ? "{}" : "";
  }
}

}  // namespace repose
