# Packages by CPack: cpack -G DEB makes Debian packages, cpack -G TGZ a tarball that runs wherever it is unpacked.
# tools/package does both; docs/developer/releasing.md describes what is in them and why.
set(CPACK_PACKAGE_NAME sarsim)
set(CPACK_PACKAGE_VERSION ${SARSIM_VERSION_PACKAGE})
set(CPACK_PACKAGE_VENDOR "The Sarsim developers")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES TRUE)
set(CPACK_VERBATIM_VARIABLES TRUE)
set(CPACK_THREADS 0)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_SOURCE_DIR}/cmake/SarsimPackageKinds.cmake)

# Whoever builds packages is their maintainer, named as Debian's own tools ask for it.
set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
if(NOT maintainer MATCHES "^[^ ].* <.+@.+>$")
  set(maintainer "The Sarsim developers <sarsim@localhost>")
endif()
set(CPACK_PACKAGE_CONTACT ${maintainer})

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(same "(= ${SARSIM_VERSION_PACKAGE})")

set(sentence "Sarsim computes what a pulse radar receives from targets and surfaces on
moving platforms, as complex baseband samples, and makes images of it.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME sarsim)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "radar echo simulator
${sentence}
.
This is the command with its module for pictures, examples and
documentation.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libsarsim0 ${same}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "sarsim-gui ${same}")

# The library has one interface of numbered functions: what was linked with an older one runs with it.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libsarsim0)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "radar echo simulator: library
${sentence}
.
This is the shared library for programs in C and for languages that call C,
with the module for HDF5, which the command uses as well.")

set(CPACK_DEBIAN_HEADER_PACKAGE_NAME libsarsim-dev)
set(CPACK_DEBIAN_HEADER_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_HEADER_PACKAGE_DEPENDS "libsarsim0 ${same}")
set(CPACK_DEBIAN_HEADER_DESCRIPTION "radar echo simulator: header for C
${sentence}
.
This is the header of the shared library, and what pkg-config says of it.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-sarsim)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "libsarsim0 ${same}, python3 (>= 3.9), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-xarray, python3-tqdm, python3-distributed, jupyter-notebook")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/packaging/debian/python/postinst
    ${CMAKE_SOURCE_DIR}/packaging/debian/python/prerm)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "radar echo simulator: Python package
${sentence}
.
This is the package for Python, with ten lessons as notebooks.")

set(CPACK_DEBIAN_WORKBENCH_PACKAGE_NAME sarsim-gui)
set(CPACK_DEBIAN_WORKBENCH_DESCRIPTION "radar echo simulator: workbench
${sentence}
.
This is the graphical program, which builds scenes on screen and shows their
echoes at once.")
set(CPACK_DEBIAN_WORKBENCH_PACKAGE_DEPENDS "sarsim ${same}")

set(CPACK_DEBIAN_MPI_PACKAGE_NAME sarsim-mpi)
set(CPACK_DEBIAN_MPI_DESCRIPTION "radar echo simulator: one recording by an MPI job
${sentence}
.
This is the program for the processes of an MPI job.")
set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "sarsim ${same}")
set(CPACK_DEBIAN_MPI_PACKAGE_RECOMMENDS "openmpi-bin")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME sarsim-dev)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "radar echo simulator: libraries for C++
${sentence}
.
These are the headers, the static libraries and the CMake package.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "sarsim ${same}, libfftw3-dev, libfmt-dev, libhwy-dev, libxxhash-dev, liberfa-dev, libpugixml-dev, pkg-config | pkgconf")

# Every Debian package states its licence and its last change.
set(change_date "${SARSIM_VERSION_DATE}")
if(NOT change_date)
  string(TIMESTAMP change_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
endif()
configure_file(packaging/debian/changelog.in ${CMAKE_BINARY_DIR}/generated/changelog @ONLY)
set(debian_files ${CMAKE_SOURCE_DIR}/packaging/debian/copyright)
if(SARSIM_GZIP)
  execute_process(COMMAND ${SARSIM_GZIP} -9nc ${CMAKE_BINARY_DIR}/generated/changelog
                  OUTPUT_FILE ${CMAKE_BINARY_DIR}/generated/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
  list(APPEND debian_files ${CMAKE_BINARY_DIR}/generated/changelog.gz)
endif()
set(SARSIM_PACKAGES program)
install(FILES ${debian_files} DESTINATION share/doc/sarsim COMPONENT program)
foreach(pair sarsim_shared:library sarsim_shared:header sarsim_shared:python sarsim-gui:workbench sarsim-mpi:mpi sarsim_core:development)
  string(REPLACE ":" ";" pair ${pair})
  list(POP_FRONT pair target component)
  if(TARGET ${target})
    string(TOUPPER ${component} upper)
    list(APPEND SARSIM_PACKAGES ${component})
    install(FILES ${debian_files} DESTINATION share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME} COMPONENT ${component})
  endif()
endforeach()
# The guide as pages of HTML, where the target `site` builds them, belongs to the package of the command.
if(TARGET site)
  list(APPEND SARSIM_PACKAGES guide)
endif()
foreach(component program guide)
  string(TOUPPER ${component} upper)
  set(CPACK_COMPONENT_${upper}_GROUP program)
endforeach()
set(CPACK_SARSIM_PACKAGES ${SARSIM_PACKAGES})
set(CPACK_SARSIM_TARBALL sarsim-${SARSIM_VERSION_PACKAGE}-linux-${CMAKE_SYSTEM_PROCESSOR})
include(CPack)
