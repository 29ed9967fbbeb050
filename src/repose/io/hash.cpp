// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <new>

namespace repose {

struct Hash::State {
  State() : stream(XXH3_createState()) {
    if (stream == nullptr) throw std::bad_alloc();
    XXH3_128bits_reset(stream);
  }
  ~State() { XXH3_freeState(stream); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  XXH3_state_t* stream;
};

Hash::Hash() : state_(std::make_unique<State>()) {}
Hash::~Hash() = default;

void Hash::add(const void* data, std::size_t size) {
  if (size > 0) XXH3_128bits_update(state_->stream, data, size);
}

std::string Hash::text() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_->stream);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string hash_of(std::string_view text) {
  Hash hash;
  hash.add(text.data(), text.size());
  return hash.text();
}

}  // namespace repose
