# SPDX-License-Identifier: MIT
# The target `docs` writes the reference and the manual to <build>/docs/html; any warning of Doxygen's is an error. The
# build tree without Doxygen has the target too, which then says what to install.

find_package(Doxygen 1.9 QUIET)
if(NOT DOXYGEN_FOUND)
  add_custom_target(docs
    COMMAND ${CMAKE_COMMAND} -E echo "The target docs needs Doxygen: install the package doxygen"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
  return()
endif()

set(SSPQL_DOCS_DIR "${PROJECT_BINARY_DIR}/docs")
configure_file(docs/reference/Doxyfile.in docs/Doxyfile @ONLY)

# A page for each example.
file(GLOB examples CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/examples" examples/*.cpp)
list(TRANSFORM examples REPLACE "(.+)" "/// \\\\example \\1\n")
list(JOIN examples "\n" examples)
file(CONFIGURE OUTPUT docs/input/examples.dox CONTENT "@examples@" @ONLY)

add_custom_target(docs
  COMMAND ${CMAKE_COMMAND} -E rm -rf "${SSPQL_DOCS_DIR}/html"
  COMMAND Doxygen::doxygen "${SSPQL_DOCS_DIR}/Doxyfile"
  COMMENT "Writing ${SSPQL_DOCS_DIR}/html" USES_TERMINAL VERBATIM)
