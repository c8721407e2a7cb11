# One folder of src/ is one library target; its tests stand beside its code.
#
#   sarsim_folder(NAME USES lower folders... LIBS outside libraries... ROOMS subfolders...
#                 MODULE name MODULE_LIBS outside libraries... MODULE_SHARES sources...)
#
# x.cpp goes into the library, x_test.cpp into the test program NAME_test, x_bench.cpp into the benchmark
# NAME_bench. The names after USES are the folder's allowed includes. An entry of ROOMS is "room" or "room: rooms of the
# same folder that it may use"; without ROOMS the sources stand in the folder itself. tools/check-layers compares the
# includes of all sources with both lists.
#
# With MODULE, the room of that name becomes the loadable module sarsim_name.so instead, which is built with the library
# and which a program opens when it first needs what MODULE_LIBS offer. MODULE_SHARES are sources of other libraries
# that the module has its own copy of.

find_package(Threads REQUIRED)
if(SARSIM_TESTS)
  find_package(GTest REQUIRED)
  include(GoogleTest)
endif()
if(SARSIM_BENCH)
  find_package(benchmark REQUIRED)
endif()

add_library(sarsim_flags INTERFACE)
target_include_directories(sarsim_flags INTERFACE
  "$<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/src;${CMAKE_BINARY_DIR}/generated>" $<INSTALL_INTERFACE:include/sarsim>)
target_link_libraries(sarsim_flags INTERFACE Threads::Threads)
target_compile_features(sarsim_flags INTERFACE cxx_std_20)
set(warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wcast-align -Wnon-virtual-dtor
  -Woverloaded-virtual -Wdouble-promotion -Wformat=2)
# A sum of products must not depend on which ones the compiler fuses: same input, same bytes. This holds for other programs
# with our headers too, as the linker may take a function of a header from either.
target_compile_options(sarsim_flags INTERFACE "$<BUILD_INTERFACE:${warnings}>" -ffp-contract=off)
if(SARSIM_WARNINGS_AS_ERRORS)
  target_compile_options(sarsim_flags INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()
if(SARSIM_SANITIZE)
  target_compile_options(sarsim_flags INTERFACE -fsanitize=${SARSIM_SANITIZE}
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(sarsim_flags INTERFACE -fsanitize=${SARSIM_SANITIZE})
endif()
if(SARSIM_FUZZ)
  # No reader of bytes uses vectors, and with the sanitizers their code takes minutes to compile.
  target_compile_definitions(sarsim_flags INTERFACE HWY_COMPILE_ONLY_SCALAR)
  # What these two find, the address sanitizer finds as well; they take a fifth of the time to compile.
  target_compile_options(sarsim_flags INTERFACE -fno-sanitize=null,object-size)
endif()

# Hundreds of tests are linked with nearly the same libraries, in a fifth of the time of the usual linker. What is installed
# has no part in it. Without relro: where thread-local variables begin just before the end of a page, mold 1.10 has the
# loader protect a page that is not there, and the program does not start; and with segments apart, as where they share pages
# it can shift them for ever.
option(SARSIM_FAST_LINKER "Link with mold where it is found" OFF)
if(SARSIM_FAST_LINKER)
  find_program(SARSIM_MOLD NAMES mold)
  if(SARSIM_MOLD)
    target_link_options(sarsim_flags INTERFACE $<BUILD_INTERFACE:-fuse-ld=mold> $<BUILD_INTERFACE:-Wl,-z,norelro>
                        $<BUILD_INTERFACE:-Wl,-z,separate-loadable-segments>)
  endif()
endif()

# Compiles a test in less time: what takes long when it runs is in the libraries.
function(sarsim_compile_quickly target)
  set(level 0)
  if(SARSIM_SANITIZE)
    set(level 1)
  endif()
  target_compile_options(${target} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O${level}>)
endfunction()

# Half of the time that a test, a window or a command takes to compile is spent on headers of others. Off by default, so that a
# build without them finds a forgotten #include.
option(SARSIM_PRECOMPILED_HEADERS "Compile the headers of GoogleTest, Qt and CLI11 once for all" OFF)

# Precompiles headers for tests as the library `name`: sarsim_test_headers(NAME LIBRARY HEADERS...).
function(sarsim_test_headers name library)
  if(SARSIM_PRECOMPILED_HEADERS AND SARSIM_TESTS)
    file(WRITE ${CMAKE_BINARY_DIR}/generated/${name}.cpp "")
    add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/generated/${name}.cpp)
    target_link_libraries(${name} PRIVATE sarsim_flags ${library})
    target_precompile_headers(${name} PRIVATE ${ARGN} <algorithm> <complex> <filesystem> <functional> <random> <string> <vector>)
    sarsim_compile_quickly(${name})
  endif()
endfunction()
sarsim_test_headers(sarsim_headers_of_tests GTest::gmock <gtest/gtest.h>)

# The same for a library without loops over samples: `level` is that of -O in the release; for tests 1 is enough. A third of
# the time that commands take to compile is spent on optimising what runs once.
function(sarsim_optimise_less target level)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O${level}> $<$<CONFIG:RelWithDebInfo>:-O1>)
endfunction()

