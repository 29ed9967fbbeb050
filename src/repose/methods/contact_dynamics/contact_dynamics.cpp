// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/contact_dynamics.hpp"

#include "repose/methods/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace repose {

namespace {

/// Fast grains list all grains that they may reach within this many steps.
constexpr double look_ahead_steps = 16.0;

/// Contacts are searched within 0.05 roll radii (the roll radius is at most half the sum of the radii), and within the
/// distance that grains may fall.
constexpr double cutoff = 1.0 + 0.5 * contact_dynamics::margin_of_radius;

/// Settled grains move slower than this fraction of gravity times the time step.
constexpr double settled_speed = 0.1;

/// The distance [L] that gravity may add to a contact in a step.
template <int D>
double fall_of(const ContactDynamicsSettings<D>& settings) {
  return contact_dynamics::margin_of_fall * magnitude(settings.gravity) * settings.time_step * settings.time_step;
}

/// Half of this skin [L] may be used up by each body of a pair before the lists are built again.
template <int D>
double skin_of(const ContactDynamicsSettings<D>& settings) {
  return settings.skin + fall_of(settings);
}

template <int D>
PairReach reach_of(const ContactDynamicsSettings<D>& settings) {
  return {cutoff, skin_of(settings), look_ahead_steps * settings.time_step, magnitude(settings.gravity), false};
}

}  // namespace

template <int D>
ContactDynamics<D>::ContactDynamics(ImpulseLaws laws, ContactDynamicsSettings<D> settings)
    : laws_(std::move(laws)),
      settings_(std::move(settings)),
      pairs_(reach_of(settings_)),
      solver_(settings_.solver),
      impacts_(settings_.solver),
      walls_(settings_.walls.size()),
      crossings_(settings_.walls.size()),
      wall_impulses_(settings_.walls.size()) {
  REPOSE_ASSERT(settings_.time_step > 0.0);
  for (const auto& wall : settings_.walls) problem_.wall_direction.push_back(wall.motion.direction);
  problem_.velocity_scale = magnitude(settings_.gravity) * settings_.time_step;
}

template <int D>
bool ContactDynamics<D>::step(Grains<D>& grains, Team& team) {
  pose(grains, team);
  solve(team);
  const auto stage = this->in_stage("motion");
  add_reactions(grains);
  const bool fine = move(grains);
  contact_dynamics::name_walls(problem_);
  return fine;
}

/// Sets up the contact problem of the step.
template <int D>
void ContactDynamics<D>::pose(Grains<D>& grains, Team& team) {
  refresh_pairs(grains, team);
  set_free_velocities(grains);
  find_contacts(grains);
  collide(grains);
}

template <int D>
StepReport ContactDynamics<D>::advance(Grains<D>& grains, double until, Team& team) {
  const long before = step_;
  const long last = time_steps().count(until);
  bool trouble = false;
  while (step_ < last && !trouble) trouble = !step(grains, team);
  return {time(), step_ - before, trouble};
}

template <int D>
const contact_dynamics::Problem<D>* ContactDynamics<D>::problem_at(double time, Grains<D>& grains, Team& team) {
  step_ = time_steps().count(time);
  // The impulses of the step before are part of the problem, whether or not a run would start from them.
  const auto start = std::exchange(settings_.warm_start, WarmStart::always);
  pose(grains, team);
  settings_.warm_start = start;
  return &problem_;
}

/// The list must hold until the end of the step, when grains may touch that are far apart now.
template <int D>
void ContactDynamics<D>::refresh_pairs(Grains<D>& grains, Team& team) {
  const auto stage = this->in_stage("pair lists");
  const double dt = settings_.time_step;
  double fastest2 = 0.0;
  for (const auto& grain : grains.line) fastest2 = std::max(fastest2, squared(grain.velocity));
  double wall_displacement = 0.0;
  for (std::size_t w = 0; w < walls_at_build_.size(); ++w) {
    const auto& wall = settings_.walls[w];
    const double so_far = farthest_moved(wall, walls_[w].displacement - walls_at_build_[w].displacement);
    wall_displacement = std::max(wall_displacement, so_far + dt * farthest_moved(wall, walls_[w].speed));
  }
  pairs_.moved(dt * std::sqrt(fastest2) + turned_);
  if (pairs_.may_be_stale() && pairs_.stale(grains, wall_displacement, dt)) build_pairs(grains, team);
}

