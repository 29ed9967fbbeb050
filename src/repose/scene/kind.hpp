// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/errors.hpp"
#include "repose/core/parameters.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace repose {

// A method, a source, a base: a scene chooses one kind of each by name. A kind is a small struct with its parameters,
// their keys and checks, and the answers to what the rest of the program asks; nothing above asks for its name. The
// lists of kinds are open: a program that links the library adds a kind of its own with one call and need not touch
// ours. That is why a kind is an abstract class with a value around it, and not an alternative of a variant.

/// The kind that a scene has chosen. Copies are deep. Empty: the scene does not say, and reading it fills in the usual.
template <class Kind>
class Chosen {
 public:
  Chosen() = default;
  Chosen(const Kind& kind) : kind_(kind.clone()) {}  // NOLINT(google-explicit-constructor)
  Chosen(const Chosen& other) : kind_(other.kind_ ? other.kind_->clone() : nullptr) {}
  Chosen(Chosen&&) noexcept = default;
  Chosen& operator=(const Chosen& other) { return *this = Chosen(other); }
  Chosen& operator=(Chosen&&) noexcept = default;
  ~Chosen() = default;

  explicit operator bool() const { return kind_ != nullptr; }
  const Kind& operator*() const { return *checked(); }
  const Kind* operator->() const { return checked(); }
  Kind* operator->() { return checked(); }

  /// The kind as what it is; null if it is another.
  template <class Special>
  const Special* as() const {
    return dynamic_cast<const Special*>(kind_.get());
  }

 private:
  Kind* checked() const {
    REPOSE_ASSERT(kind_ != nullptr);
    return kind_.get();
  }

  std::unique_ptr<Kind> kind_;
};

/// What every kind has.
template <class Kind>
class AnyKind {
 public:
  using Root = Kind;

  virtual ~AnyKind() = default;
  virtual std::string_view name() const = 0;   ///< as in the scene
  virtual std::string_view about() const = 0;  ///< a few words for messages and the reference
  virtual std::unique_ptr<Kind> clone() const = 0;
};

/// Gives the struct `Self` its name and meaning, which are `Self::kind` and `Self::meaning`, and copies of itself.
template <class Self, class Parent>
struct KindOf : Parent {
  std::string_view name() const override { return Self::kind; }
  std::string_view about() const override { return Self::meaning; }
  std::unique_ptr<typename Parent::Root> clone() const override {
    return std::make_unique<Self>(static_cast<const Self&>(*this));
  }
};

inline constexpr auto any_kind = [](const auto&) { return true; };

/// The kinds that a scene can choose from, in the order of messages and of the reference.
template <class Kind>
class Kinds {
 public:
  explicit Kinds(std::vector<Chosen<Kind>> built_in) : all_(std::move(built_in)) {}

  /// Adds a kind. Call this before any scene is read; one of the same name is replaced.
  void add(const Kind& kind) {
    for (auto& one : all_) {
      if (one->name() == kind.name()) return void(one = kind);
    }
    all_.emplace_back(kind);
  }

  const std::vector<Chosen<Kind>>& all() const { return all_; }

  /// A kind with its defaults; empty if there is none of that name. Where kinds of two dimensions share a name it is
  /// the one that `suits` accepts.
  template <class Suits = decltype(any_kind)>
  Chosen<Kind> make(std::string_view name, const Suits& suits = any_kind) const {
    Chosen<Kind> other;
    for (const auto& one : all_) {
      if (one->name() != name) continue;
      if (suits(*one)) return one;
      if (!other) other = one;
    }
    return other;
  }

 private:
  std::vector<Chosen<Kind>> all_;
};

/// The key that chooses among the kinds that `suits` accepts. Where only one does there is nothing to choose, and no
/// key.
template <class Kind, class Suits>
void kind_key(std::string_view key, Chosen<Kind>& chosen, const Kinds<Kind>& kinds, const Suits& suits,
              const DefaultOf<std::string_view>& fallback, std::string_view about, Parameters& keys) {
  std::vector<Word> words;
  for (const auto& kind : kinds.all()) {
    if (suits(*kind)) words.emplace_back(kind->name(), kind->about());
  }
  std::string name(chosen ? chosen->name() : "");
  if (words.size() == 1 && name.empty()) name = words.front().name;
  if (words.size() > 1 || name != words.front().name) keys.choice(key, name, fallback, words, about);
  if (!chosen || chosen->name() != name) chosen = kinds.make(name, suits);
}

}  // namespace repose
