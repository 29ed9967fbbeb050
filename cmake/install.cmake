# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
#
# What `cmake --install` puts where. Everything is found relative to where it lies, so that an installation may be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(python_folder lib/python3/dist-packages) # known to src/repose/cli/python.cpp
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/repose)

# The program finds the Python package beside itself, in a build folder as in an installation.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/python)
file(CREATE_LINK ${CMAKE_SOURCE_DIR}/python/repose ${CMAKE_BINARY_DIR}/python/repose SYMBOLIC)

# Manual page and shell completion are printed by the program.
set(documents ${CMAKE_BINARY_DIR}/documents)
file(MAKE_DIRECTORY ${documents})
add_custom_command(OUTPUT ${documents}/repose.1 ${documents}/repose.bash ${documents}/_repose
  COMMAND repose --man > ${documents}/repose.1
  COMMAND repose --completion bash > ${documents}/repose.bash
  COMMAND repose --completion zsh > ${documents}/_repose
  DEPENDS repose VERBATIM)
add_custom_target(repose_documents ALL DEPENDS ${documents}/repose.1)
add_custom_target(repose_installed DEPENDS repose repose_library repose_documents)

set_target_properties(repose_library PROPERTIES EXPORT_NAME repose)
set_target_properties(repose_theory PROPERTIES EXPORT_NAME theory)

# Users of the installed library get its headers and what it must be linked with, but not the flags that build it.
foreach(library repose_library repose_theory)
  get_target_property(folders ${library} INTERFACE_INCLUDE_DIRECTORIES)
  get_target_property(libraries ${library} INTERFACE_LINK_LIBRARIES)
  set_target_properties(${library} PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "$<BUILD_INTERFACE:${folders}>;$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
    INTERFACE_LINK_LIBRARIES "$<BUILD_INTERFACE:${libraries}>;$<INSTALL_INTERFACE:repose::dependencies>")
endforeach()
set_property(TARGET repose_library APPEND PROPERTY INTERFACE_LINK_LIBRARIES $<INSTALL_INTERFACE:repose::theory>)

install(TARGETS repose_library repose_theory EXPORT repose ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT repose NAMESPACE repose:: FILE repose-targets.cmake DESTINATION ${package_folder})
configure_package_config_file(cmake/repose-config.cmake.in ${documents}/repose-config.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${documents}/repose-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${documents}/repose-config.cmake ${documents}/repose-config-version.cmake DESTINATION ${package_folder})
install(CODE "set(repose_source \"${CMAKE_SOURCE_DIR}/src\")
set(repose_include \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")")
install(SCRIPT cmake/install_headers.cmake)

install(TARGETS repose RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY python/repose DESTINATION ${python_folder} PATTERN __pycache__ EXCLUDE)
if(REPOSE_PYTHON)
  install(TARGETS repose_compiled LIBRARY DESTINATION ${python_folder})
  add_dependencies(repose_installed repose_compiled)
endif()

install(FILES ${documents}/repose.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${documents}/repose.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME repose)
install(FILES ${documents}/_repose DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(DIRECTORY examples studies DESTINATION ${CMAKE_INSTALL_DATADIR}/repose)
install(FILES LICENSE CITATION.cff README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/repose)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/repose RENAME copyright)

include(cmake/package.cmake)
