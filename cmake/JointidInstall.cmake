# `cmake --install` and what an outside project needs for find_package(jointid).
include(CMakePackageConfigHelpers)
set(_destination "${CMAKE_INSTALL_LIBDIR}/cmake/jointid")

set(JOINTID_HAS_MATIO OFF)
if(TARGET PkgConfig::matio)
  set(JOINTID_HAS_MATIO ON)
endif()

set(JOINTID_HAS_CERES OFF)
if(TARGET jointid::ceres)
  set(JOINTID_HAS_CERES ON)
endif()

set(JOINTID_HAS_NLOPT OFF)
if(TARGET jointid::nlopt)
  set(JOINTID_HAS_NLOPT ON)
endif()

set(JOINTID_HAS_IPOPT OFF)
if(TARGET jointid::ipopt)
  set(JOINTID_HAS_IPOPT ON)
endif()

set(JOINTID_HAS_MPI OFF)
if(TARGET MPI::MPI_C)
  set(JOINTID_HAS_MPI ON)
endif()

install(EXPORT jointid-targets NAMESPACE jointid:: DESTINATION "${_destination}")
configure_package_config_file(cmake/jointid-config.cmake.in jointid-config.cmake INSTALL_DESTINATION "${_destination}")
write_basic_package_version_file(jointid-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/jointid-config.cmake"
  "${PROJECT_BINARY_DIR}/jointid-config-version.cmake"
  cmake/FindJointidCeres.cmake
  cmake/FindJointidIpopt.cmake
  cmake/FindJointidNlopt.cmake
  cmake/FindJointidSuiteSparse.cmake
  DESTINATION "${_destination}")
install(FILES LICENSE docs/licences.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES cli/report/vendor/uplot/LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME LICENSE.uPlot)
