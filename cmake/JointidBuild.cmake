# Warnings, build types and the one way to declare a library folder.
include(GNUInstallDirs)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME dev) # packages: JointidPackages

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Dev, Release or Asan" FORCE)
endif()

# Paths are told from here, to the compiler and to ccache, so that every clone finds what another one has compiled.
add_compile_options("-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=")
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}"
      CCACHE_SLOPPINESS=pch_defines,time_macros "${CCACHE_PROGRAM}")
endif()

# GCC collects its own garbage from 128 MB on, a tenth of the time of a batch; from 1 GB on hardly any batch does.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:--param ggc-min-heapsize=1000000>")
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# Baseline x86-64 only: Debian's static libceres.a and Eigen disagree on alignment otherwise.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEV "-O2")
# For clang, whose sanitized builds take three quarters of the time of GCC's. Checks of every pointer for null and alignment are left out:
# a null one faults by itself, one beyond an object is the address sanitizer's.
set(CMAKE_CXX_FLAGS_ASAN
    "-O1 -g1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize=null,alignment,pointer-overflow,object-size -fno-sanitize-recover=all")
set(CMAKE_EXE_LINKER_FLAGS_ASAN "-fsanitize=address,undefined")
set(CMAKE_MODULE_LINKER_FLAGS_ASAN "-fsanitize=address,undefined")
set(CMAKE_SHARED_LINKER_FLAGS_ASAN "-fsanitize=address,undefined")

# Libraries are static in what users run. Where tests are compiled they are shared ones that call their own optimised templates, whatever
# those of tests, which are compiled without optimisation: half the time, or three quarters.
set(JOINTID_LIBRARY_KIND STATIC)
if(CMAKE_BUILD_TYPE MATCHES "^(Dev|Asan)$")
  set(JOINTID_LIBRARY_KIND SHARED)
  set(CMAKE_INSTALL_RPATH "\$ORIGIN;\$ORIGIN/jointid;\$ORIGIN/..") # of installed libraries to each other and to modules, and back
  string(APPEND CMAKE_SHARED_LINKER_FLAGS " -Wl,-Bsymbolic-functions")
endif()

add_library(jointid_warnings INTERFACE)
target_compile_options(jointid_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion
                                                  # Sources compiled as one see each other's names.
                                                  $<$<NOT:$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wshadow>
                                                  $<$<BOOL:${JOINTID_WERROR}>:-Werror>)

# jointid_precompile(target KIND LEVEL): the standard headers and Eigen's, which most sources read, are read once for all targets of a KIND
# (LIBRARY, PROGRAM, TEST) and LEVEL (O0, O1, O2). Sources name what they use all the same: preset asan compiles libraries without.
option(JOINTID_PRECOMPILE "Precompile the headers that most sources read" ON)
set(JOINTID_PRECOMPILED
    <algorithm> <array> <atomic> <cmath> <complex> <cstddef> <cstdint> <filesystem> <fstream> <functional> <map> <memory> <mutex> <numbers>
    <numeric> <optional> <random> <ranges> <set> <span> <sstream> <stdexcept> <string> <string_view> <tuple> <utility> <variant> <vector>
    <Eigen/Core> <dense/products.hpp>)

function(jointid_precompile target kind level)
  if(NOT JOINTID_PRECOMPILE OR (CMAKE_BUILD_TYPE STREQUAL "Asan" AND NOT kind STREQUAL "TEST"))
    return()
  endif()
  if(NOT target MATCHES "^jointid_(base|dense)$")
    target_link_libraries(${target} PRIVATE jointid_dense) # products.hpp
  endif()
  string(TOLOWER "jointid_headers_${kind}_${level}" headers)
  if(NOT TARGET ${headers})
    set(source "${PROJECT_BINARY_DIR}/${headers}.cpp")
    if(kind STREQUAL "LIBRARY")
      file(CONFIGURE OUTPUT "${source}" CONTENT "")
      add_library(${headers} OBJECT EXCLUDE_FROM_ALL "${source}")
    else()
      file(CONFIGURE OUTPUT "${source}" CONTENT "int main() {}\n")
      add_executable(${headers} EXCLUDE_FROM_ALL "${source}")
    endif()
    target_compile_features(${headers} PRIVATE cxx_std_20)
    target_compile_options(${headers} PRIVATE -${level}
                           "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>") # for ccache
    target_link_libraries(${headers} PRIVATE Eigen3::Eigen jointid_warnings)
    target_include_directories(${headers} PRIVATE "${PROJECT_SOURCE_DIR}")
    target_precompile_headers(${headers} PRIVATE ${JOINTID_PRECOMPILED})
    if(kind STREQUAL "TEST")
      target_precompile_headers(${headers} PRIVATE <gmock/gmock.h> <gtest/gtest.h>)
      target_link_libraries(${headers} PRIVATE GTest::gmock)
    endif()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${headers})
