// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/stability/record_springs.hpp"

#include "repose/laws/any_law.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace repose {

namespace {

/// A tangential force below this is rounding [normal force].
constexpr double no_friction = 1e-9;

/// The place of the second partner; none for a wall.
std::optional<std::size_t> second_place(const Record<2>& record, const Contact<2>& contact) {
  return contact.second < 0 ? std::nullopt : record.grains.find(contact.second);
}

std::size_t wall_number(const Contact<2>& contact) { return static_cast<std::size_t>(-1 - contact.second); }

/// The laws between the partners of a contact.
const ContactLaws& laws_between(const MaterialLaws& laws, const Record<2>& record, const Contact<2>& contact) {
  const auto& material = record.grains->material;
  const auto second = second_place(record, contact);
  const std::size_t a = material[*record.grains.find(contact.first)];
  const std::size_t b = second ? material[*second] : record.walls[wall_number(contact)].wall.material;
  return laws.table[a * laws.materials + b];
}

/// The contact as its law sees it, at rest.
Touch<double> touch_of(const Record<2>& record, const Contact<2>& contact, double reach) {
  const auto& first = record.grains->line[*record.grains.find(contact.first)];
  const auto place = second_place(record, contact);
  const auto& second = place ? record.grains->line[*place] : first;  // a wall counts as a grain of the same size
  const double diameter = first.radius + second.radius;
  const double distance = diameter - contact.overlap;
  const double mass = 2.0 / (1.0 / first.mass + 1.0 / second.mass);
  auto touch = make_touch(distance, 1.0 / distance, diameter, reach * diameter, 0.0, mass);
  touch.effective_radius = place ? first.radius * second.radius / diameter : first.radius;
  return touch;
}

double stiffness_of(const ContactLaws& laws, const Record<2>& record, const Contact<2>& contact) {
  const auto touch = touch_of(record, contact, reach(AnyNormal{laws.normal}));
  return normal_force(AnyNormal{at_radius(laws.normal, touch.effective_radius)}, touch).stiffness;
}

bool has_friction(const ContactLaws& laws) {
  return coulomb_limit(AnyTangential{laws.tangential}, NormalForce<double>{1.0, 1.0, 1.0}) > 0.0;
}

}  // namespace

std::string reason_without_springs(const Record<2>& record) {
  const auto& scene = record.scene;
  if (record.facts.status == Status::failed) return "the run failed: its last state is not to be trusted";
  const auto resting = scene.method->resting_contacts(scene);
  if (!scene.method->traits().force_laws && !resting) return "contacts have no stiffness with this method";
  if (std::any_of(record.walls.begin(), record.walls.end(),
                  [](const auto& w) { return w.wall.motion.kind != WallMotion<2>::Kind::none; })) {
    return "a wall moves";
  }
  const auto has_tangential_force = [](const Contact<2>& contact) {
    return std::fabs(contact.tangential_force) > no_friction * std::fabs(contact.normal_force);
  };
  if (!resting) {
    const auto laws = scene.material_laws();
    for (const auto& one : laws.table) {
      if (!std::holds_alternative<NoCohesion>(one.cohesion)) return "contacts attract each other";
    }
  }
  for (const auto& contact : record.contacts.list) {
    if (!has_tangential_force(contact)) continue;
    if (contact.second >= 0) return "grains have friction: the matrix has normal forces alone";
    if (resting && !resting->pinned) {
      return "static friction of a wall follows the normal force and is no spring: pin the grains (method.pin_base)";
    }
  }
  return "";
}

std::vector<ContactSpring> springs_of(const Record<2>& record) {
  const auto resting = record.scene.method->resting_contacts(record.scene);
  const auto laws = resting ? MaterialLaws{} : record.scene.material_laws();
  const auto stiffness = [&](const Contact<2>& contact) {
    return resting ? resting->stiffness : stiffness_of(laws_between(laws, record, contact), record, contact);
  };
  const auto wall_holds = [&](const Contact<2>& contact) {
    return resting ? resting->pinned : !contact.sliding && has_friction(laws_between(laws, record, contact));
  };
  const auto moves = [&](std::size_t place) { return !record.grains->line[place].fixed(); };
  std::vector<ContactSpring> springs;
  for (const auto& contact : record.contacts.list) {
    if (!(contact.normal_force > 0.0)) continue;
    const auto first = *record.grains.find(contact.first);
    const auto second = second_place(record, contact);
    ContactSpring spring{first, ContactSpring::nothing, contact.normal};
    spring.stiffness = stiffness(contact);
    spring.force = contact.normal_force;
    if (second) {
      spring.distance = record.grains->line[first].radius + record.grains->line[*second].radius - contact.overlap;
    }
    if (moves(first)) {
      if (second && moves(*second)) spring.second = *second;
      spring.holds = !second && wall_holds(contact);
    } else if (second && moves(*second)) {
      spring.first = *second;
      spring.normal = -contact.normal;
    } else {
      continue;
    }
    springs.push_back(spring);
  }
  return springs;
}

}  // namespace repose
