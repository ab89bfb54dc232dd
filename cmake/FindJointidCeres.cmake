# Defines jointid::ceres: Debian's static Ceres without the ATLAS that its own CMake target drags in, which would take BLAS calls
# of the whole program away from the BLAS that is configured.
find_path(JointidCeres_INCLUDE_DIR ceres/ceres.h)
set(_libs)
foreach(lib libceres.a glog cxsparse lapack blas)
  string(MAKE_C_IDENTIFIER "${lib}" _name)
  find_library(JointidCeres_${_name} NAMES ${lib})
  list(APPEND _libs "${JointidCeres_${_name}}")
endforeach()
find_package(Threads QUIET)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(JointidCeres REQUIRED_VARS JointidCeres_INCLUDE_DIR JointidCeres_libceres_a
  JointidCeres_glog JointidCeres_cxsparse JointidCeres_lapack JointidCeres_blas Threads_FOUND)
if(JointidCeres_FOUND AND NOT TARGET jointid::ceres)
  list(POP_FRONT _libs _ceres)
  add_library(jointid::ceres STATIC IMPORTED) # so that what it needs is linked after it
  set_target_properties(jointid::ceres PROPERTIES IMPORTED_LOCATION "${_ceres}")
  target_include_directories(jointid::ceres SYSTEM INTERFACE "${JointidCeres_INCLUDE_DIR}")
  target_link_libraries(jointid::ceres INTERFACE jointid::suitesparse ${_libs} Threads::Threads)
endif()
