# Writes the source file that says what the programs were built from, at every build but only where that changed:
#
#   cmake -D SOURCE=... -D NUMBER=... -D STAMP=... -D TEMPLATE=... -D OUT=... -D TYPE=... -D COMPILER=... -D SYSTEM=... -P this
include(${CMAKE_CURRENT_LIST_DIR}/SarsimVersion.cmake)
sarsim_find_version(${SOURCE} SARSIM)
if(NOT SARSIM_NUMBER STREQUAL NUMBER)
  # Headers hold the number, so it is the configuration that has to learn of it.
  file(TOUCH ${STAMP})
  message(FATAL_ERROR "The version changed from ${NUMBER} to ${SARSIM_NUMBER}: start the build once more")
endif()
configure_file(${TEMPLATE} ${OUT} @ONLY)
