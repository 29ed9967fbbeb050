// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/api/simulation.hpp"

#include "bindings.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <chrono>
#include <exception>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

using repose::api::Contact;
using repose::api::Grain;
using repose::api::Measure;
using repose::api::Scene;
using repose::api::Simulation;
using repose::api::Status;

/// Does `work` in a thread of its own and listens for Ctrl-C meanwhile, which interrupts the simulation. Other Python
/// threads run.
template <class Work>
void interruptible(Simulation& simulation, const Work& work) {
  std::promise<void> promise;
  auto ended = promise.get_future();
  std::exception_ptr failure;
  std::exception_ptr signal;
  std::thread worker([&] {
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
    }
    promise.set_value();
  });
  {
    constexpr auto between_checks = std::chrono::milliseconds(50);
    const py::gil_scoped_release others_may_run;
    while (ended.wait_for(between_checks) != std::future_status::ready) {
      const py::gil_scoped_acquire ours;
      if (signal || PyErr_CheckSignals() == 0) continue;
      signal = std::make_exception_ptr(py::error_already_set());
      simulation.interrupt();
    }
    worker.join();
  }
  if (signal) std::rethrow_exception(signal);
  if (failure) std::rethrow_exception(failure);
}

std::string word_of(Status status) {
  switch (status) {
    case Status::running:
      return "running";
    case Status::finished:
      return "finished";
    case Status::interrupted:
      return "interrupted";
    case Status::failed:
      break;
  }
  return "failed";
}

/// Rows of a state, which numpy views look into: a view keeps them alive.
template <class Row>
class Rows {
 public:
  explicit Rows(std::vector<Row> rows) : rows_(std::make_shared<const std::vector<Row>>(std::move(rows))) {}

  /// A read-only view of one number of each row, or of the first of several: (N) or (N, columns).
  template <class Value>
  py::array view(Value Row::*member) const {
    return array<Value>(member, {count()}, {stride});
  }
  template <class Value, std::size_t Most>
  py::array view(std::array<Value, Most> Row::*member, int columns) const {
    return array<Value>(member, {count(), columns}, {stride, sizeof(Value)});
  }

 private:
  static constexpr py::ssize_t stride = sizeof(Row);
  py::ssize_t count() const { return static_cast<py::ssize_t>(rows_->size()); }

  template <class Value, class Member>
  py::array array(Member Row::*member, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides) const {
    using Owner = std::shared_ptr<const std::vector<Row>>;
    if (rows_->empty()) return py::array_t<Value>(shape);
    const py::capsule owner(new Owner(rows_), [](void* place) { delete static_cast<Owner*>(place); });
    const auto* first = reinterpret_cast<const Value*>(&(rows_->front().*member));
    py::array_t<Value> view(std::move(shape), std::move(strides), first, owner);
    view.attr("setflags")(py::arg("write") = false);
    return view;
  }

  std::shared_ptr<const std::vector<Row>> rows_;
};

py::dict grains_of(const Simulation& simulation) {
  const Rows<Grain> rows(simulation.grains());
  py::dict views;
  views["id"] = rows.view(&Grain::id);
  const int dimension = simulation.dimension();
  views["position"] = rows.view(&Grain::position, dimension);
  views["velocity"] = rows.view(&Grain::velocity, dimension);
  views["spin"] = dimension == 2 ? rows.view(&Grain::spin) : rows.view(&Grain::angular_velocity, 3);
  views["radius"] = rows.view(&Grain::radius);
  views["mass"] = rows.view(&Grain::mass);
  views["fixed"] = rows.view(&Grain::fixed);
  views["base"] = rows.view(&Grain::base);
  views["material"] = rows.view(&Grain::material);
  return views;
}

py::dict contacts_of(const Simulation& simulation) {
  const Rows<Contact> rows(simulation.contacts());
  py::dict views;
  views["first"] = rows.view(&Contact::first);
  views["second"] = rows.view(&Contact::second);
  views["normal"] = rows.view(&Contact::normal, simulation.dimension());
  views["overlap"] = rows.view(&Contact::overlap);
  views["normal_force"] = rows.view(&Contact::normal_force);
  views["tangential_force"] = rows.view(&Contact::tangential_force);
  views["history"] = rows.view(&Contact::slip);
  views["sliding"] = rows.view(&Contact::sliding);
  return views;
}

py::dict as_python(const std::vector<Measure>& measures) {
  py::dict all;
  for (const auto& measure : measures) all[py::str(measure.name)] = measure.value;
  return all;
}

/// Calls a Python function without arguments, from any thread.
void observe_every(Simulation& simulation, double interval, py::function use) {
  simulation.observe_every(interval, [use = std::move(use)](const Simulation&) {
    const py::gil_scoped_acquire ours;
    use();
  });
}

}  // namespace

void bind_simulation(py::module_& module) {
  py::class_<Simulation>(module, "Simulation")
      .def(py::init<const Scene&, int>(), py::arg("scene"), py::arg("threads"))
      .def_static(
          "resume",
          [](const std::string& folder, int threads) {
            return std::unique_ptr<Simulation>(new Simulation(Simulation::resume(folder, threads)));
          },
          py::arg("folder"), py::arg("threads"))
      .def("advance",
           [](Simulation& simulation, double until) {
             interruptible(simulation, [&] { simulation.advance(until); });
             return simulation.time();
           })
      .def("run", [](Simulation& simulation) { interruptible(simulation, [&] { simulation.run(); }); })
      .def("write_to", &Simulation::write_to, py::arg("folder"), py::arg("overwrite"))
      .def("save", &Simulation::save, py::arg("folder"), py::arg("overwrite"))
      .def("observe_every", &observe_every)
      .def("interrupt", &Simulation::interrupt)
      .def_property_readonly("time", &Simulation::time)
      .def_property_readonly("time_step", &Simulation::time_step)
      .def_property_readonly("steps", &Simulation::steps)
      .def_property_readonly("status", [](const Simulation& simulation) { return word_of(simulation.status()); })
      .def_property_readonly("message", &Simulation::message)
      .def_property_readonly("state_hash", &Simulation::state_hash)
      .def("grains", &grains_of)
      .def("contacts", &contacts_of)
      .def("measures", [](const Simulation& simulation) { return as_python(simulation.measures()); });
  module.def("analyse", [](const std::string& folder) {
    const py::gil_scoped_release others_may_run;
    return repose::api::analyse(folder);
  });
  py::class_<Measure>(module, "Measure").def_readonly("name", &Measure::name).def_readonly("value", &Measure::value);
}
