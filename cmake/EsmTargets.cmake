# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT

# Linked PRIVATE into each of our targets, so that users of a header never inherit our flags.
add_library(esm_warnings INTERFACE)
target_compile_options(esm_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict> # false alarm, GCC bug 105651
  # Told only where several files are compiled as one, for classes whose members are private to their file anyway.
  $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
  -ffp-contract=off # the same bits with and without FMA: golden hashes hold on every x86-64
  $<$<BOOL:${ESM_WERROR}>:-Werror>)
if(ESM_SANITIZE STREQUAL "address")
  set(esm_sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
elseif(ESM_SANITIZE STREQUAL "thread")
  set(esm_sanitizers -fsanitize=thread -fno-omit-frame-pointer)
elseif(ESM_SANITIZE)
  message(FATAL_ERROR "ESM_SANITIZE=${ESM_SANITIZE}: use empty, address or thread")
endif()
if(ESM_FUZZ)
  list(APPEND esm_sanitizers -fsanitize=fuzzer-no-link)
endif()
if(esm_sanitizers)
  add_compile_options(${esm_sanitizers})
  add_link_options(${esm_sanitizers})
  add_compile_definitions(ESM_SANITIZED=1)
endif()

# esm_library(NAME SOURCES... LINK public-dependencies... PRIVATE private-dependencies...)
# A static library of one layer. The include root is the repository root, so that each include names
# its layer: #include "core/net/spring_net.h". A layer of headers only becomes an INTERFACE library.
function(esm_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK;PRIVATE" ${ARGN})
  if(arg_SOURCES)
    add_library(${name} STATIC ${arg_SOURCES})
    target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
    target_compile_features(${name} PUBLIC cxx_std_20)
    target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE ${arg_PRIVATE} esm_warnings)
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${PROJECT_SOURCE_DIR})
    target_compile_features(${name} INTERFACE cxx_std_20)
    target_link_libraries(${name} INTERFACE ${arg_LINK})
  endif()
endfunction()

# esm_test(NAME SOURCES... LINK dependencies... [LABEL label] [THREADS] [UNSANITIZED])
# One gtest program of a module; every TEST becomes a ctest of its own at test time, so that the
# environment set by ctest also holds while the tests are listed. The label may be several, joined by + (ctest -L
# looks for parts; a list would be lost on the way to it). THREADS marks programs in which several threads
# meet: label threads, and part of the target "thread_tests", which is all that the thread sanitizer needs built.
# UNSANITIZED leaves a program out of sanitizer builds: long runs of what other tests run shortly.
function(esm_test name)
  cmake_parse_arguments(arg "THREADS;UNSANITIZED" "LABEL" "SOURCES;LINK" ${ARGN})
  if(ESM_SANITIZE AND arg_UNSANITIZED)
    return()
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gmock GTest::gtest_main esm_warnings)
  if(ESM_SANITIZE STREQUAL "address")
    # What is tested is watched, not the tests: their checks would be a third of the build. So what our headers
    # hold (templates, inline functions) is watched where the libraries use it.
    target_compile_options(${name} PRIVATE -fno-sanitize=undefined)
  endif()
  target_compile_definitions(${name} PRIVATE
    ESM_SOURCE_DIR="${PROJECT_SOURCE_DIR}" ESM_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
  if(arg_THREADS)
    string(APPEND arg_LABEL +threads)
    if(NOT TARGET thread_tests)
      add_custom_target(thread_tests)
    endif()
    add_dependencies(thread_tests ${name})
  endif()
  set(serial OFF) # what measures time wants the machine to itself
  if(arg_LABEL MATCHES timing)
    set(serial ON)
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS "${arg_LABEL}" TIMEOUT 300 RUN_SERIAL ${serial})
endfunction()

# esm_fuzzer(NAME SOURCES... LINK dependencies...)
# One libFuzzer target (LLVMFuzzerTestOneInput) and a ctest of it that looks for 60 s, label slow. It starts from
# tests/fuzz/seeds/NAME if there is such a folder, and keeps what it finds in its own build folder. The target
# "fuzzers" builds them all, and nothing that they do not need.
function(esm_fuzzer name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} esm_warnings)
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  if(NOT TARGET fuzzers)
    add_custom_target(fuzzers)
  endif()
  add_dependencies(fuzzers ${name})
  set(seeds ${PROJECT_SOURCE_DIR}/tests/fuzz/seeds/${name})
  if(NOT EXISTS ${seeds})
    set(seeds "")
  endif()
  set(found ${CMAKE_CURRENT_BINARY_DIR}/${name}.corpus)
  file(MAKE_DIRECTORY ${found})
  add_test(NAME ${name} COMMAND ${name} -max_total_time=30 -timeout=10 -rss_limit_mb=2048 -print_final_stats=1
    ${found} ${seeds})
  set_tests_properties(${name} PROPERTIES LABELS "slow;fuzz" TIMEOUT 180)
endfunction()
