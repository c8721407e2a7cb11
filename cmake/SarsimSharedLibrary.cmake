# libsarsim.so.0, the C interface: the folder capi with what it uses of the static libraries, and no name but those of
# sarsim.h. Beside it, as beside the programs, lies the module that reads and writes HDF5.
set(map ${CMAKE_CURRENT_SOURCE_DIR}/capi/sarsim.map)
add_library(sarsim_shared SHARED $<TARGET_OBJECTS:sarsim_capi>)
target_link_libraries(sarsim_shared PRIVATE sarsim_workflow)
target_include_directories(sarsim_shared INTERFACE ${CMAKE_CURRENT_SOURCE_DIR}/capi)
target_link_options(sarsim_shared PRIVATE LINKER:--version-script=${map} LINKER:--exclude-libs,ALL)
if(NOT SARSIM_SANITIZE)
  target_link_options(sarsim_shared PRIVATE LINKER:-z,defs)
endif()
set_target_properties(sarsim_shared PROPERTIES OUTPUT_NAME sarsim LINKER_LANGUAGE CXX VERSION 0 SOVERSION 0
                      LINK_DEPENDS ${map} LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib INSTALL_RPATH "$ORIGIN/sarsim"
                      BUILD_WITH_INSTALL_RPATH ON)
