// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/contact_problem/contact_problem.hpp"
#include "repose/core/vec.hpp"
#include "repose/determinacy/linear_programme.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// Forces of all contacts of a problem on their first bodies. `roll` is the torque over the roll radius.
using ContactForces = std::vector<contact_dynamics::Impulse<2>>;

/// A sum of parts of contact forces, such as the force on a base grain.
struct ForceSum {
  struct Term {
    std::size_t contact = 0;
    double normal = 0.0;   ///< factor of the normal force
    double tangent = 0.0;  ///< factor of the tangential force
  };
  std::vector<Term> terms;

  void add(const ForceSum& other, double factor);
  double operator()(const ContactForces& forces) const;
};

/// The part along `direction` of the force on a body.
ForceSum force_on_body(const contact_dynamics::Problem<2>& problem, std::size_t body, const Vec<2>& direction);

/// The same of one contact of it.
ForceSum::Term force_on_body(const contact_dynamics::Problem<2>& problem, std::size_t contact, std::size_t body,
                             const Vec<2>& direction);

/// What decides which forces are in equilibrium.
struct EquilibriumInput {
  const contact_dynamics::Problem<2>& problem;
  std::vector<std::size_t> touching;  ///< contacts that may carry force
  std::vector<Vec<2>> outer;          ///< force from outside on each body
  double margin = 0.0;  ///< by which the balance of a grain may be missed, beside what the recorded forces miss
};

/// All forces of rigid grains at rest: each contact force in its cone of friction and rolling friction, and each grain
/// that touches another in balance. The unknowns of the programme are factors of the edges of the cones, so that cones
/// need no rows. See docs/physics/force_range.md.
class Equilibrium {
 public:
  /// Balance is missed by as much as `recorded` misses it, grain by grain. The torques of rolling friction are
  /// those that miss it least.
  Equilibrium(const EquilibriumInput& input, const ContactForces& recorded);

  std::size_t unknowns() const { return unknowns_; }
  std::size_t equations() const { return equations_; }
  /// The largest net force on a grain, or net torque over its radius, of the recorded forces.
  double unbalanced() const { return unbalanced_; }

  /// The recorded forces, cut to the limits of friction; they are among the states of equilibrium.
  const ContactForces& recorded() const { return recorded_; }

  struct Extreme {
    LinearProgramme::End end = LinearProgramme::End::failed;
    double value = 0.0;
    ContactForces forces;
  };
  Extreme least(const ForceSum& sum) { return extreme(sum, false); }
  Extreme most(const ForceSum& sum) { return extreme(sum, true); }

  /// Whether no force that its law allows makes the sum negative, in equilibrium or not.
  bool never_negative(const ForceSum& sum) const;

  /// The least value that the largest of these sums can have.
  Extreme least_of_largest(const std::vector<ForceSum>& sums) const;

 private:
  /// A direction of the force of a contact: an edge of its cone.
  struct Edge {
    std::size_t contact = 0;
    contact_dynamics::Impulse<2> direction;
    bool both_ways = false;  ///< infinite friction has no limit on either side
  };

  void add_edges(std::size_t contact);
  void number_rows();
  std::vector<LinearProgramme::Entry> entries_of(const Edge& edge) const;
  std::vector<double> missed(const ContactForces& forces) const;
  void take_recorded(const ContactForces& recorded);
  void find_torques();
  std::vector<double> costs_of(const ForceSum& sum) const;
  ContactForces forces_of(const std::vector<double>& factors) const;
  Extreme extreme(const ForceSum& sum, bool largest);

  EquilibriumInput input_;
  std::size_t unknowns_ = 0;
  std::size_t equations_ = 0;
  double unbalanced_ = 0.0;
  std::vector<Edge> edges_;
  std::vector<std::size_t> first_row_;  // of each body; `none` for a body without
  std::vector<double> load_;            // of each row: what contacts must balance
  std::vector<LinearProgramme::Column> columns_;
  std::vector<LinearProgramme::Row> rows_;
  ContactForces recorded_;
  std::unique_ptr<LinearProgramme> programme_;
};

}  // namespace repose
