// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/api/analysis.hpp"
#include "repose/api/scene.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace repose::api {

/// A grain of the present state.
struct Grain {
  std::int64_t id = 0;               ///< stable for the whole run
  std::array<double, 3> position{};  ///< [L] of the centre, inside a periodic box; of a disc the third number is 0
  std::array<double, 3> velocity{};  ///< [L/T]
  double spin = 0.0;                 ///< [1/T] angular velocity of a disc, counter-clockwise
  std::array<double, 3> angular_velocity{};  ///< [1/T] of a disc about the third axis
  double radius = 0.0;                       ///< [L]
  double mass = 0.0;                         ///< [M]
  int material = 0;                          ///< number of the material in the scene
  bool fixed = false;                        ///< never moves
  bool base = false;                         ///< belongs to the base
};

/// A contact of the present state. The normal points from the second to the first partner, forces act on the first, and
/// a positive normal force pushes apart. Between discs the tangent is the normal turned by +90 degrees; between spheres
/// numbers along it are magnitudes.
struct Contact {
  std::int64_t first = 0;          ///< id of a grain
  std::int64_t second = 0;         ///< id of a grain, or -1 - k for wall number k
  std::array<double, 3> normal{};  ///< unit vector
  double overlap = 0.0;            ///< [L]
  double normal_force = 0.0;       ///< [M L/T^2]
  double tangential_force = 0.0;   ///< [M L/T^2]
  double slip = 0.0;               ///< [L] tangential displacement accumulated by the contact
  std::array<double, 3> force{};   ///< [M L/T^2] normal and tangential together
  bool sliding = false;            ///< at the Coulomb limit
};

enum class Status { running, finished, interrupted, failed };

/// A scene at work. The state does not depend on the number of threads, on how a run is divided into advances, nor on
/// its observers: the bits are those of `repose run`.
class Simulation {
 public:
  explicit Simulation(const Scene& scene, int threads = 1);

  /// Continues an interrupted run from the last checkpoint of its folder, as `repose resume` does. Throws InputError.
  static Simulation resume(const std::string& folder, int threads = 1);

  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Advances to a time [T], in whole steps where the method has equal ones, or until the run stops. Returns the time
  /// reached [T].
  double advance(double until);

  /// Advances until a stop of the scene, trouble, or `interrupt`. A simulation with a run folder writes frames and
  /// checkpoints on the way, and its last state and analysis at the end. Throws RunError where it cannot write.
  void run();

  /// Makes `run` write into a run folder. Call this before the first advance. Throws InputError where the folder is in
  /// use and `overwrite` is false.
  void write_to(const std::string& folder, bool overwrite = false);

  /// Calls a function every `interval` of simulated time [T] > 0, rounded to whole steps where the method has equal
  /// ones. Throws InputError.
  void observe_every(double interval, std::function<void(const Simulation&)> use);

  /// Ends the present `run` or `advance`, or the next one, within about a second. An advance may be followed by
  /// another. May be called from another thread or a signal handler.
  void interrupt();

  /// Writes the present state, its analysis and a checkpoint into a new run folder, from which the run can be analysed,
  /// plotted, exported and resumed. Throws InputError, RunError.
  void save(const std::string& folder, bool overwrite = false);

  int dimension() const;        ///< 2: discs; 3: spheres
  double time() const;          ///< [T]
  double time_step() const;     ///< [T] 0 where steps vary
  std::int64_t steps() const;   ///< steps or events taken
  Status status() const;        ///< running until a stop of the scene, trouble or an interrupt
  std::string message() const;  ///< why the run stopped
  std::string state_hash() const;

  std::vector<Grain> grains() const;      ///< by ascending id
  std::vector<Contact> contacts() const;  ///< by the ids of the partners
  std::vector<Measure> measures() const;  ///< of the present state

 private:
  struct State;
  explicit Simulation(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace repose::api
