# SPDX-License-Identifier: MIT
# The target `deb` builds the Debian package in a copy of the source, <build>/deb/sspql-VERSION; the package appears in
# <build>/deb. With -D DEB_SOURCE and DEB_DIR and VERSION this file is the script that does so.

if(NOT CMAKE_SCRIPT_MODE_FILE)
  add_custom_target(deb
    COMMAND ${CMAKE_COMMAND} -D "DEB_SOURCE=${PROJECT_SOURCE_DIR}" -D "DEB_DIR=${PROJECT_BINARY_DIR}/deb"
            -D "VERSION=${PROJECT_VERSION}" -P "${CMAKE_CURRENT_LIST_FILE}"
    COMMENT "Building the Debian package" USES_TERMINAL VERBATIM)
  return()
endif()

file(STRINGS "${DEB_SOURCE}/debian/changelog" newest LIMIT_COUNT 1)
if(NOT newest MATCHES "^sspql \\(([^)]*)\\)" OR NOT CMAKE_MATCH_1 STREQUAL VERSION)
  message(FATAL_ERROR "debian/changelog starts with '${newest}', but the version is ${VERSION}")
endif()

file(REMOVE_RECURSE "${DEB_DIR}")
set(copy "${DEB_DIR}/sspql-${VERSION}")
file(GLOB entries RELATIVE "${DEB_SOURCE}" "${DEB_SOURCE}/*")
list(REMOVE_ITEM entries build .git)
foreach(entry IN LISTS entries)
  if(NOT EXISTS "${DEB_SOURCE}/${entry}/CMakeCache.txt")
    file(COPY "${DEB_SOURCE}/${entry}" DESTINATION "${copy}")
  endif()
endforeach()

execute_process(COMMAND dpkg-buildpackage -b -us -uc WORKING_DIRECTORY "${copy}" COMMAND_ERROR_IS_FATAL ANY)
file(GLOB packages "${DEB_DIR}/*.deb")
message(STATUS "Package: ${packages}")
