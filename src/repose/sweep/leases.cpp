// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/leases.hpp"

#include "repose/core/errors.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace fs = std::filesystem;

namespace repose {

namespace {

std::string host_name() {
  char name[256] = "";
  ::gethostname(name, sizeof name - 1);
  return name;
}

/// Whether a holder, "HOST PROCESS", is a program of this machine that has ended.
bool has_ended(const std::string& holder) {
  const auto space = holder.rfind(' ');
  if (space == std::string::npos || holder.substr(0, space) != host_name()) return false;
  const long process = std::strtol(holder.c_str() + space + 1, nullptr, 10);
  return process > 0 && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
}

std::string holder_in(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

}  // namespace

Leases::Leases(std::string folder, double patience)
    : folder_(std::move(folder)), patience_(patience), holder_(fmt::format("{} {}", host_name(), ::getpid())) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", folder_.string(), error.message()));
}

Leases::~Leases() {
  std::error_code error;
  for (const auto& name : held_) fs::remove(file_of(name), error);
}

fs::path Leases::file_of(const std::string& name) const { return folder_ / name; }

bool Leases::create(const fs::path& file) const {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0 && errno == EEXIST) return false;
  const auto text = holder_ + "\n";
  const bool written =
      descriptor >= 0 && ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const int problem = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!written) throw RunError(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(problem)));
  return true;
}

bool Leases::is_dead(const fs::path& file, const std::string& name) {
  std::error_code error;
  const auto touched = fs::last_write_time(file, error);
  if (error) return false;  // it has just been given back
  const auto now = Clock::now();
  auto& seen = others_.try_emplace(name, Seen{touched, now}).first->second;
  if (seen.touched != touched) seen = {touched, now};
  return has_ended(holder_in(file)) || std::chrono::duration<double>(now - seen.since).count() > patience_;
}

void Leases::take_away(const fs::path& file, const std::string& name) {
  // Only one of several who find it dead can rename it. If it was touched since, its holder lives: it is put back.
  auto away = file;
  away += fmt::format(".{}", holder_);
  if (::rename(file.c_str(), away.c_str()) != 0) return;
  std::error_code error;
  const auto touched = fs::last_write_time(away, error);
  if (!error && touched != others_.at(name).touched) fs::create_hard_link(away, file, error);
  fs::remove(away, error);
  others_.erase(name);
}

bool Leases::take(const std::string& name) {
  const auto file = file_of(name);
  bool taken = create(file);
  if (!taken && is_dead(file, name)) {
    take_away(file, name);
    taken = create(file);
  }
  if (taken) held_.insert(name);
  return taken;
}

void Leases::give_back(const std::string& name) {
  if (held_.erase(name) == 0) return;
  std::error_code error;
  fs::remove(file_of(name), error);
}

void Leases::touch() {
  constexpr double part_of_patience = 0.1;
  const auto now = Clock::now();
  if (std::chrono::duration<double>(now - touched_).count() < part_of_patience * patience_) return;
  touched_ = now;
  std::error_code error;
  for (const auto& name : held_) fs::last_write_time(file_of(name), fs::file_time_type::clock::now(), error);
}

}  // namespace repose
