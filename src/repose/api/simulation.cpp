// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/api/simulation.hpp"

#include "repose/api/measures_of_record.hpp"
#include "repose/run_folder/resume.hpp"
#include "repose/run_folder/run_folder.hpp"
#include "repose/simulation/simulation.hpp"

#include <fmt/format.h>

#include <atomic>
#include <utility>

namespace repose::api {

struct Simulation::State {
  State(const repose::Scene& scene, int threads) : simulation(scene, threads) {}

  repose::Simulation simulation;
  std::unique_ptr<RunFolder> folder;
  std::atomic<bool> interrupted{false};

  auto pause() {
    return [this] { return !interrupted; };
  }
};

namespace {

void refuse(const std::vector<std::string>& problems) {
  if (!problems.empty()) throw InputError(problems);
}

Status status_of(repose::Status status) {
  switch (status) {
    case repose::Status::running:
      return Status::running;
    case repose::Status::finished:
      return Status::finished;
    case repose::Status::interrupted:
      return Status::interrupted;
    case repose::Status::failed:
      break;
  }
  return Status::failed;
}

}  // namespace

Simulation::Simulation(const Scene& scene, int threads) : state_(std::make_unique<State>(scene.content(), threads)) {}

Simulation::Simulation(std::unique_ptr<State> state) : state_(std::move(state)) {}

Simulation::~Simulation() = default;

Simulation Simulation::resume(const std::string& folder, int threads) {
  auto run = find_interrupted(folder);
  if (run.finished) throw InputError(fmt::format("{}: the run is finished", folder));
  auto state = std::make_unique<State>(run.scene, threads);
  state->folder = resumed_folder(folder, run, state->simulation);
  return Simulation(std::move(state));
}

double Simulation::advance(double until) {
  const double reached = state_->simulation.advance(until, state_->pause()).time;
  state_->interrupted = false;
  return reached;
}

void Simulation::run() {
  auto& state = *state_;
  if (!state.folder) {
    state.simulation.run(state.pause());
    return;
  }
  state.folder->run(state.simulation, state.interrupted);
  state.folder->write(state.simulation);
  state.folder.reset();  // gives the lock back
}

void Simulation::write_to(const std::string& folder, bool overwrite) {
  refuse(RunFolder::problems(folder, overwrite));
  state_->folder = std::make_unique<RunFolder>(folder, state_->simulation);
}

void Simulation::observe_every(double interval, std::function<void(const Simulation&)> use) {
  state_->simulation.observe_every(interval, [this, use = std::move(use)](const repose::Simulation&) { use(*this); });
}

void Simulation::interrupt() { state_->interrupted = true; }

void Simulation::save(const std::string& folder, bool overwrite) {
  refuse(RunFolder::problems(folder, overwrite));
  RunFolder written(folder, state_->simulation);
  written.write(state_->simulation);
  if (state_->simulation.status() == repose::Status::running) written.keep(state_->simulation, true);
}

double Simulation::time() const { return state_->simulation.time(); }
double Simulation::time_step() const { return state_->simulation.time_step(); }
std::int64_t Simulation::steps() const { return state_->simulation.steps(); }
Status Simulation::status() const { return status_of(state_->simulation.status()); }
std::string Simulation::message() const { return state_->simulation.message(); }
std::string Simulation::state_hash() const { return state_->simulation.record().facts.state_hash; }

std::vector<Grain> Simulation::grains() const {
  const auto record = state_->simulation.record();
  std::vector<Grain> grains;
  grains.reserve(record.grains.size());
  for (std::size_t k = 0; k < record.grains.size(); ++k) {
    const auto& line = record.grains->line[k];
    grains.push_back({record.grains->id[k],
                      {line.position[0], line.position[1]},
                      {line.velocity[0], line.velocity[1]},
                      line.rim_velocity / line.radius,
                      line.radius,
                      line.mass,
                      record.grains->material[k],
                      line.fixed(),
                      record.grains->base[k] != 0});
  }
  return grains;
}

std::vector<Contact> Simulation::contacts() const {
  std::vector<Contact> contacts;
  for (const auto& contact : state_->simulation.contacts().list) {
    contacts.push_back({contact.first,
                        contact.second,
                        {contact.normal[0], contact.normal[1]},
                        contact.overlap,
                        contact.normal_force,
                        contact.tangential_force,
                        contact.slip,
                        contact.sliding});
  }
  return contacts;
}

std::vector<Measure> Simulation::measures() const { return measures_of_record(state_->simulation.record()); }

}  // namespace repose::api
