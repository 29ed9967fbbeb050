// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

// Each is defined in the file of its name in results/measures.
void add_run(Registry& to);
void add_network(Registry& to);
void add_heap(Registry& to);
void add_forces(Registry& to);
void add_force_lines(Registry& to);
void add_motion(Registry& to);
void add_base(Registry& to);
void add_force_range(Registry& to);
void add_stability(Registry& to);
void add_slips(Registry& to);
void add_walls(Registry& to);
void add_column(Registry& to);
void add_fields(Registry& to);
void add_heap_zones(Registry& to);
void add_grain_stress(Registry& to);
void add_packing(Registry& to);
void add_packing_structure(Registry& to);
void add_collisions(Registry& to);
void add_solver(Registry& to);
void add_state(Registry& to);

// In three dimensions.
void add_run(RegistryIn<3>& to);
void add_spheres(RegistryIn<3>& to);
void add_column(RegistryIn<3>& to);
void add_solver(RegistryIn<3>& to);
void add_state(RegistryIn<3>& to);

// In the order of summary.json.
template <>
std::vector<Subject> subjects<2>() {
  return {
      add_run,                //
      add_network,            //
      add_heap,               //
      add_forces,             //
      add_force_lines,        //
      add_motion,             //
      add_base,               //
      add_force_range,        //
      add_stability,          //
      add_slips,              //
      add_walls,              //
      add_column,             //
      add_fields,             //
      add_heap_zones,         //
      add_grain_stress,       //
      add_packing,            //
      add_packing_structure,  //
      add_collisions,         //
      add_solver,             //
      add_state,              //
  };
}

template <>
std::vector<SubjectIn<3>> subjects<3>() {
  return {add_run, add_spheres, add_column, add_solver, add_state};
}

}  // namespace repose
