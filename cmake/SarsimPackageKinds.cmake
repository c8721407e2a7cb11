# Read by cpack once for each kind of package.
if(CPACK_GENERATOR STREQUAL "DEB")
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
  set(CPACK_COMPONENTS_ALL ${CPACK_SARSIM_PACKAGES})
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
else()
  # One archive with its libraries. Without sarsim-mpi, which has to be built with the MPI of its cluster, and without the
  # libraries for C++, which are linked against the libraries of the system; the package for Python has its wheel.
  set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
  set(CPACK_COMPONENTS_ALL ${CPACK_SARSIM_PACKAGES} licence libraries)
  list(REMOVE_ITEM CPACK_COMPONENTS_ALL mpi development python)
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
  set(CPACK_PACKAGE_FILE_NAME ${CPACK_SARSIM_TARBALL})
endif()
