// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/contact_problem/contact_problem_groups.hpp"

#include <tuple>

namespace repose {

const Group<std::vector<BodyRow>>& body_group() {
  static const Group<std::vector<BodyRow>> group{
      "bodies",
      "N",
      {},
      {
          column("id", &BodyRow::id, "", "id of the grain; -1 - k: wall k"),
          column("mass", &BodyRow::mass, "M", "infinite: contacts do not move the body"),
          column("inertia", &BodyRow::inertia, "M L^2",
                 "moment of inertia, m r^2 / 2 of a disc; infinite as the mass is"),
          column("radius", &BodyRow::radius, "L", "0 of a wall"),
          column("position", &BodyRow::position, "L", "centre, or a point of the wall; for pictures"),
          column("free_velocity", &BodyRow::free_velocity, "L/T, L/T, 1/T",
                 "vx, vy and angular velocity after the step if no contact acted"),
      }};
  return group;
}

const Group<std::vector<ContactRow>>& contact_group() {
  using Row = ContactRow;
  static const Group<std::vector<Row>> group{
      "contacts",
      "M",
      {},
      {
          column<Row>(
              "bodies", [](auto& row) { return std::tie(row.first, row.second); }, "",
              "rows of the first and the second body; not both of infinite mass"),
          column("normal", &Row::normal, "", "unit normal from the second to the first; the tangent is (-ny, nx)"),
          column(
              "arms", &Row::arms, "L",
              "from the centre of the first and of the second to the contact point, the same fraction of both radii"),
          column("roll_radius", &Row::roll_radius, "L",
                 "torque impulse over rolling impulse: 2 r1 r2 / (r1 + r2), or r1 where the second is a wall"),
          column("normal_bias", &Row::normal_bias, "L/T", "b_n, added to the normal velocity after the step"),
          column("tangential_bias", &Row::tangential_bias, "L/T",
                 "b_t, added to the tangential velocity after the step"),
          column("friction", &Row::friction, "", "tangential over normal impulse at most, >= 0; may be infinite"),
          column("rolling_friction", &Row::rolling_friction, "",
                 "rolling over normal impulse at most, >= 0; may be infinite"),
          column("impulse", &Row::impulse, "M L/T",
                 "normal, tangential and rolling impulse on the first body to start from, those of the step before"),
      }};
  return group;
}

std::vector<ReferenceTable> contact_problem_reference() {
  return {reference_of("bodies", "/bodies/", body_group().rows, body_group().columns),
          reference_of("contacts", "/contacts/", contact_group().rows, contact_group().columns)};
}

}  // namespace repose
