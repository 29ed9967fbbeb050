# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
#
# The packages that `./dev package` makes: a Debian package and a tar archive of an installation.
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME repose)
set(CPACK_PACKAGE_VENDOR "The Repose developers")
set(CPACK_PACKAGE_CONTACT "The Repose developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "open laboratory for the mechanics of granular heaps, packings and columns")
set(CPACK_PACKAGE_DESCRIPTION "Simulates heaps, packings and columns of grains by several methods, measures them and
compares them with stress models. Program, C++ library and Python package.")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
string(TOLOWER "repose-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}" CPACK_PACKAGE_FILE_NAME)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/cmake/strip_archives.cmake)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE gzip)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3-numpy, python3-h5py, python3-matplotlib")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-scipy, python3-sklearn, ffmpeg")  # repose calibrate, movies
if(REPOSE_PYTHON) # the compiled module is for one version of Python
  math(EXPR next_minor "${PYTHON_VERSION_MINOR} + 1")
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", python3 (>= ${PYTHON_VERSION_MAJOR}.${PYTHON_VERSION_MINOR}~)"
    ", python3 (<< ${PYTHON_VERSION_MAJOR}.${next_minor}~)")
endif()
# A program that links the library needs these.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libfmt-dev, libhdf5-dev, libxxhash-dev, zlib1g-dev, voro++-dev, coinor-libclp-dev, libudunits2-dev")
include(CPack)
