# Copies the libraries that `programs` and `modules` are linked with beside the modules, where the run path of the programs
# finds them, each with the licence that its Debian package states.
#
# Left out is what every system has and must be the system's own (the C and C++ run-time libraries), and what a desktop
# brings: Qt, whose plugins, fonts and drivers would have to come along.
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${programs} MODULES ${modules}
     RESOLVED_DEPENDENCIES_VAR found UNRESOLVED_DEPENDENCIES_VAR missing
     PRE_EXCLUDE_REGEXES "^lib(c|m|dl|rt|pthread|resolv|nsl|util|stdc\\+\\+|gcc_s)\\.so" "^ld-linux"
                         "^libQt6" "^lib(GL|EGL|OpenGL)" "^sarsim_")
if(missing)
  message(FATAL_ERROR "These libraries were not found: ${missing}")
endif()

set(prefix "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}")
file(MAKE_DIRECTORY ${prefix}/${library_folder} ${prefix}/share/doc/sarsim/licences)
find_program(DPKG_QUERY dpkg-query)
foreach(library IN LISTS found)
  get_filename_component(name ${library} NAME)
  message(STATUS "Bundling: ${name}")
  file(REAL_PATH ${library} whole)
  file(COPY_FILE ${whole} ${prefix}/${library_folder}/${name})  # Under the one name that is looked for.
  if(DPKG_QUERY)
    execute_process(COMMAND ${DPKG_QUERY} -S ${whole} OUTPUT_VARIABLE owner ERROR_QUIET)
    string(REGEX REPLACE "[:,].*" "" package "${owner}")
    string(STRIP "${package}" package)
    if(package AND EXISTS /usr/share/doc/${package}/copyright)
      configure_file(/usr/share/doc/${package}/copyright ${prefix}/share/doc/sarsim/licences/${package} COPYONLY)
    endif()
  endif()
endforeach()
