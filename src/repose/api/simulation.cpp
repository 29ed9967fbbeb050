// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/api/simulation.hpp"

#include "repose/api/measures_of_record.hpp"
#include "repose/run_folder/resume.hpp"
#include "repose/run_folder/run_folder.hpp"
#include "repose/simulation/simulation.hpp"

#include <fmt/format.h>

#include <atomic>
#include <type_traits>
#include <utility>
#include <variant>

namespace repose::api {

namespace running_simulation {

/// A simulation and its run folder, if it writes one.
template <int D>
struct Running {
  Running(const repose::Scene& scene, int threads) : simulation(scene, threads) {}

  repose::Simulation<D> simulation;
  std::unique_ptr<RunFolder<D>> folder;
};

using AnyRunning = std::variant<std::unique_ptr<Running<2>>, std::unique_ptr<Running<3>>>;

AnyRunning running(const repose::Scene& scene, int threads) {
  return with_dimension(scene.dimension, [&](auto dimension) -> AnyRunning {
    return std::make_unique<Running<dimension>>(scene, threads);
  });
}

}  // namespace running_simulation

struct Simulation::State {
  State(const repose::Scene& scene, int threads) : any(running_simulation::running(scene, threads)) {}

  running_simulation::AnyRunning any;
  std::atomic<bool> interrupted{false};

  /// Calls use(running), a Running of the dimension of the scene.
  template <class Use>
  decltype(auto) with(const Use& use) const {
    return std::visit([&](const auto& one) -> decltype(auto) { return use(*one); }, any);
  }
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
  state->with([&](auto& one) { one.folder = resumed_folder(folder, run, one.simulation); });
  return Simulation(std::move(state));
}

double Simulation::advance(double until) {
  const double reached = state_->with([&](auto& one) { return one.simulation.advance(until, state_->pause()).time; });
  state_->interrupted = false;
  return reached;
}

void Simulation::run() {
  state_->with([&](auto& one) {
    if (!one.folder) {
      one.simulation.run(state_->pause());
      return;
    }
    one.folder->run(one.simulation, state_->interrupted);
    one.folder->write(one.simulation);
    one.folder.reset();  // gives the lock back
  });
}

void Simulation::write_to(const std::string& folder, bool overwrite) {
  refuse(run_folder_problems(folder, overwrite));
  state_->with([&](auto& one) {
    using Folder = typename std::remove_reference_t<decltype(one.folder)>::element_type;
    one.folder = std::make_unique<Folder>(folder, one.simulation);
  });
}

void Simulation::observe_every(double interval, std::function<void(const Simulation&)> use) {
  state_->with([&](auto& one) { one.simulation.observe_every(interval, [this, use](const auto&) { use(*this); }); });
}

void Simulation::interrupt() { state_->interrupted = true; }

void Simulation::save(const std::string& folder, bool overwrite) {
  refuse(run_folder_problems(folder, overwrite));
  state_->with([&](auto& one) {
    typename std::remove_reference_t<decltype(one.folder)>::element_type written(folder, one.simulation);
    written.write(one.simulation);
    if (one.simulation.status() == repose::Status::running) written.keep(one.simulation, true);
  });
}

int Simulation::dimension() const { return static_cast<int>(state_->any.index()) + 2; }

double Simulation::time() const {
  return state_->with([](auto& one) { return one.simulation.time(); });
}
double Simulation::time_step() const {
  return state_->with([](auto& one) { return one.simulation.time_step(); });
}
std::int64_t Simulation::steps() const {
  return state_->with([](auto& one) -> std::int64_t { return one.simulation.steps(); });
}
Status Simulation::status() const {
  return state_->with([](auto& one) { return status_of(one.simulation.status()); });
}
std::string Simulation::message() const {
  return state_->with([](auto& one) { return one.simulation.message(); });
}
std::string Simulation::state_hash() const {
  return state_->with([](auto& one) { return one.simulation.record().facts.state_hash; });
}

namespace {

/// The spin of a disc is about the axis out of its plane.
Coordinates axial(double spin) { return {0.0, 0.0, spin}; }
Coordinates axial(const Vec<3>& spin) { return coordinates(spin); }

template <int D>
std::vector<Grain> grains_of(const Record<D>& record) {
  std::vector<Grain> grains;
  grains.reserve(record.grains.size());
  for (std::size_t k = 0; k < record.grains.size(); ++k) {
    const auto& line = record.grains->line[k];
    const Spin<D> spin = line.rim_velocity * (1.0 / line.radius);
    Grain grain;
    grain.id = record.grains->id[k];
    grain.position = coordinates(line.position);
    grain.velocity = coordinates(line.velocity);
    grain.angular_velocity = axial(spin);
    if constexpr (D == 2) grain.spin = line.rim_velocity / line.radius;
    grain.radius = line.radius;
    grain.mass = line.mass;
    grain.material = record.grains->material[k];
    grain.fixed = line.fixed();
    grain.base = record.grains->base[k] != 0;
    grains.push_back(grain);
  }
  return grains;
}

double along_tangent(double tangent) { return tangent; }
double along_tangent(const Vec<3>& tangent) { return magnitude(tangent); }

template <int D>
std::vector<Contact> contacts_of(const Contacts<D>& contacts) {
  std::vector<Contact> list;
  for (const auto& contact : contacts.list) {
    list.push_back({contact.first, contact.second, coordinates(contact.normal), contact.overlap, contact.normal_force,
                    along_tangent(contact.tangential_force), along_tangent(contact.slip),
                    coordinates(force_of(contact)), contact.sliding});
  }
  return list;
}

}  // namespace

std::vector<Grain> Simulation::grains() const {
  return state_->with([](auto& one) { return grains_of(one.simulation.record()); });
}

std::vector<Contact> Simulation::contacts() const {
  return state_->with([](auto& one) { return contacts_of(one.simulation.contacts()); });
}

std::vector<Measure> Simulation::measures() const {
  return state_->with([](auto& one) { return measures_of_record(one.simulation.record()); });
}

}  // namespace repose::api
