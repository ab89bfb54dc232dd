# cmake -DSOURCE=… -DOUT=commit.cpp -DHEADER=cli/provenance/provenance.hpp -DNAMESPACE=jointid::cli -P JointidCommit.cmake: writes the commit
# of the clone at SOURCE into OUT, as built_from() of the header, if it is another one.
execute_process(COMMAND git describe --always --dirty --abbrev=40 --exclude "*" WORKING_DIRECTORY "${SOURCE}"
                OUTPUT_VARIABLE _commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE _failed)
if(_failed)
  set(_commit unknown)
  if(DEFINED ENV{JOINTID_COMMIT}) # sources without their clone
    set(_commit "$ENV{JOINTID_COMMIT}")
  endif()
endif()
set(_text "#include \"${HEADER}\"\n\nstd::string ${NAMESPACE}::built_from() { return \"${_commit}\"; }\n")
if(EXISTS "${OUT}")
  file(READ "${OUT}" _before)
endif()
if(NOT "${_before}" STREQUAL "${_text}")
  file(WRITE "${OUT}" "${_text}")
endif()
