# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause

# yorb_options(TARGET): the warnings, sanitizers and code generation that every target of ours shares.
function(yorb_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                                           -Wno-missing-field-initializers -ffp-contract=off
                                           -Wno-restrict)  # a false alarm of gcc 12 on string + string
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

  # Of the same functions for several processors each file has the same names to itself.
  set(twins ${sources})
  list(FILTER twins INCLUDE REGEX "_(avx2|portable)\\.cc$")
  if(twins)
    set_source_files_properties(${twins} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()

  if(sources)
    add_library(yorb_${name} STATIC ${sources})
    target_link_libraries(yorb_${name} PUBLIC ${ROOM_DEPS})
    target_include_directories(yorb_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                   $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/yorb>)
    yorb_options(yorb_${name})
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
    yorb_tests(${name}_test ${name})
  endif()
  if(benches AND YORB_BENCHES)
    find_package(benchmark REQUIRED)
    add_executable(${name}_bench ${benches})
    target_link_libraries(${name}_bench PRIVATE yorb_${name} ${ROOM_BENCH_DEPS} benchmark::benchmark benchmark::benchmark_main)
    yorb_options(${name}_bench)
  endif()
endfunction()