template <int D>
void ContactDynamics<D>::build_pairs(Grains<D>& grains, Team& team) {
  const auto order = pairs_.build(grains, settings_.box, team);
  contact_dynamics::renumber(order, known_, problem_.contacts);
  known_ = grains.size();
  crossings_.check(grains, settings_.walls, walls_now(), settings_.box, time());
  walls_at_build_ = walls_;
  near_walls_.invalidate();
}

/// The margin of contacts and the kick of a step may each be as long as a fall.
template <int D>
void ContactDynamics<D>::refresh_near_walls(const Grains<D>& grains, const std::vector<WallNow<D>>& walls) {
  const double skin = skin_of(settings_);
  if (near_walls_.hold(settings_.walls, walls_, settings_.time_step, skin)) return;
  near_walls_.build(grains, settings_.walls, walls_, walls, settings_.box, pairs_, cutoff,
                    0.5 * skin + 2.0 * fall_of(settings_));
}

/// In the first step velocities are those at the time of the positions, unless the state is that of a former run with
/// the impulses of its last step.
template <int D>
contact_dynamics::StepTimes ContactDynamics<D>::times() const {
  const double dt = settings_.time_step;
  return {step_ > 0 || follows_ ? 0.5 * dt : 0.0, dt};
}

template <int D>
void ContactDynamics<D>::set_free_velocities(const Grains<D>& grains) {
  const auto stage = this->in_stage("free velocities");
  const double kick = times().kick();
  problem_.free.clear();
  for (const auto& grain : grains.line) {
    problem_.free.push_back({grain.velocity, grain.rim_velocity, grain.inverse_mass});
    if (!grain.fixed()) problem_.free.back().velocity += settings_.gravity * kick;
  }
  for (const auto& load : loads_) {
    const auto found = std::find(grains.id.begin(), grains.id.end(), load.grain);
    if (found == grains.id.end()) continue;
    auto& body = problem_.free[static_cast<std::size_t>(found - grains.id.begin())];
    body.velocity += load.force * (kick * body.inverse_mass);
  }
  limit_speeds();
  problem_.first_wall = problem_.free.size();
  problem_.pistons = false;
  for (std::size_t w = 0; w < walls_.size(); ++w) set_free_wall(w, kick);
}

/// Limits the free velocities only, never the velocities after the contacts, which must obey the contact laws.
template <int D>
void ContactDynamics<D>::limit_speeds() {
  if (!std::isfinite(settings_.speed_limit)) return;
  for (auto& body : problem_.free) {
    const double speed = magnitude(body.velocity);
    if (speed > settings_.speed_limit) body.velocity *= settings_.speed_limit / speed;
  }
}

/// A piston is a body that moves along one direction. Its spring and drag act at the end of the step (implicit Euler,
/// stable for any stiffness), which has the effect of a larger mass.
template <int D>
void ContactDynamics<D>::set_free_wall(std::size_t w, double kick) {
  const auto& motion = settings_.walls[w].motion;
  auto& state = walls_[w];
  double inverse_mass = 0.0;
  if (!motion.feels_grains() || !motion.going(time())) {
    kick_wall(motion, state, time(), kick, settings_.time_step, Vec<D>{});
  } else {
    const double end = time() + settings_.time_step - motion.start;
    const double pull = motion.force + motion.stiffness * (motion.speed * end - state.displacement);
    inverse_mass = 1.0 / (motion.mass + kick * (motion.drag + motion.stiffness * settings_.time_step));
    state.speed = inverse_mass * (motion.mass * state.speed + kick * pull);
    problem_.pistons = true;
  }
  problem_.free.push_back({motion.direction * state.speed, Spin<D>{}, inverse_mass});
}

