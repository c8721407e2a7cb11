# The version, in one place for the build, the packages and `sarsim --version`: the last tag vX.Y.Z that a commit contains.
#
#   sarsim_find_version(FOLDER PREFIX)
#
# sets for the sources in FOLDER
#   PREFIX_NUMBER   X.Y.Z, of the tag; where there is none, of CITATION.cff
#   PREFIX_COMMIT   twelve digits of the commit; empty where it is unknown
#   PREFIX_TAG      that tag; empty where there is none
#   PREFIX_AHEAD    commits since the tag, or, where there is none, since the beginning; empty where it is unknown
#   PREFIX_CHANGED  TRUE where files differ from the commit
#   PREFIX_DATE     when the commit was made, as a Debian changelog writes it; empty where it is unknown
#   PREFIX_PACKAGE  the version as packages carry it: 0.1.0, later 0.1.0+5.g9407791ab012, before the first tag 0.1.0~246.g...
#   PREFIX_TEXT     where the sources stand, in words; empty where they are those of the tag
#
# It looks at git, or at what `git archive` wrote into cmake/archive-version.txt.

function(sarsim_git folder result)
  execute_process(COMMAND ${GIT_EXECUTABLE} --no-optional-locks ${ARGN} WORKING_DIRECTORY ${folder}
                  RESULT_VARIABLE failure OUTPUT_VARIABLE answer ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT failure EQUAL 0)
    set(answer "")
  endif()
  set(${result} "${answer}" PARENT_SCOPE)
endfunction()

# What `git describe --long` says: tag, distance, commit.
function(sarsim_read_description description)
  if(description MATCHES "^(v([0-9]+\\.[0-9]+\\.[0-9]+))-([0-9]+)-g([0-9a-f]+)$")
    set(tag ${CMAKE_MATCH_1} PARENT_SCOPE)
    set(number ${CMAKE_MATCH_2} PARENT_SCOPE)
    set(ahead ${CMAKE_MATCH_3} PARENT_SCOPE)
    set(commit ${CMAKE_MATCH_4} PARENT_SCOPE)
  elseif(description MATCHES "^(v([0-9]+\\.[0-9]+\\.[0-9]+))$")
    set(tag ${CMAKE_MATCH_1} PARENT_SCOPE)
    set(number ${CMAKE_MATCH_2} PARENT_SCOPE)
    set(ahead 0 PARENT_SCOPE)
  endif()
endfunction()

# The number that the tree itself carries, for whoever has neither git nor tags.
function(sarsim_number_of_citation folder result)
  file(STRINGS ${folder}/CITATION.cff line REGEX "^version: " LIMIT_COUNT 1)
  if(NOT line MATCHES "^version: ([0-9]+\\.[0-9]+\\.[0-9]+)$")
    message(FATAL_ERROR "${folder}/CITATION.cff has no line 'version: X.Y.Z'")
  endif()
  set(${result} ${CMAKE_MATCH_1} PARENT_SCOPE)
endfunction()

function(sarsim_find_version folder prefix)
  sarsim_number_of_citation(${folder} number)
  foreach(name tag ahead commit date)
    set(${name} "")
  endforeach()
  set(changed FALSE)

  find_program(GIT_EXECUTABLE git)
  mark_as_advanced(GIT_EXECUTABLE)
  set(top "")
  if(GIT_EXECUTABLE)
    sarsim_git(${folder} top rev-parse --show-toplevel)
  endif()
  file(REAL_PATH ${folder} here)
  if(top)
    file(REAL_PATH ${top} top)
  endif()
  if(top STREQUAL here)  # and not a tree that somebody unpacked inside a checkout of something else
    sarsim_git(${folder} description describe --tags --long --abbrev=12 --match "v[0-9]*.[0-9]*.[0-9]*" --exclude "*-*")
    sarsim_read_description("${description}")
    if(NOT tag)
      sarsim_git(${folder} commit rev-parse --short=12 HEAD)
      sarsim_git(${folder} ahead rev-list --count HEAD)
    endif()
    sarsim_git(${folder} date log -1 --format=%cD)
    sarsim_git(${folder} differences status --porcelain --untracked-files=no)
    if(differences)
      set(changed TRUE)
    endif()
  elseif(EXISTS ${folder}/cmake/archive-version.txt)
    file(STRINGS ${folder}/cmake/archive-version.txt lines REGEX "^[a-z]+: [^$]")
    foreach(line IN LISTS lines)
      string(REGEX MATCH "^([a-z]+): (.*)$" line "${line}")
      set(archive_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
    endforeach()
    sarsim_read_description("${archive_description}")
    string(SUBSTRING "${archive_commit}" 0 12 commit)
    set(date "${archive_date}")
  endif()

  set(package ${number})
  set(text "")
  if(tag AND ahead GREATER 0)
    string(APPEND package "+${ahead}.g${commit}")
    set(text "commit ${commit}, ${ahead} after ${tag}")
  elseif(NOT tag AND commit)
    string(APPEND package "~${ahead}.g${commit}")
    string(REPLACE "~." "~0." package "${package}")
    set(text "commit ${commit}, before the first release")
  elseif(NOT tag)
    set(text "of unknown commit")
  endif()
  if(changed)
    string(APPEND package "+changed")
    if(NOT text)
      set(text "${tag}")
    endif()
    string(APPEND text ", with changes")
  endif()

  foreach(name number commit tag ahead changed date package text)
    string(TOUPPER ${name} upper)
    set(${prefix}_${upper} "${${name}}" PARENT_SCOPE)
  endforeach()
endfunction()
