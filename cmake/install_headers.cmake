# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Run by `cmake --install`: copies the header of the API, and those that it includes, from repose_source to
# repose_include.
set(pending repose/api/repose.hpp)
set(done)
while(pending)
  list(POP_FRONT pending header)
  if(header IN_LIST done)
    continue()
  endif()
  list(APPEND done ${header})
  cmake_path(GET header PARENT_PATH folder)
  file(INSTALL ${repose_source}/${header} DESTINATION ${repose_include}/${folder})
  file(STRINGS ${repose_source}/${header} lines REGEX "^ *# *include +\"repose/")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^[^\"]*\"([^\"]+)\".*$" "\\1" included "${line}")
    list(APPEND pending ${included})
  endforeach()
endwhile()