template <int D>
void ContactDynamics<D>::find_contacts(const Grains<D>& grains) {
  const auto stage = this->in_stage("contact search");
  std::swap(before_, problem_.contacts);
  // The first step of a fresh run has half a kick; its impulses are half of those of the steps that follow.
  if (step_ == 1 && !follows_) {
    for (auto& c : before_) c.impulse = c.impulse * 2.0;
  }
  forget_impulses(grains);
  const auto walls = walls_now();
  problem_.surface_of.clear();
  problem_.wall_direction.resize(settings_.walls.size());
  refresh_near_walls(grains, walls);
  contact_dynamics::gather<D>({laws_, settings_, walls, near_walls_}, grains, pairs_, before_, problem_, collisions_);
}

/// Drops the contacts of the previous step whose impulses are no start for this one.
template <int D>
void ContactDynamics<D>::forget_impulses(const Grains<D>& grains) {
  if (settings_.warm_start == WarmStart::always) return;
  if (settings_.warm_start == WarmStart::never) return before_.clear();
  const double fastest = settled_speed * magnitude(settings_.gravity) * settings_.time_step;
  const auto settled = [&](std::uint32_t body) {
    if (body >= grains.size()) return true;  // a wall
    const auto& grain = grains.line[body];
    return magnitude(grain.velocity) <= fastest && magnitude(grain.rim_velocity) <= fastest;
  };
  std::erase_if(before_, [&](const auto& c) { return !settled(c.first) || !settled(c.second); });
}

/// Lets impacts act on the free velocities.
template <int D>
void ContactDynamics<D>::collide(const Grains<D>& grains) {
  const auto stage = this->in_stage("impacts");
  std::vector<contact_dynamics::Body<D>> before;
  if (!collisions_.closing.empty()) {
    for (const auto& grain : grains.line) before.push_back({grain.velocity, grain.rim_velocity, grain.inverse_mass});
    before.insert(before.end(), problem_.free.begin() + static_cast<std::ptrdiff_t>(grains.size()),
                  problem_.free.end());
  }
  const auto report = impacts_.act(before, times(), collisions_, problem_);
  account_.sweeps += report.solution.sweeps;
  account_.contact_iterations += 2 * report.contact_sweeps;
  account_.impacts += report.impacts;
  account_.reduced += report.reduced;
  account_.restitution_lost += report.restitution_lost;
  impacts_converged_ = report.solution.converged;
}

template <int D>
void ContactDynamics<D>::solve(Team& team) {
  const auto stage = this->in_stage("solver");
  solution_ = solver_.solve(problem_, team);
  const auto without_recovery = [&] {
    auto plain = problem_;
    for (auto& c : plain.contacts) c.normal_bias = std::max(0.0, c.normal_bias);
    return plain;
  };
  if (contact_dynamics::ran_away(problem_)) {
    // Where friction jams an overlapping grain, no impulses may push it out.
    problem_ = without_recovery();
    for (auto& c : problem_.contacts) c.impulse = {};
    const auto again = solver_.solve(problem_, team);
    solution_ = {solution_.sweeps + again.sweeps, again.residual, again.converged};
  }
  advancing_ = problem_.bodies;
  if (contact_dynamics::gains_energy(problem_)) {
    // Overlaps are pushed apart by a displacement. Its velocity does not stay.
    auto plain = without_recovery();
    const auto recovers = [](const auto& c) { return c.normal_bias < 0.0; };
    if (std::any_of(problem_.contacts.begin(), problem_.contacts.end(), recovers)) {
      account_.sweeps += solver_.solve(plain, team).sweeps;
    }
    contact_dynamics::take_back_gains(plain);
    problem_.bodies = plain.bodies;
  }
  ++account_.steps;
  account_.sweeps += solution_.sweeps;
  account_.contact_iterations += 2 * solution_.sweeps * static_cast<long>(problem_.contacts.size());
  account_.unconverged += solution_.converged && impacts_converged_ ? 0 : 1;
  account_.worst_residual = std::max(account_.worst_residual, solution_.residual);
}

