# Pages of the documentation: their marked blocks run, their language keeps to docs/glossary.md.
if(CMAKE_BUILD_TYPE STREQUAL "Asan" OR NOT DEFINED Python_EXECUTABLE)
  return() # the same commands run there as tests of the commands
endif()
add_test(NAME docs.language COMMAND "${Python_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/scripts/check-docs-language")
add_test(NAME docs.checkers COMMAND "${Python_EXECUTABLE}" "${CMAKE_CURRENT_LIST_DIR}/test_check_docs.py" "$<TARGET_FILE:jointid>")
set_tests_properties(docs.checkers PROPERTIES ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1")

execute_process(COMMAND "${Python_EXECUTABLE}" -c "import numpy" RESULT_VARIABLE _without OUTPUT_QUIET ERROR_QUIET)
set(_package "")
if(JOINTID_WITH_PYTHON AND NOT _without)
  set(_package --python "${PROJECT_BINARY_DIR}/python")
endif()
file(GLOB _pages CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/docs/*-199?.md"
  "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/docs/tutorials/*.md" "${PROJECT_SOURCE_DIR}/docs/how-to/*.md")
foreach(_page IN LISTS _pages)
  file(STRINGS "${PROJECT_SOURCE_DIR}/${_page}" _marks REGEX "^<!-- run")
  if(NOT _marks)
    continue()
  endif()
  get_filename_component(_name "${_page}" NAME_WE)
  if(_without AND _name STREQUAL "hammer-records")
    jointid_missing(docs.commands.${_name} "numpy is missing for ${Python_EXECUTABLE}")
    continue()
  endif()
  add_test(NAME docs.commands.${_name}
    COMMAND "${Python_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/scripts/check-docs-commands" "$<TARGET_FILE:jointid>" ${_package}
            "${PROJECT_SOURCE_DIR}/${_page}")
  set_tests_properties(docs.commands.${_name} PROPERTIES TIMEOUT 300)
endforeach()
