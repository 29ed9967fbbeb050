// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/contact_problem/contact_solution.hpp"

#include "repose/core/version.hpp"
#include "repose/io/hdf5_file.hpp"

#include <ctime>
#include <vector>

namespace repose {

namespace {

/// CPU time of this thread [s].
double cpu_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

ContactSolution solve(ContactProblem& posed, const contact_dynamics::SolverSettings& settings, bool warm) {
  auto& problem = posed.problem;
  if (!warm) {
    for (auto& c : problem.contacts) c.impulse = {};
  }
  ContactSolution done;
  done.settings = settings;
  done.warm = warm;
  const double start = cpu_time();
  contact_dynamics::Solver<2> solver(settings);
  done.solution = solver.solve(problem);
  done.cpu_seconds = cpu_time() - start;
  done.residual = residual(problem, problem.bodies);
  return done;
}

void write_contact_solution(const std::string& path, const ContactProblem& solved, const ContactSolution& done) {
  std::vector<double> impulse;
  for (const auto& c : solved.problem.contacts) {
    impulse.insert(impulse.end(), {c.impulse.normal, c.impulse.tangent, c.impulse.roll});
  }
  std::vector<double> velocity;
  for (std::size_t k = 0; k < solved.problem.bodies.size(); ++k) {
    const auto& body = solved.problem.bodies[k];
    const double radius = solved.places[k].radius;
    velocity.insert(velocity.end(),
                    {body.velocity[0], body.velocity[1], radius > 0.0 ? body.rim_velocity / radius : 0.0});
  }
  Hdf5File file(path);
  file.attribute("/", "format", std::string("repose-contact-solution"));
  file.attribute("/", "format_version", std::int64_t{1});
  file.attribute("/", "repose_version", std::string(version));
  file.attribute("/", "solver", std::string(done.settings.accelerated ? "accelerated" : "sweeps"));
  file.attribute("/", "start", std::string(done.warm ? "warm" : "cold"));
  file.attribute("/", "tolerance", done.settings.tolerance);
  file.attribute("/", "most_sweeps", static_cast<std::int64_t>(done.settings.most_sweeps));
  file.attribute("/", "sweeps", static_cast<std::int64_t>(done.solution.sweeps));
  file.attribute("/", "contact_iterations", ContactSolution::contact_iterations(solved, done.solution));
  file.attribute("/", "cpu_seconds", done.cpu_seconds);
  file.attribute("/", "converged", std::int64_t{done.solution.converged ? 1 : 0});
  file.attribute("/", "residual", done.residual.worst());
  file.attribute("/", "residual_normal", done.residual.normal);
  file.attribute("/", "residual_tangential", done.residual.tangential);
  file.attribute("/", "residual_rolling", done.residual.rolling);
  file.attribute("/", "complementarity", done.residual.complementarity);
  file.dataset("impulse", impulse, 3, "M L/T",
               "normal, tangential and rolling impulse on the first body of each contact");
  file.dataset("velocity", velocity, 3, "L/T, L/T, 1/T", "vx, vy and angular velocity of each body after the step");
  file.commit();
}

}  // namespace repose
