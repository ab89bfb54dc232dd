# Defines jointid::ipopt: the library alone. What Debian's ipopt.pc lists beside it holds a stub of MPI_Init that may win over MPI's.
find_path(JointidIpopt_INCLUDE_DIR IpIpoptApplication.hpp PATH_SUFFIXES coin coin-or)
find_library(JointidIpopt_LIBRARY NAMES ipopt)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(JointidIpopt REQUIRED_VARS JointidIpopt_LIBRARY JointidIpopt_INCLUDE_DIR)
if(JointidIpopt_FOUND AND NOT TARGET jointid::ipopt)
  add_library(jointid::ipopt INTERFACE IMPORTED)
  target_include_directories(jointid::ipopt SYSTEM INTERFACE "${JointidIpopt_INCLUDE_DIR}")
  target_compile_definitions(jointid::ipopt INTERFACE HAVE_CSTDDEF) # its headers ask for it
  target_link_libraries(jointid::ipopt INTERFACE "${JointidIpopt_LIBRARY}")
endif()