/// The impulse of a contact in the last step, that of impacts included.
template <int D>
contact_dynamics::Impulse<D> ContactDynamics<D>::impulse_of(std::size_t contact) const {
  auto impulse = problem_.contacts[contact].impulse;
  if (!impacts_.impulses().empty()) impulse += impacts_.impulses()[contact];
  return impulse;
}

/// Adds the contact impulses to the reactions of fixed grains and walls.
template <int D>
void ContactDynamics<D>::add_reactions(Grains<D>& grains) {
  for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
    const auto& c = problem_.contacts[k];
    const auto both = impulse_of(k);
    const Vec<D> impulse = c.normal * both.normal + in_space(both.tangent, c.normal);
    if (problem_.free[c.first].inverse_mass == 0.0) grains.reaction[c.first] += impulse;
    if (c.second >= grains.size()) {
      const auto w = problem_.wall_of(c.second);
      wall_impulses_[w] -= impulse;
      walls_[w].work += contact_dynamics::driven_work(c, both, problem_.bodies[c.second]);
    } else if (problem_.free[c.second].inverse_mass == 0.0) {
      grains.reaction[c.second] -= impulse;
    }
  }
}

/// Returns false if a grain moves by more than its radius, or if a velocity is not a number.
template <int D>
bool ContactDynamics<D>::move(Grains<D>& grains) {
  const double dt = settings_.time_step;
  bool fine = true;
  const auto& turned = impacts_.displacements(times(), problem_, advancing_);
  turned_ = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    auto& grain = grains.line[i];
    if (grain.fixed()) continue;
    grain.velocity = problem_.bodies[i].velocity;
    grain.rim_velocity = problem_.bodies[i].rim_velocity;
    grain.position += advancing_[i].velocity * dt;
    if (!turned.empty()) {
      grain.position += turned[i];
      turned_ = std::max(turned_, magnitude(turned[i]));
    }
    turned_ = std::max(turned_, magnitude(Vec<D>(advancing_[i].velocity - grain.velocity)) * dt);
    const double displacement = magnitude(advancing_[i].velocity) * dt;
    fine &= displacement <= grain.radius && std::isfinite(magnitude(grain.rim_velocity));
  }
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    auto& wall = walls_[w];
    const auto& body = problem_.bodies[grains.size() + w];
    if (body.inverse_mass > 0.0) wall.speed = dot(body.velocity, settings_.walls[w].motion.direction);
    const auto& advancing = advancing_[grains.size() + w];
    wall.displacement +=
        (body.inverse_mass > 0.0 ? dot(advancing.velocity, settings_.walls[w].motion.direction) : wall.speed) * dt;
  }
  ++step_;
  return fine;
}

template <int D>
std::vector<WallNow<D>> ContactDynamics<D>::walls_now() const {
  std::vector<WallNow<D>> all;
  for (std::size_t w = 0; w < walls_.size(); ++w) all.push_back(wall_now(settings_.walls[w], walls_[w], time()));
  return all;
}

template <int D>
void ContactDynamics<D>::grains_added(Grains<D>&) {
  pairs_.invalidate();
}

template <int D>
void ContactDynamics<D>::refresh(Grains<D>& grains, Team& team) {
  const auto stage = this->in_stage("pair lists");
  pairs_.invalidate();
  build_pairs(grains, team);
}

