# The library sarsim_build: what the programs were built from. Apart from all others, so that a new commit compiles this
# one small file and links the programs again, and nothing else.
set(stamp ${CMAKE_BINARY_DIR}/CMakeFiles/sarsim-version.stamp)
if(NOT EXISTS ${stamp})
  file(TOUCH ${stamp})
endif()
set(version_depends ${stamp})
sarsim_git(${CMAKE_SOURCE_DIR} git_folder rev-parse --path-format=absolute --git-common-dir)
foreach(place refs/tags packed-refs)
  if(git_folder AND EXISTS ${git_folder}/${place})
    list(APPEND version_depends ${git_folder}/${place})
  endif()
endforeach()
set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${version_depends}
             ${CMAKE_SOURCE_DIR}/CITATION.cff)

set(build_type ${CMAKE_BUILD_TYPE})
if(SARSIM_SANITIZE)
  string(APPEND build_type " with sanitizers ${SARSIM_SANITIZE}")
endif()
add_custom_target(sarsim_commit
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${CMAKE_SOURCE_DIR} -D NUMBER=${PROJECT_VERSION} -D STAMP=${stamp}
          -D TEMPLATE=${CMAKE_CURRENT_SOURCE_DIR}/core/build/build.cpp.in -D OUT=${CMAKE_BINARY_DIR}/generated/core/build/build.cpp
          -D "TYPE=${build_type}" -D "COMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
          -D "SYSTEM=${CMAKE_SYSTEM_NAME} ${CMAKE_SYSTEM_PROCESSOR}" -P ${CMAKE_SOURCE_DIR}/cmake/WriteBuild.cmake
  BYPRODUCTS ${CMAKE_BINARY_DIR}/generated/core/build/build.cpp
  COMMENT "" VERBATIM)
add_library(sarsim_build STATIC ${CMAKE_BINARY_DIR}/generated/core/build/build.cpp)
add_dependencies(sarsim_build sarsim_commit)
target_link_libraries(sarsim_build PUBLIC sarsim_flags)
