// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bed_method.hpp"

#include "repose/methods/soft/make_kernel.hpp"

#include <cmath>
#include <stdexcept>

namespace repose {

template std::unique_ptr<Method<3>> make_kernel(MaterialTable<HookeLinear>, SoftSettings<3>);

namespace bench {

namespace {

/// For unit masses the damping gamma_n = 140 per reduced mass of LAMMPS is a dashpot of 70 = 2 zeta sqrt(k). The
/// tangential dashpot is half of it, the default of LAMMPS.
HookeLinear hooke() {
  constexpr double stiffness = 5e4;
  constexpr double tangential_stiffness = 2.0 / 7.0 * stiffness;
  return {Hooke{stiffness, 70.0 / (2.0 * std::sqrt(stiffness)), true},
          Linear{0.5, tangential_stiffness, 35.0 / (2.0 * std::sqrt(tangential_stiffness))}};
}

/// The fastest skin here; LAMMPS also runs with its best one.
template <int D>
SoftSettings<D> settings_of(const Box<D>& box, double time_step) {
  SoftSettings<D> settings;
  settings.time_step = time_step;
  settings.gravity[up<D>] = -1.0;
  settings.box = box;
  settings.skin = D == 2 ? 0.05 : 0.025;
  return settings;
}

}  // namespace

template <>
std::unique_ptr<Method<2>> bed_method(const std::string& law, const Box<2>& box) {
  if (law == "hooke") return make_kernel<2>(MaterialTable(hooke()), settings_of(box, 2e-4));
  if (law == "hooke-cumulative") {
    return make_kernel<2>(MaterialTable(HookeCumulative{Hooke{5e4, 0.15}, Cumulative{0.5, 1.214}}),
                          settings_of(box, 2e-4));
  }
  if (law == "continuous") {
    return make_kernel<2>(
        MaterialTable(ContinuousCumulative{Continuous::make(36.0, 1.2, 0.5, 1.0), Cumulative{0.5, 1.214}}),
        settings_of(box, 1e-3));
  }
  throw std::runtime_error("no such law: " + law);
}

template <>
std::unique_ptr<Method<3>> bed_method(const std::string& law, const Box<3>& box) {
  if (law != "hooke") throw std::runtime_error("no such law for spheres: " + law);
  return make_kernel<3>(MaterialTable(hooke()), settings_of(box, 2e-4));
}

}  // namespace bench
}  // namespace repose
