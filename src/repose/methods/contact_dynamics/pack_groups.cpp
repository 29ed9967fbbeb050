// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/pack_groups.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <utility>

namespace repose::contact_dynamics {

namespace {

/// A part is large compared with its border, and a sweep over it takes far longer than threads need to meet.
constexpr std::size_t fewest_contacts_of_part = 2048;
constexpr std::size_t fewest_parts = 4;
constexpr std::size_t most_parts = 32;  // whose borders need fewer than 64 colours, however they are connected

/// Finds the part of each contact, and of the other side if it is a border.
class Parts {
 public:
  Parts(const Problem<2>& problem, std::size_t parts) : problem_(problem) {
    // As many contacts in each part, if contacts are in the order of their first bodies.
    const auto count = problem.contacts.size();
    for (std::size_t part = 1; part < parts; ++part) start_.push_back(problem.contacts[count * part / parts].first);
    std::sort(start_.begin(), start_.end());
  }

  std::pair<std::size_t, std::size_t> of(const ContactLine<2>& c) const {
    const auto of_first = of_body(moves(c.first) ? c.first : c.second);
    const auto of_second = of_body(moves(c.second) ? c.second : c.first);
    return {std::min(of_first, of_second), std::max(of_first, of_second)};
  }

 private:
  bool moves(std::uint32_t body) const { return problem_.free[body].inverse_mass > 0.0; }
  std::size_t of_body(std::uint32_t body) const {
    return static_cast<std::size_t>(std::upper_bound(start_.begin(), start_.end(), body) - start_.begin());
  }

  const Problem<2>& problem_;
  std::vector<std::uint32_t> start_;  // first bodies of the parts after the first
};

}  // namespace

std::size_t parts_of(std::size_t contacts) {
  const auto parts = std::bit_floor(contacts / fewest_contacts_of_part);
  return parts < fewest_parts ? 1 : std::min(parts, most_parts);
}

PackGroups group_contacts(const Problem<2>& problem, std::size_t parts) {
  PackGroups groups;
  groups.contacts.resize(parts);
  groups.colour_start = {0, parts};
  if (parts == 1) {
    groups.contacts[0].resize(problem.contacts.size());
    std::iota(groups.contacts[0].begin(), groups.contacts[0].end(), 0U);
    return groups;
  }
  const Parts in(problem, parts);
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::uint32_t>> between;
  for (std::uint32_t k = 0; k < problem.contacts.size(); ++k) {
    const auto part = in.of(problem.contacts[k]);
    (part.first == part.second ? groups.contacts[part.first] : between[part]).push_back(k);
  }
  // Each border gets the first colour that neither of its parts has yet.
  std::vector<std::uint64_t> colours_of(parts, 0);
  std::map<int, std::vector<std::vector<std::uint32_t>>> colours;
  for (auto& [both, contacts] : between) {
    const auto taken = colours_of[both.first] | colours_of[both.second];
    const int colour = std::countr_one(taken);
    colours_of[both.first] |= std::uint64_t{1} << colour;
    colours_of[both.second] |= std::uint64_t{1} << colour;
    colours[colour].push_back(std::move(contacts));
  }
  for (auto& [colour, borders] : colours) {
    for (auto& contacts : borders) groups.contacts.push_back(std::move(contacts));
    groups.colour_start.push_back(groups.contacts.size());
  }
  return groups;
}

}  // namespace repose::contact_dynamics
