// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/contact_problem/contact_problem.hpp"

#include "repose/core/errors.hpp"
#include "repose/simulation/methods.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace repose {

namespace {

void check(const Record<2>& record) {
  const auto& scene = record.scene;
  std::vector<std::string> problems;
  const auto refuse = [&](const std::string& why) { problems.push_back("no contact problem: " + why); };
  if (scene.method->solver() == nullptr) {
    refuse(fmt::format("the method of the run is {}, and only contact-dynamics has one", scene.method->name()));
  }
  if (record.facts.status == Status::failed) refuse("the run failed: its last state is not to be trusted");
  if (std::any_of(record.walls.begin(), record.walls.end(),
                  [](const auto& w) { return w.wall.motion.kind != WallMotion<2>::Kind::none; })) {
    refuse("a wall moves; the file is for walls that stand still");
  }
  if (!scene.loads.empty()) refuse("the scene has loads, which the file does not hold");
  if (!problems.empty()) throw InputError(problems);
}

}  // namespace

ContactProblem next_contact_problem(const Record<2>& record) {
  check(record);
  return pose_contact_problem(record, {});
}

ContactProblem pose_contact_problem(const Record<2>& record, const std::vector<Load<2>>& loads) {
  const auto method = make_method(record.scene);
  auto grains = *record.grains;
  Team team(1);
  method->refresh(grains, team);
  method->set_slip_displacements(grains, record.contacts);
  method->set_loads(loads);
  const auto* problem = method->problem_at(record.facts.time, grains, team);
  REPOSE_ASSERT(problem != nullptr);

  ContactProblem posed;
  posed.title = record.scene.title;
  posed.time = record.facts.time;
  posed.time_step = record.facts.time_step;
  posed.problem = *problem;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    posed.places.push_back({grains.id[k], grains.line[k].radius, grains.line[k].position});
  }
  for (std::size_t w = 0; w < record.walls.size(); ++w) {
    posed.places.push_back({wall_partner(static_cast<std::int64_t>(w)), 0.0, record.walls[w].wall.point});
  }
  return posed;
}

}  // namespace repose
