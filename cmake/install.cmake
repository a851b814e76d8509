# SPDX-License-Identifier: MIT
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Nothing here depends on the architecture, so all of it goes to share/.
set(package_dir "${CMAKE_INSTALL_DATAROOTDIR}/cmake/sspql")

install(TARGETS sspql EXPORT sspql-targets FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT sspql-targets NAMESPACE sspql:: DESTINATION ${package_dir})
if(TARGET sspql_sim)
  install(TARGETS sspql_sim EXPORT sspql-sim-targets FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT sspql-sim-targets NAMESPACE sspql:: DESTINATION ${package_dir})
endif()

configure_package_config_file(cmake/sspql-config.cmake.in sspql-config.cmake INSTALL_DESTINATION ${package_dir}
                              NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(sspql-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES "${PROJECT_BINARY_DIR}/sspql-config.cmake" "${PROJECT_BINARY_DIR}/sspql-config-version.cmake"
        DESTINATION ${package_dir})

configure_file(cmake/sspql.pc.in sspql.pc @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/sspql.pc" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/pkgconfig")
