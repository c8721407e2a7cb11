# What `cmake --install` puts where, beside the programs and the module. Included at the end of src/, where the targets are.
#
# Components, each a Debian package: program (sarsim), library (libsarsim0), workbench (sarsim-gui), mpi (sarsim-mpi), header
# (libsarsim-dev), python (python3-sarsim), development (sarsim-dev).
# Three more: guide, pages of HTML that belong to sarsim where they were built; licence, which a distribution has elsewhere;
# and libraries, which only the tarball has.
include(CMakePackageConfigHelpers)

set(packaging ${CMAKE_SOURCE_DIR}/packaging)
set(generated ${CMAKE_BINARY_DIR}/generated)
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION share/doc/sarsim COMPONENT licence)

# Manual pages carry the version. They are compressed in the one way that gives the same bytes every time.
find_program(SARSIM_GZIP gzip)
mark_as_advanced(SARSIM_GZIP)
function(sarsim_install_page name component)
  set(page ${generated}/${name}.1)
  configure_file(${CMAKE_SOURCE_DIR}/docs/${name}.1 ${page} @ONLY)
  set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/docs/${name}.1)
  if(SARSIM_GZIP)
    execute_process(COMMAND ${SARSIM_GZIP} -9nc ${page} OUTPUT_FILE ${page}.gz COMMAND_ERROR_IS_FATAL ANY)
    set(page ${page}.gz)
  endif()
  install(FILES ${page} DESTINATION share/man/man1 COMPONENT ${component})
endfunction()

# The command: manual page, completion, examples, documentation.
sarsim_install_page(sarsim program)
if(NOT CMAKE_CROSSCOMPILING)
  set(completion ${CMAKE_BINARY_DIR}/completion)
  file(MAKE_DIRECTORY ${completion})
  foreach(shell bash zsh fish)
    add_custom_command(TARGET sarsim POST_BUILD COMMAND sarsim completion ${shell} > ${completion}/${shell} VERBATIM)
  endforeach()
  install(FILES ${completion}/bash DESTINATION share/bash-completion/completions RENAME sarsim COMPONENT program)
  foreach(folder site-functions vendor-completions)  # In /usr/local zsh looks at the one, in Debian's /usr at the other.
    install(FILES ${completion}/zsh DESTINATION share/zsh/${folder} RENAME _sarsim COMPONENT program)
  endforeach()
  install(FILES ${completion}/fish DESTINATION share/fish/vendor_completions.d RENAME sarsim.fish COMPONENT program)
endif()
install(DIRECTORY ${CMAKE_SOURCE_DIR}/examples DESTINATION share/sarsim COMPONENT program)
install(FILES ${CMAKE_SOURCE_DIR}/docs/formats/sarsim-2.schema.json DESTINATION share/sarsim COMPONENT program)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs/ DESTINATION share/doc/sarsim COMPONENT program
        FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.svg" PATTERN developer EXCLUDE)
# The workbench: entry in menus, icons, the type of scripts.
if(TARGET sarsim-gui)
  sarsim_install_page(sarsim-gui workbench)
  install(FILES ${packaging}/sarsim-gui.desktop DESTINATION share/applications COMPONENT workbench)
  install(FILES ${packaging}/sarsim.xml DESTINATION share/mime/packages COMPONENT workbench)
  install(DIRECTORY ${packaging}/icons/hicolor DESTINATION share/icons COMPONENT workbench)
endif()

if(TARGET sarsim-mpi)
  sarsim_install_page(sarsim-mpi mpi)
endif()

# The library for C, with its header and what pkg-config says of it.
install(TARGETS sarsim_shared LIBRARY DESTINATION lib COMPONENT library NAMELINK_COMPONENT header)
install(FILES ${CMAKE_CURRENT_SOURCE_DIR}/capi/sarsim.h DESTINATION include COMPONENT header)
configure_file(${CMAKE_SOURCE_DIR}/cmake/sarsim.pc.in ${generated}/sarsim.pc @ONLY)
install(FILES ${generated}/sarsim.pc DESTINATION lib/pkgconfig COMPONENT header)

# The package for Python, which finds the library as programs do.
install(DIRECTORY ${CMAKE_SOURCE_DIR}/python/sarsim DESTINATION lib/python3/dist-packages COMPONENT python
        FILES_MATCHING PATTERN "*.py" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs/guide/notebooks DESTINATION share/doc/python3-sarsim COMPONENT python
        FILES_MATCHING PATTERN "*.ipynb")

# The libraries for C++: the folders from core to picture, with the headers that are not private to a layer.
set(libraries core radar signal scene raster simulate workflow picture)
foreach(name IN LISTS libraries)
  set_target_properties(sarsim_${name} PROPERTIES EXPORT_NAME ${name})
  add_library(Sarsim::${name} ALIAS sarsim_${name})
  install(TARGETS sarsim_${name} EXPORT SarsimTargets ARCHIVE DESTINATION lib COMPONENT development)
  install(DIRECTORY ${name} DESTINATION include/sarsim COMPONENT development FILES_MATCHING PATTERN "*.hpp"
          PATTERN "*-inl.hpp" EXCLUDE PATTERN "*_test_*" EXCLUDE PATTERN "hdf5_*" EXCLUDE PATTERN "drawing" EXCLUDE
          PATTERN "facts" EXCLUDE PATTERN "build.hpp" EXCLUDE)
endforeach()
install(FILES ${generated}/core/build/version.hpp DESTINATION include/sarsim/core/build COMPONENT development)
set_target_properties(sarsim_flags PROPERTIES EXPORT_NAME flags)
install(TARGETS sarsim_flags EXPORT SarsimTargets)
install(EXPORT SarsimTargets NAMESPACE Sarsim:: DESTINATION lib/cmake/Sarsim COMPONENT development)

configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/SarsimConfig.cmake.in ${generated}/SarsimConfig.cmake
                              INSTALL_DESTINATION lib/cmake/Sarsim NO_SET_AND_CHECK_MACRO)
# Until 1.0 the interfaces may change with every minor version.
write_basic_package_version_file(${generated}/SarsimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${generated}/SarsimConfig.cmake ${generated}/SarsimConfigVersion.cmake
        DESTINATION lib/cmake/Sarsim COMPONENT development)

# What the tarball needs to run where nothing is installed: cmake --install FOLDER --component libraries.
set(bundled_programs $<TARGET_FILE:sarsim>)
if(TARGET sarsim-gui)
  list(APPEND bundled_programs $<TARGET_FILE:sarsim-gui>)
endif()
install(CODE "set(programs \"${bundled_programs}\")
set(modules \"$<TARGET_FILE:sarsim_shared>;$<TARGET_FILE:sarsim_hdf5>;$<TARGET_FILE:sarsim_drawing>\")
set(library_folder \"${SARSIM_MODULE_FOLDER}\")" COMPONENT libraries EXCLUDE_FROM_ALL)
install(SCRIPT ${CMAKE_SOURCE_DIR}/cmake/BundleLibraries.cmake COMPONENT libraries EXCLUDE_FROM_ALL)
