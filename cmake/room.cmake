# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause

# yorb_options(TARGET): the warnings, sanitizers and code generation that every target of ours shares.
function(yorb_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                                           -Wno-missing-field-initializers -ffp-contract=off
                                           -Wno-restrict)  # a false alarm of gcc 12 on string + string
  if(YORB_PCH)
    # Of what a precompiled header brings, gcc 12 forgets that it is the system's, and gives more such false alarms.
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
  # HammingDistance is inline in hot loops: popcnt is in every x86-64-v2 processor (since 2008).
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_options(${target} PRIVATE -mpopcnt)
  endif()
  if(YORB_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(YORB_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${YORB_SANITIZE} -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer
                                             -Wno-maybe-uninitialized)  # a false alarm of gcc 12 in sanitized code
    if(YORB_SANITIZE MATCHES "address.*undefined")
      # Checks of every pointer on top of AddressSanitizer's find nothing more, and treble the time to compile Eigen.
      target_compile_options(${target} PRIVATE -fno-sanitize=null,alignment,vptr,object-size,pointer-overflow)
    endif()
    target_link_options(${target} PRIVATE -fsanitize=${YORB_SANITIZE})
  endif()
endfunction()

# yorb_precompiled(TARGET lib|test): lets a target take what nearly every file includes from one precompiled header, which
# saves a third of the time to build. There are two, since libraries are compiled as -fPIC and programs as -fPIE. Files
# still include what they use: a build with -DYORB_PCH=OFF must pass, too.
function(yorb_precompiled target kind)
  if(NOT YORB_PCH)
    return()
  endif()
  if(NOT TARGET yorb_${kind}_headers)
    set(headers <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits> <map> <memory>
                <optional> <set> <sstream> <string> <utility> <vector> <Eigen/Core> <Eigen/Geometry>
                <opencv2/imgproc.hpp>)  # without nlohmann/json.hpp: every file would pay for its templates
    file(WRITE ${PROJECT_BINARY_DIR}/headers/${kind}.cc "int main() {}\n")
    if(kind STREQUAL "test")
      list(APPEND headers <gmock/gmock.h> <gtest/gtest.h>)
      add_executable(yorb_test_headers ${PROJECT_BINARY_DIR}/headers/test.cc)
      target_link_libraries(yorb_test_headers PRIVATE GTest::gmock)
    else()
      add_library(yorb_lib_headers OBJECT ${PROJECT_BINARY_DIR}/headers/lib.cc)
    endif()
    target_link_libraries(yorb_${kind}_headers PRIVATE Threads::Threads Eigen3::Eigen opencv_imgproc)
    target_precompile_headers(yorb_${kind}_headers PRIVATE ${headers})
    yorb_options(yorb_${kind}_headers)
  endif()
  target_precompile_headers(${target} REUSE_FROM yorb_${kind}_headers)
endfunction()

# yorb_tests(TARGET PREFIX): makes every TEST of a GoogleTest program a test of ctest, PREFIX.Suite.Name; of the tests of the
# whole program (prefix "tests"), whose suites render a recording first, each suite's program is one. Those and the tests of
# YORB_THREADED_ROOMS have the label "threads"; those of YORB_MEMORY_ROOMS have the label "memory".
add_custom_target(yorb_threaded_tests)
add_custom_target(yorb_memory_tests)
function(yorb_tests target prefix)
  set(properties TIMEOUT 300)
  set(labels "")
  if(prefix IN_LIST YORB_THREADED_ROOMS OR prefix STREQUAL "tests")
    list(APPEND labels threads)
    add_dependencies(yorb_threaded_tests ${target})
  endif()
  if(prefix IN_LIST YORB_MEMORY_ROOMS)
    list(APPEND labels memory)
    add_dependencies(yorb_memory_tests ${target})
  endif()
  if(labels)
    list(APPEND properties LABELS "${labels}")
  endif()
  if(prefix STREQUAL "tests")
    add_test(NAME tests.${target} COMMAND ${target})
    set_tests_properties(tests.${target} PROPERTIES ${properties} TIMEOUT 1500 COST 1000
                                                    SKIP_REGULAR_EXPRESSION "  PASSED  . 0 tests")
  else()
    gtest_discover_tests(${target} TEST_PREFIX ${prefix}. DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
  endif()
endfunction()

# yorb_room(NAME DEPS targets...): one library from the folder's *.cc, one test program from its *_test.cc and one
# benchmark program from its *_bench.cc. A room is its folder, so there are no file lists to keep. TEST_DEPS and
# BENCH_DEPS name what only the tests and benchmarks may use.
function(yorb_room name)
  cmake_parse_arguments(ROOM "" "" "DEPS;TEST_DEPS;BENCH_DEPS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cc)
  set(tests ${sources})
  set(benches ${sources})
  list(FILTER tests INCLUDE REGEX "_test\\.cc$")
  list(FILTER benches INCLUDE REGEX "_bench\\.cc$")
  list(FILTER sources EXCLUDE REGEX "_(test|bench)\\.cc$")

  if(sources)
    add_library(yorb_${name} STATIC ${sources})
    target_link_libraries(yorb_${name} PUBLIC ${ROOM_DEPS})
    target_include_directories(yorb_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                   $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/yorb>)
    yorb_options(yorb_${name})
    yorb_precompiled(yorb_${name} lib)
  else()
    add_library(yorb_${name} INTERFACE)
    target_link_libraries(yorb_${name} INTERFACE ${ROOM_DEPS})
    target_include_directories(yorb_${name} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/yorb>)
  endif()
  set_target_properties(yorb_${name} PROPERTIES EXPORT_NAME ${name})
  add_library(yorb::${name} ALIAS yorb_${name})
  install(TARGETS yorb_${name} EXPORT yorbTargets)
  file(GLOB headers CONFIGURE_DEPENDS *.h)
  list(FILTER headers EXCLUDE REGEX "/(test_[a-z_]*|[a-z_]*_oracle)\\.h$")  # those are for tests alone
  install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/yorb/${name})

  if(tests AND YORB_TESTS)
    find_package(GTest REQUIRED)
    include(GoogleTest)
    add_executable(${name}_test ${tests})
    target_link_libraries(${name}_test PRIVATE yorb_${name} ${ROOM_TEST_DEPS} GTest::gmock GTest::gtest_main)
    yorb_options(${name}_test)
    yorb_precompiled(${name}_test test)
    yorb_tests(${name}_test ${name})
  endif()
  if(benches AND YORB_BENCHES)
    find_package(benchmark REQUIRED)
    add_executable(${name}_bench ${benches})
    target_link_libraries(${name}_bench PRIVATE yorb_${name} ${ROOM_BENCH_DEPS} benchmark::benchmark benchmark::benchmark_main)
    yorb_options(${name}_bench)
  endif()
endfunction()