template <int D>
Contacts<D> ContactDynamics<D>::contacts(const Grains<D>& grains) const {
  Contacts<D> contacts;
  // The last step is the one before `step_`; the first of a fresh run has half a kick.
  const double rate = 1.0 / (step_ > 1 || follows_ ? settings_.time_step : 0.5 * settings_.time_step);
  const auto walls = walls_now();
  for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
    const auto& c = problem_.contacts[k];
    const auto impulse = impulse_of(k);
    if (!(impulse.normal > 0.0) || c.first >= grains.size()) continue;
    const bool with_wall = c.second >= known_;
    const bool swap = !with_wall && grains.id[c.second] < grains.id[c.first];
    const auto first = swap ? c.second : c.first;
    const auto w = c.second - known_;
    auto contact = with_wall ? contact_with_wall(grains, first, settings_.walls, w, walls[w], settings_.box)
                             : contact_of_grains(grains, first, swap ? c.first : c.second, settings_.box);
    contact.first_lever = c.lever * grains.line[first].radius;
    const double limit = friction_limit(c.friction, impulse.normal);
    contact.normal_force = impulse.normal * rate;
    contact.tangential_force = (swap ? swapped(impulse.tangent) : impulse.tangent) * rate;
    contact.rolling = (swap ? -impulse.roll : impulse.roll) * rate;
    contact.sliding = limit > 0.0 && magnitude(impulse.tangent) >= limit * (1.0 - 1e-9);
    contacts.list.push_back(contact);
  }
  contacts.sort();
  return contacts;
}

template <int D>
void ContactDynamics<D>::set_slip_displacements(const Grains<D>& grains, const Contacts<D>& contacts) {
  std::map<std::int64_t, std::uint32_t> place;
  for (std::uint32_t k = 0; k < grains.size(); ++k) place[grains.id[k]] = k;
  problem_.contacts.clear();
  follows_ = !contacts.list.empty();
  for (const auto& contact : contacts.list) {
    const auto first = place.find(contact.first);
    const auto second = place.find(contact.second);
    if (first == place.end() || (contact.second >= 0 && second == place.end())) continue;
    contact_dynamics::ContactLine<D> line;
    line.first = first->second;
    line.second = contact.second >= 0
                      ? second->second
                      : static_cast<std::uint32_t>(static_cast<std::int64_t>(grains.size()) - 1 - contact.second);
    line.normal = contact.normal;
    line.impulse.normal = contact.normal_force * settings_.time_step;
    line.impulse.tangent = contact.tangential_force * settings_.time_step;
    line.impulse.roll = contact.rolling * settings_.time_step;
    problem_.contacts.push_back(line);
  }
  // Sorts the contacts, and reverses those that are listed in the other direction.
  std::vector<std::uint32_t> same(grains.size());
  for (std::uint32_t k = 0; k < grains.size(); ++k) same[k] = k;
  contact_dynamics::renumber(same, grains.size(), problem_.contacts);
}

template <int D>
std::vector<Vec<D>> ContactDynamics<D>::take_wall_impulses() {
  return std::exchange(wall_impulses_, std::vector<Vec<D>>(walls_.size()));
}

template <int D>
void ContactDynamics<D>::exchange(Archive& archive) {
  archive.value("step", step_);
  archive.value("known", known_);
  archive.array("walls/state", walls_);
  archive.array("walls/at_build", walls_at_build_);
  archive.array("walls/impulse", wall_impulses_);
  archive.array("loads/list", loads_);
  archive.value("follows", follows_);
  archive.value("impacts/turned", turned_);
  archive.array("contacts", problem_.contacts);
  impacts_.exchange(archive);
  archive.value("solver/account", account_);
  archive.value("solver/last", solution_);
  pairs_.exchange(archive);
  near_walls_.invalidate();
  crossings_.exchange(archive);
  for (const auto& c : problem_.contacts) {
    archive.check("contacts", c.first < known_ && c.second < known_ + walls_.size() && c.first < c.second);
  }
  const auto rebounds = impacts_.impulses().size();
  archive.check("impacts/impulses", rebounds == 0 || rebounds == problem_.contacts.size());
}

template class ContactDynamics<2>;
template class ContactDynamics<3>;

}  // namespace repose
