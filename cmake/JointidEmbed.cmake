# jointid_embed(TARGET NAMESPACE file…): puts text files into a target, each as the std::string_view NAMESPACE::NAME with
# every character of the file's name that is not a letter or digit an underscore (page.js: page_js). The header that declares
# them is written by hand. A file may be at most 65536 bytes long, the longest string literal that compilers have to take.
function(jointid_embed target namespace)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${target}_embedded.cpp")
  list(TRANSFORM ARGN PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" OUTPUT_VARIABLE files)
  add_custom_command(OUTPUT "${source}"
    COMMAND "${CMAKE_COMMAND}" "-DOUT=${source}" "-DNAMESPACE=${namespace}" "-DFILES=${files}" -P
            "${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake"
    DEPENDS ${files} "${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake"
    VERBATIM)
  target_sources(${target} PRIVATE "${source}")
endfunction()
