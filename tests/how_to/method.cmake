# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds the example of docs/how-to/add-a-method.md: its one source file, linked with the program's objects for a program
# that knows the method, and with the tests of its physics.
set(page ${CMAKE_SOURCE_DIR}/docs/how-to/add-a-method.md)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page})
file(READ ${page} text)
string(REGEX MATCH "```cpp\n.*\n```" code "${text}")
string(REGEX REPLACE "^```cpp\n(.*)```$" "\\1" code "${code}")
if(NOT code)
  message(FATAL_ERROR "${page}: holds no code")
endif()
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/free_fall.cpp CONTENT "${code}" @ONLY)

add_library(repose_free_fall OBJECT ${CMAKE_CURRENT_BINARY_DIR}/free_fall.cpp)
target_link_libraries(repose_free_fall PUBLIC repose_library)

add_executable(repose_with_free_fall $<TARGET_OBJECTS:repose_free_fall> $<TARGET_OBJECTS:repose_cli_objects>)
target_link_libraries(repose_with_free_fall PRIVATE repose_library PkgConfig::HTTPLIB)
add_test(NAME free_fall_program COMMAND /usr/bin/python3 -m pytest -q -p no:cacheprovider
  ${CMAKE_CURRENT_SOURCE_DIR}/test_free_fall.py)
set_tests_properties(free_fall_program PROPERTIES LABELS how_to TIMEOUT 300
  ENVIRONMENT "REPOSE_PROGRAM=$<TARGET_FILE:repose_with_free_fall>;PYTHONDONTWRITEBYTECODE=1;PYTHONPATH=${CMAKE_SOURCE_DIR}/tests/cli")

add_executable(repose_free_fall_test free_fall_test.cpp $<TARGET_OBJECTS:repose_free_fall>)
target_include_directories(repose_free_fall_test PRIVATE ${CMAKE_SOURCE_DIR}/tests)
target_link_libraries(repose_free_fall_test PRIVATE repose_library GTest::gtest_main)
compile_as_test(repose_free_fall_test)
gtest_discover_tests(repose_free_fall_test PROPERTIES LABELS how_to DISCOVERY_TIMEOUT 60)
