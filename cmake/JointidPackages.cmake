# Debian packages by CPack, from components of the installation; scripts/package makes what is not compiled (man pages, completion, the
# Python package's place, the site) and calls it.
set(JOINTID_PACKAGE_FILES "" CACHE PATH "Folder with what scripts/package makes for packages: command, python, site, doc")
if(NOT JOINTID_PACKAGE_FILES)
  return()
endif()

set(_packages command solvers)
install(DIRECTORY "${JOINTID_PACKAGE_FILES}/command/" DESTINATION "${CMAKE_INSTALL_DATADIR}" COMPONENT command)
if(TARGET jointid_module_mpi)
  list(APPEND _packages mpi)
endif()
if(JOINTID_WITH_DESKTOP)
  list(APPEND _packages workbench)
  install(DIRECTORY "${JOINTID_PACKAGE_FILES}/workbench/" DESTINATION "${CMAKE_INSTALL_DATADIR}" COMPONENT workbench)
endif()
list(APPEND _packages dev)
if(JOINTID_WITH_PYTHON)
  list(APPEND _packages python)
  set(_python "lib/python3/dist-packages/jointid")
  install(TARGETS jointid_python LIBRARY DESTINATION "${_python}" COMPONENT python)
  install(DIRECTORY python/jointid/ DESTINATION "${_python}" COMPONENT python FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed)
  install(DIRECTORY "${JOINTID_PACKAGE_FILES}/python/" DESTINATION "${_python}" COMPONENT python) # modules: a link to the command's
endif()
list(APPEND _packages doc)
install(DIRECTORY "${JOINTID_PACKAGE_FILES}/site/" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/jointid-doc" COMPONENT doc)

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL ${_packages})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_NAME jointid)
set(CPACK_PACKAGE_VENDOR "The jointid authors")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
# Whoever packs them for others: DEBFULLNAME and DEBEMAIL, as of Debian's own tools.
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The jointid authors <jointid@localhost>")
if(DEFINED ENV{DEBEMAIL})
  set(CPACK_DEBIAN_PACKAGE_MAINTAINER "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

# jointid_package(COMPONENT package section "short" "long" [depends] [recommends] [suggests])
macro(jointid_package component package section short long)
  string(TOUPPER "${component}" _upper)
  install(DIRECTORY "${JOINTID_PACKAGE_FILES}/doc/" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT ${component})
  set(CPACK_DEBIAN_${_upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${_upper}_PACKAGE_SECTION ${section})
  set(CPACK_COMPONENT_${_upper}_DESCRIPTION "${short}\n${long}")
endmacro()

set(_same "(= ${PROJECT_VERSION}-1)")
jointid_package(command jointid science "joints of structures from measured frequency response functions"
  "Identifies stiffness, mass and damping matrices of joints between\nsubstructures, with intervals. Reads universal files (58, 58b), CSV, HDF5,\nMATLAB files, numpy arrays.")
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS "jointid-solvers")
set(CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS "jointid-workbench, python3-jointid, jointid-doc, jointid-mpi")
jointid_package(solvers jointid-solvers science "solvers of jointid that need large libraries"
  "SPQR and CHOLMOD for many joints, Ceres and Ipopt, products by OpenBLAS.\nThese modules are under the GPL.")
set(CPACK_DEBIAN_SOLVERS_PACKAGE_DEPENDS "jointid ${_same}")
jointid_package(mpi jointid-mpi science "studies of jointid shared among processes"
  "The module that mpirun needs to share the trials of a study or the lines of\na scene.")
set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "jointid ${_same}, openmpi-bin")
jointid_package(workbench jointid-workbench science "desktop workbench of jointid"
  "Files, geometry, joint, solution, checks and curves by mouse and keyboard.\nUnder the GPL version 3, as it links QCustomPlot.")
set(CPACK_DEBIAN_WORKBENCH_PACKAGE_DEPENDS "jointid ${_same}")
set(CPACK_DEBIAN_WORKBENCH_PACKAGE_RECOMMENDS "qt6-translations-l10n")
jointid_package(dev libjointid-dev libdevel "headers and static libraries of jointid"
  "For C++20 programs: find_package(jointid). Every command is a call of the\nlibrary.")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS # what jointid-config.cmake finds
  "jointid ${_same}, pkg-config, libeigen3-dev, libfmt-dev, nlohmann-json3-dev, libtbb-dev, libtomlplusplus-dev")
jointid_package(python python3-jointid python "joints of structures from measured frequency response functions (Python)"
  "Arrays in, joint with uncertainty out. Bridges to pyFBS, SDynPy and pyuff.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "jointid ${_same}, python3 (>= ${JOINTID_PYTHON_FROM}), python3 (<< ${JOINTID_PYTHON_BELOW}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-xarray, python3-openpyxl")
jointid_package(doc jointid-doc doc "documentation of jointid"
  "Tutorials, how-to pages, reference and formulas as pages that are searched\nwithout a network.")
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)

include(CPack)
