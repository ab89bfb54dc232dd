# Defines jointid::openblas: OpenBLAS, the build without threads where there is one (lines are what is shared among threads).
find_library(JointidOpenBlas_LIBRARY NAMES openblas PATH_SUFFIXES openblas-serial openblas-pthread)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(JointidOpenBlas REQUIRED_VARS JointidOpenBlas_LIBRARY)
if(JointidOpenBlas_FOUND AND NOT TARGET jointid::openblas)
  add_library(jointid::openblas INTERFACE IMPORTED)
  target_link_libraries(jointid::openblas INTERFACE "${JointidOpenBlas_LIBRARY}")
endif()
