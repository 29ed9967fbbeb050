// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/force_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace repose {

namespace {

constexpr double same_force = 1e-6;

bool is_horizontal(const Contact<2>& contact) {
  const double steepest = std::sin(horizontal_within * std::numbers::pi / 180.0);
  return contact.second >= 0 && std::fabs(contact.normal[1]) <= steepest;
}

/// Whether a contact counts: it pushes with more than the threshold.
bool pushes(const Contact<2>& contact, double threshold) {
  return contact.normal_force > threshold && std::isfinite(contact.normal_force);
}

}  // namespace

ForceLines find_force_lines(const OrderedGrains<2>& grains, const Contacts<2>& contacts, double threshold) {
  ForceLines lines;
  std::vector<std::optional<ForceLine>> of_grain(grains.size());
  const auto meet = [&](std::int64_t id, std::int64_t number, double force) {
    const auto place = grains.find(id);
    if (!place || grains->line[*place].fixed()) return;
    auto& line = of_grain[*place];
    if (!line) line = {id, number, number, force, force};
    if (force > line->strongest_force * (1.0 + same_force)) {
      line->strongest = number;
      line->strongest_force = force;
    }
    if (force < line->weakest_force * (1.0 - same_force)) {
      line->weakest = number;
      line->weakest_force = force;
    }
  };
  for (std::size_t k = 0; k < contacts.list.size(); ++k) {
    const auto& contact = contacts.list[k];
    if (!pushes(contact, threshold)) continue;
    const auto number = static_cast<std::int64_t>(k);
    meet(contact.first, number, contact.normal_force);
    if (contact.second < 0) continue;
    meet(contact.second, number, contact.normal_force);
    ++lines.contacts;
    if (!is_horizontal(contact)) continue;
    ++lines.horizontal;
    lines.largest_horizontal = std::max(lines.largest_horizontal, contact.normal_force);
  }
  const auto horizontal = [&](std::int64_t number) {
    return is_horizontal(contacts.list[static_cast<std::size_t>(number)]);
  };
  for (const auto& line : of_grain) {
    if (!line) continue;
    lines.grains.push_back(*line);
    if (horizontal(line->strongest)) ++lines.strongest_horizontal;
    if (horizontal(line->weakest)) ++lines.weakest_horizontal;
  }
  return lines;
}

}  // namespace repose