# The same for a folder that readers of bytes only link with, where these are fuzzed.
function(sarsim_seldom_fuzzed target)
  if(SARSIM_FUZZ)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()

# Gives the program or library `target` the headers that `from` has precompiled.
function(sarsim_reuse_headers target from)
  if(SARSIM_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${from})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # g++ 12 then finds overflows in std::string's own operator+ (GCC bug 105651).
      target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
    endif()
  endif()
endfunction()

# Foreign tests start programs of others or need packages from a network: `./test` leaves the label `foreign` out, `./test --all`
# does not. Of a program of GoogleTest they are those whose suite is called ForeignProgram...: sarsim_discover_tests(NAME LABEL SECONDS).
function(sarsim_discover_tests name label seconds)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 TEST_LIST tests_of_${name} PROPERTIES LABELS ${label} TIMEOUT ${seconds})
  # The properties above can hold no list.
  set(foreign_tests ${CMAKE_CURRENT_BINARY_DIR}/${name}_foreign.cmake)
  file(CONFIGURE OUTPUT ${foreign_tests} @ONLY CONTENT [[
foreach(test IN LISTS tests_of_@name@)
  if(test MATCHES "(^|/)ForeignProgram")
    set_tests_properties(${test} PROPERTIES LABELS "@label@;foreign")
  endif()
endforeach()
]])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${foreign_tests})
endfunction()

# The same of tests that have their labels: sarsim_foreign(TEST...).
function(sarsim_foreign)
  set_property(TEST ${ARGN} APPEND PROPERTY LABELS foreign)
endfunction()

option(SARSIM_COVERAGE "Count which lines run, for gcov" OFF)
if(SARSIM_COVERAGE)
  target_compile_options(sarsim_flags INTERFACE --coverage)
  target_link_options(sarsim_flags INTERFACE --coverage)
endif()

# The run paths lead to the module, which lies by the programs as it does where they are installed: programs are linked with
# the run path that they are installed with. (CMake fills up one that it will exchange with an empty part, and glibc takes that
# for the folder in which a program is started.) As the older kind of run path, because
# the sanitizers put their own dlopen in front of the system's, and the newer kind is not looked at for that.
set(SARSIM_MODULE_FOLDER lib/sarsim)
set(CMAKE_BUILD_RPATH ${CMAKE_BINARY_DIR}/${SARSIM_MODULE_FOLDER})
set(CMAKE_INSTALL_RPATH "$ORIGIN/../${SARSIM_MODULE_FOLDER}")
target_link_options(sarsim_flags INTERFACE $<BUILD_INTERFACE:LINKER:--disable-new-dtags>)