endfunction()

# jointid_library(frf SOURCES … PUBLIC … PRIVATE … [LEVEL O2] [NO_LOOPS]): the folder's namespace, target jointid::frf and headers. LEVEL
# O2: hot loops in any source; elsewhere they are kernels (base/kernel.hpp) or Eigen's products (dense/products.hpp), which have a level of
# their own. NO_LOOPS: none at all; sanitized without optimisation, which takes half of the time to build.
function(jointid_library name)
  cmake_parse_arguments(arg "NO_LOOPS" "LEVEL" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  set(target jointid_${name})
  add_library(${target} ${JOINTID_LIBRARY_KIND} ${arg_SOURCES})
  add_library(jointid::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}" FILES ${arg_HEADERS})
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
                                              "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/jointid>"
                                              "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  target_compile_features(${target} PUBLIC cxx_std_20)
  if(NOT arg_LEVEL)
    set(arg_LEVEL O1)
  endif()
  if(NOT CMAKE_BUILD_TYPE STREQUAL "Asan")
    target_compile_options(${target} PRIVATE -${arg_LEVEL})
  elseif(arg_NO_LOOPS)
    target_compile_options(${target} PRIVATE -O0)
  endif()
  jointid_precompile(${target} LIBRARY ${arg_LEVEL})
  if(NOT name STREQUAL "base")
    list(APPEND arg_PUBLIC jointid::base) # every folder may include it
  endif()
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:jointid_warnings>)
  install(TARGETS ${target} EXPORT jointid-targets
          FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/jointid")
endfunction()

# jointid_installed_program(jointid command): installed, as part of a package, it finds modules, and libraries where these are shared.
function(jointid_installed_program target component)
  file(RELATIVE_PATH libraries "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_LIBDIR}")
  set_target_properties(${target} PROPERTIES INSTALL_RPATH "\$ORIGIN/${libraries}/jointid;\$ORIGIN/${libraries}")
  install(TARGETS ${target} RUNTIME COMPONENT ${component})
endfunction()

# jointid_module(ceres SOURCES … LINK … [COMPONENT solvers]): what calls a library that most runs do not need; loaded when it is
# (base/module.hpp). The targets `modules` are built with the command, the tests and the benchmarks. COMPONENT: of which package it is
# part, by default the command's.
add_custom_target(modules)
set(JOINTID_MODULES "${PROJECT_BINARY_DIR}/modules")
set(CMAKE_BUILD_RPATH "${JOINTID_MODULES}")
option(JOINTID_SAME_BYTES "What is linked has the same bytes in every clone; programs then find modules from their own folder alone" OFF)
if(JOINTID_SAME_BYTES) # installation replaces a path, and leaves the room that a longer one took
  set(CMAKE_BUILD_RPATH "\$ORIGIN/../modules;\$ORIGIN/../../modules")
  set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)
endif()
set(JOINTID_INSTALL_MODULES "${CMAKE_INSTALL_LIBDIR}/jointid")

function(jointid_module name)
  cmake_parse_arguments(arg "" "COMPONENT" "SOURCES;LINK" ${ARGN})
  if(NOT arg_COMPONENT)
    set(arg_COMPONENT command)
  endif()
  set(target jointid_module_${name})
  add_library(${target} MODULE ${arg_SOURCES})
  set_target_properties(${target} PROPERTIES PREFIX "" OUTPUT_NAME jointid_${name} LIBRARY_OUTPUT_DIRECTORY "${JOINTID_MODULES}")
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target} PRIVATE ${arg_LINK} jointid_warnings)
  target_link_options(${target} PRIVATE LINKER:--exclude-libs,ALL)
  add_dependencies(modules ${target})
  install(TARGETS ${target} LIBRARY DESTINATION "${JOINTID_INSTALL_MODULES}" COMPONENT ${arg_COMPONENT})
endfunction()

# jointid_commit(target header namespace): built_from() of the header, with the commit, which every build asks for; its object changes with
# the commit alone.
function(jointid_commit target header namespace)
  set(commit "${CMAKE_CURRENT_BINARY_DIR}/commit.cpp")
  add_custom_target(${target}_commit BYPRODUCTS "${commit}"
    COMMAND "${CMAKE_COMMAND}" "-DSOURCE=${PROJECT_SOURCE_DIR}" "-DOUT=${commit}" "-DHEADER=${header}" "-DNAMESPACE=${namespace}"
            -P "${PROJECT_SOURCE_DIR}/cmake/JointidCommit.cmake")
  target_sources(${target} PRIVATE "${commit}")
  set_source_files_properties("${commit}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
  add_dependencies(${target} ${target}_commit)
endfunction()
