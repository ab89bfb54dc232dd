# cmake -DBUILD=… -DOUTSIDE=… -DWORK=… -DGENERATOR=… -DCOMPILER=… -P install_and_link.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${WORK}/prefix")
run(${CMAKE_COMMAND} -S "${OUTSIDE}" -B "${WORK}/build" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_PREFIX_PATH=${WORK}/prefix" -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build "${WORK}/build")
run("${WORK}/build/outside" "${WORK}")

# The command without a module: it says so, and what needs none works.
function(expect code pattern)
  execute_process(COMMAND "${WORK}/prefix/bin/jointid" ${ARGN} WORKING_DIRECTORY "${WORK}" RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result STREQUAL "${code}" OR NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "jointid ${ARGN}: exit code ${result} instead of ${code}, or no '${pattern}' in:\n${text}")
  endif()
endfunction()

file(WRITE "${WORK}/a.csv" "# quantity = receptance\nfrequency_hz, 1:+Y/1:+Y re, 1:+Y/1:+Y im\n10, 1e-6, -1e-8\n20, 2e-6, -1e-8\n")
file(GLOB_RECURSE hdf5 "${WORK}/prefix/jointid_hdf5.so" "${WORK}/prefix/lib*/jointid_hdf5.so")
list(LENGTH hdf5 found)
if(NOT found EQUAL 1)
  message(FATAL_ERROR "installed modules hdf5: '${hdf5}'")
endif()
expect(0 "HDF5[^\n]*: yes" --version)
expect(0 "" convert a.csv a.h5)
expect(0 "receptance" info a.h5)
file(WRITE "${hdf5}" "no library")
expect(2 "jointid_hdf5.so" info a.h5)
file(REMOVE "${hdf5}")
expect(0 "HDF5[^\n]*: no, this build lacks HDF5" --version)
expect(2 "module jointid_hdf5.so: an HDF5 or MATLAB v7.3 file needs it: this build lacks it" info a.h5)
expect(0 "" convert a.csv b.uff)
