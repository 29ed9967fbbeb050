# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
option(REPOSE_UNITY "Compile some files of a folder together, which parses headers once for all of them" ON)

# Files whose helpers have the same names as those of a neighbour, files that an example of docs/how-to replaces, the page
# of the view and its server, and the test with Eigen, whose headers are at odds with those of Random123 in one file.
set(compiled_alone
  src/repose/core/reproducible_powers src/repose/methods/soft/general_kernel
  src/repose/methods/deposition/spheres src/repose/methods/soft/rows/rows_scalar src/repose/methods/soft/rows/rows_baseline
  src/repose/results/subjects src/repose/scene/toml_file
  src/repose/cli/view_server src/repose/view/page
  tests/unit/base_rings_test tests/unit/chains_test tests/unit/contact_dynamics_walls_test
  tests/unit/contact_packs_test tests/unit/deposition_spheres_test tests/unit/fabric_test tests/unit/motion_test
  tests/unit/reproducible_math_test tests/unit/simulation_test tests/unit/sources_test tests/unit/sphere_cells_test
  tests/unit/sphere_forces_test tests/unit/sphere_packing_test tests/unit/sphere_structure_test
  tests/unit/spheres_packing_test tests/unit/spheres_test tests/unit/stability_test tests/unit/start_3d_test
  tests/unit/structure_factor_test tests/unit/time_step_of_spheres_test tests/unit/voronoi_test)

# Compiles the sources of a target in groups of up to `most` files of one folder.
function(compile_together target most)
  if(NOT REPOSE_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "^${CMAKE_SOURCE_DIR}/(src|tests)/.*[.]cpp$")
  foreach(source IN LISTS sources)
    file(RELATIVE_PATH path ${CMAKE_SOURCE_DIR} ${source})
    string(REGEX REPLACE "[.]cpp$" "" name ${path})
    if(name IN_LIST compiled_alone)
      continue()
    endif()
    get_filename_component(folder ${path} DIRECTORY)
    string(MAKE_C_IDENTIFIER ${folder} folder)
    if(NOT DEFINED count_${folder})
      set(count_${folder} 0)
    endif()
    math(EXPR group "${count_${folder}} / ${most}")
    math(EXPR count_${folder} "${count_${folder}} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
