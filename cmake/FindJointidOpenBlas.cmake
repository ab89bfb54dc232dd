# Defines jointid::openblas: OpenBLAS built with POSIX threads. The build without threads has no locks: threads that call it at once
# get wrong products. Linked by its full path, so that the modules' RUNPATH leads to it whatever `update-alternatives` prefers.
find_library(JointidOpenBlas_LIBRARY NAMES openblas PATH_SUFFIXES openblas-pthread NO_CMAKE_SYSTEM_PATH
  PATHS "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}" /usr/lib /usr/lib64 /usr/local/lib)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(JointidOpenBlas REQUIRED_VARS JointidOpenBlas_LIBRARY)
if(JointidOpenBlas_FOUND AND NOT TARGET jointid::openblas)
  add_library(jointid::openblas INTERFACE IMPORTED)
  target_link_libraries(jointid::openblas INTERFACE "${JointidOpenBlas_LIBRARY}")
endif()