# Whether one of the libraries is in a folder that programs look into only when told. (Debian's HDF5 is not: what it has in a
# folder of its own are links for compilers.)
function(sarsim_has_library_apart result)
  set(apart OFF)
  foreach(library IN LISTS ARGN)
    if(IS_ABSOLUTE "${library}" AND library MATCHES "\\.so")
      file(REAL_PATH ${library} library)
      get_filename_component(folder ${library} DIRECTORY)
      if(NOT folder IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
        set(apart ON)
      endif()
    endif()
  endforeach()
  set(${result} ${apart} PARENT_SCOPE)
endfunction()

# A module that programs load. That of HDF5 is installed with the library for C, which needs it as the programs do.
function(sarsim_module name sources libraries)
  sarsim_has_library_apart(apart ${HDF5_C_LIBRARIES})
  add_library(sarsim_${name} MODULE ${sources})
  target_link_libraries(sarsim_${name} PRIVATE sarsim_flags ${libraries})
  set_target_properties(sarsim_${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
                        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${SARSIM_MODULE_FOLDER} INSTALL_RPATH ""
                        INSTALL_RPATH_USE_LINK_PATH ${apart} BUILD_WITH_INSTALL_RPATH ON)
  if(NOT SARSIM_SANITIZE)
    target_link_options(sarsim_${name} PRIVATE LINKER:-z,defs)
  endif()
  set(component program)
  if(name STREQUAL hdf5)
    set(component library)
  endif()
  install(TARGETS sarsim_${name} LIBRARY DESTINATION ${SARSIM_MODULE_FOLDER} COMPONENT ${component})
endfunction()

# A program that is installed.
function(sarsim_program name component source)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE ${ARGN})
  set_target_properties(${name} PROPERTIES BUILD_WITH_INSTALL_RPATH ON)
  install(TARGETS ${name} RUNTIME DESTINATION bin COMPONENT ${component})
endfunction()

option(SARSIM_COMPILE_TOGETHER "Compile the sources of a room in few translation units; off to find a forgotten #include" ON)

# Compiles the sources of each room together, at most `most` in one translation unit: what they include is then compiled once
# for all of them; with ACROSS_ROOMS whatever their rooms. Alone stay sources with #undef, and those with Highway's
# foreach_target.h, which can stand once only.
function(sarsim_compile_together target most)
  if(NOT SARSIM_COMPILE_TOGETHER)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  set(last "")
  foreach(source IN LISTS sources)
    get_filename_component(source ${source} ABSOLUTE)
    file(STRINGS ${source} alone REGEX "foreach_target|^#undef" LIMIT_COUNT 1)
    if(alone)
      continue()
    endif()
    get_filename_component(room ${source} DIRECTORY)
    get_filename_component(room ${room} NAME)
    if("ACROSS_ROOMS" IN_LIST ARGN)
      set(room all)
    endif()
    if(NOT room STREQUAL last)
      set(count 0)
      set(last ${room})
    endif()
    math(EXPR group "${count} / ${most}")
    math(EXPR count "${count} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room}_${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # GCC takes the sources of such a unit for headers, where types of anonymous namespaces would be a mistake.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# The folders that libsarsim.so is made of.
set(SARSIM_LIBRARY_FOLDERS core radar signal scene raster simulate workflow capi)

# Compiles a static library so that a shared one can be made of it. That its names are hidden keeps calls within it, and loads
# of what it defines, as direct as in a program.
function(sarsim_for_shared_library target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
                        VISIBILITY_INLINES_HIDDEN ON)
endfunction()

function(sarsim_folder name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "MODULE" "USES;LIBS;ROOMS;MODULE_LIBS;MODULE_SHARES")
  set(patterns ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  if(arg_ROOMS)
    list(TRANSFORM arg_ROOMS REPLACE ":.*" "")
    set(patterns ${arg_ROOMS})
    list(TRANSFORM patterns REPLACE "(.+)" "${CMAKE_CURRENT_SOURCE_DIR}/${name}/\\1/*.cpp")
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${patterns})
  set(tests ${sources})
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  set(benches ${sources})
  list(FILTER benches INCLUDE REGEX "_bench\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "_(test|bench)\\.cpp$|/main\\.cpp$")
  list(TRANSFORM arg_USES PREPEND sarsim_)
  if(arg_MODULE)
    set(module_sources ${sources})
    list(FILTER module_sources INCLUDE REGEX "/${name}/${arg_MODULE}/")
    list(REMOVE_ITEM sources ${module_sources})
    sarsim_module(${arg_MODULE} "${module_sources};${arg_MODULE_SHARES}" "${arg_MODULE_LIBS}")
    sarsim_compile_together(sarsim_${arg_MODULE} 20)
  endif()
  if(sources)
    add_library(sarsim_${name} STATIC ${sources})
    target_link_libraries(sarsim_${name} PUBLIC sarsim_flags ${arg_USES} ${arg_LIBS})
    sarsim_compile_together(sarsim_${name} 20)
    if(name IN_LIST SARSIM_LIBRARY_FOLDERS)
      sarsim_for_shared_library(sarsim_${name})
    endif()
    if(arg_MODULE)
      add_dependencies(sarsim_${name} sarsim_${arg_MODULE})
    endif()
  else()
    add_library(sarsim_${name} INTERFACE)
    target_link_libraries(sarsim_${name} INTERFACE sarsim_flags ${arg_USES} ${arg_LIBS})
  endif()
  if(SARSIM_TESTS AND tests)
    add_executable(${name}_test ${tests})
    target_include_directories(${name}_test PRIVATE ${CMAKE_SOURCE_DIR}/tests)
    target_link_libraries(${name}_test PRIVATE sarsim_${name} ${arg_MODULE_LIBS} GTest::gmock GTest::gtest_main)
    sarsim_reuse_headers(${name}_test sarsim_headers_of_tests)
    sarsim_compile_quickly(${name}_test)
    sarsim_compile_together(${name}_test 16 ACROSS_ROOMS)
    sarsim_discover_tests(${name}_test ${name} 1500)
  endif()
  if(SARSIM_BENCH AND benches)
    add_executable(${name}_bench ${benches})
    target_link_libraries(${name}_bench PRIVATE sarsim_${name} benchmark::benchmark_main)
  endif()
endfunction()

# A test program of tests/: sarsim_test(NAME sources...). It may use every library and tests/support.
function(sarsim_test name)
  add_executable(${name} ${ARGN})
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_link_libraries(${name} PRIVATE sarsim_workflow GTest::gmock GTest::gtest_main)
  sarsim_reuse_headers(${name} sarsim_headers_of_tests)
  sarsim_compile_quickly(${name})
  sarsim_compile_together(${name} 16 ACROSS_ROOMS)
  sarsim_discover_tests(${name} tests 300)
endfunction()

# A test program that starts the built sarsim: sarsim_program_test(LABEL SECONDS sources...), of tests/LABEL.
function(sarsim_program_test label seconds)
  set(name ${label}_end_to_end_test)
  add_executable(${name} ${CMAKE_SOURCE_DIR}/tests/cli/program.cpp ${ARGN})
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests ${CMAKE_SOURCE_DIR}/tests/cli)
  target_link_libraries(${name} PRIVATE sarsim_simulate GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE SARSIM_PROGRAM="$<TARGET_FILE:sarsim>" SARSIM_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                             SARSIM_PYTHON="${Python3_EXECUTABLE}")
  sarsim_reuse_headers(${name} sarsim_headers_of_tests)
  sarsim_compile_quickly(${name})
  sarsim_compile_together(${name} 16 ACROSS_ROOMS)
  add_dependencies(${name} sarsim)
  sarsim_discover_tests(${name} ${label} ${seconds})
endfunction()
