# `cmake --install` and what an outside project needs for find_package(jointid).
include(CMakePackageConfigHelpers)
set(_destination "${CMAKE_INSTALL_LIBDIR}/cmake/jointid")

install(EXPORT jointid-targets NAMESPACE jointid:: DESTINATION "${_destination}")
configure_package_config_file(cmake/jointid-config.cmake.in jointid-config.cmake INSTALL_DESTINATION "${_destination}"
                              PATH_VARS JOINTID_INSTALL_MODULES)
write_basic_package_version_file(jointid-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/jointid-config.cmake"
  "${PROJECT_BINARY_DIR}/jointid-config-version.cmake"
  DESTINATION "${_destination}")
install(FILES LICENSE docs/licences.md DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT command)
install(FILES report/page/vendor/uplot/LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME LICENSE.uPlot COMPONENT command)
