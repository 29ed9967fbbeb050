# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Run by cpack before it packs: takes the debug information out of static libraries, which cmake leaves as they are.
find_program(strip strip)
file(GLOB_RECURSE archives ${CPACK_TEMPORARY_DIRECTORY}/*.a)
if(strip AND archives)
  execute_process(COMMAND ${strip} --strip-debug ${archives} COMMAND_ERROR_IS_FATAL ANY)
endif()
