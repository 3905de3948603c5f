# Writes ctest's entries of a GoogleTest binary: one for each of its suites, since many a binary
# takes longer to start than most tests. A suite given with a number of shards has as many entries.
#
# Entries of the quick suite run each test once, on the back end egl where it is parametrised by back
# ends. What is EXHAUSTIVE, a suite or some tests of one ("Suite", "Suite.Test*"), what is not QUICK of a
# suite of which some tests are ("Suite.Test*"), and the other back ends of suites that are not in
# BACKENDS, have entries with the label `exhaustive`.
#
# THOROUGH suites have a further entry of that label, in which each of their tests tries more (thorough.h).
#
# All share the driver's cache of shaders but those that are UNCACHED; so tests on the back end glfw
# have an entry of their own, which begins once EGL's, with the same driver, has ended.
#
# Entries of the quick suite have the driver compile without optimizing, which is most of their time:
# pictures are the same to the bit, and what only `--all` runs draws as users do.
#
#   cmake -D BINARY=... -D FOLDER=<where it runs> -D LSAN=<suppressions> -D CACHE=<folder>
#         -D "SHARDS=Suite=3;..." -D "UNCACHED=Suite;..." -D "EXHAUSTIVE=Suite;Suite.Test*;..."
#         -D "QUICK=Suite.Test*;..." -D "THOROUGH=Suite;..." -D "BACKENDS=Suite;..." -D LABEL=...
#         -D TO=<the file to write> -P discover_suites.cmake
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${BINARY} --gtest_list_tests
                WORKING_DIRECTORY ${FOLDER} TIMEOUT 60
                OUTPUT_VARIABLE listed RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${BINARY} --gtest_list_tests: ${result}\n${listed}")
endif()

# Values of parameters, after a #, may hold anything that is special in a list.
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}")
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
foreach(line IN LISTS lines)
  if(line MATCHES "^  (.*)$")
    list(APPEND tests_of_${suite} ${CMAKE_MATCH_1})
  elseif(line MATCHES "^([A-Za-z0-9_/]+)\\.$")
    set(suite ${CMAKE_MATCH_1})
    list(APPEND suites ${suite})
  elseif(line MATCHES "\\.$")
    message(FATAL_ERROR "${BINARY}: a suite by the name of ${line}?")
  endif()
endforeach()
if(NOT suites)
  message(FATAL_ERROR "${BINARY} has no tests")
endif()

# select(<variable> <suite> <pattern>...): the suite's tests that one of the patterns matches.
function(select variable suite)
  set(selected "")
  foreach(pattern IN LISTS ARGN)
    string(REPLACE "*" ".*" expression "${pattern}")
    set(of_pattern ${tests_of_${suite}})
    list(FILTER of_pattern INCLUDE REGEX "^${expression}$")
    list(APPEND selected ${of_pattern})
  endforeach()
  list(REMOVE_DUPLICATES selected)
  set(${variable} ${selected} PARENT_SCOPE)
endfunction()

# A name that no test has any more would do nothing, in silence.
function(expect_suite option suite)
  if(NOT suite IN_LIST suites)
    message(FATAL_ERROR "${option} ${suite}: ${BINARY} has no such suite")
  endif()
endfunction()

foreach(suite IN LISTS UNCACHED BACKENDS THOROUGH)
  expect_suite("UNCACHED, BACKENDS or THOROUGH" ${suite})
endforeach()
foreach(given IN LISTS SHARDS)
  string(REGEX MATCH "^(.*)=([0-9]+)$" whole "${given}")
  expect_suite(SHARDS ${CMAKE_MATCH_1})
  set(shards_of_${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
endforeach()
foreach(option EXHAUSTIVE QUICK)
  foreach(given IN LISTS ${option})
    string(REGEX MATCH "^([^.]*)\\.?(.*)$" whole "${given}")
    set(suite ${CMAKE_MATCH_1})
    set(pattern ${CMAKE_MATCH_2})
    expect_suite(${option} ${suite})
    if(NOT pattern)
      set(pattern "*")
    endif()
    select(tests ${suite} ${pattern})
    if(NOT tests)
      message(FATAL_ERROR "${option} ${given}: ${BINARY} has no such test")
    endif()
    list(APPEND ${option}_of_${suite} ${pattern})
  endforeach()
endforeach()

set(text "")
# add_entry(<name> <suite> <filter> <labels> <environment> [property value ...])
function(add_entry name suite filter labels environment)
  string(JOIN " " more ${ARGN})
  # The limit ends what hangs. It leaves room for a machine with other work on it: the longest exhaustive
  # entries take five minutes alone.
  set(limit 600)
  if(labels MATCHES "exhaustive")
    set(limit 1800)
    list(APPEND environment "ISOMOTION_THOROUGH=1")
  endif()
  if(suite IN_LIST UNCACHED)
    list(APPEND environment "MESA_SHADER_CACHE_DISABLE=true")
  else()
    # Mesa's cache does not tell the two kinds of code apart.
    set(folder optimized)
    if(NOT labels MATCHES "exhaustive")
      set(folder quick)
      list(APPEND environment "GALLIVM_PERF=nopt")
    endif()
    list(APPEND environment "MESA_SHADER_CACHE_DISABLE=false" "MESA_SHADER_CACHE_DIR=${CACHE}_${folder}"
         "MESA_SHADER_CACHE_MAX_SIZE=512M") # the driver drops what was not used for longest
  endif()
  string(APPEND text
    "add_test([=[${name}]=] [=[${BINARY}]=] [=[--gtest_filter=${filter}]=])\n"
    "set_tests_properties([=[${name}]=] PROPERTIES WORKING_DIRECTORY [=[${FOLDER}]=]\n"
    "  LABELS [=[${labels}]=] TIMEOUT ${limit} SKIP_RETURN_CODE 77 ${more}\n"
    "  ENVIRONMENT [=[${environment}]=]\n"
    "  ENVIRONMENT_MODIFICATION [=[LSAN_OPTIONS=set:suppressions=${LSAN}]=])\n")
  set(text "${text}" PARENT_SCOPE)
  list(APPEND entries ${name})
  set(entries "${entries}" PARENT_SCOPE)
endfunction()

# filter_of(<variable> <suite> <test>...): GoogleTest's filter of these tests by name.
function(filter_of variable suite)
  list(TRANSFORM ARGN PREPEND "${suite}." OUTPUT_VARIABLE names)
  list(JOIN names ":" names)
  set(${variable} "${names}" PARENT_SCOPE)
endfunction()

foreach(suite IN LISTS suites)
  set(entries "")
  select(on_osmesa ${suite} "*/osmesa")
  select(on_glfw ${suite} "*/glfw")
  set(quick ${tests_of_${suite}})
  list(REMOVE_ITEM quick "" ${on_osmesa} ${on_glfw})
  set(all ${quick})
  if(QUICK_of_${suite})
    select(quick ${suite} ${QUICK_of_${suite}})
    list(REMOVE_ITEM quick "" ${on_osmesa} ${on_glfw})
  endif()
  select(long ${suite} ${EXHAUSTIVE_of_${suite}})
  list(REMOVE_ITEM quick "" ${long})
  set(long ${all})
  if(NOT suite IN_LIST THOROUGH)
    list(REMOVE_ITEM long "" ${quick})
  endif()

  if(quick)
    set(filter "${suite}.*-*/osmesa:*/glfw")
    if(NOT quick STREQUAL all)
      filter_of(filter ${suite} ${quick})
    endif()
    set(shards 1)
    if(DEFINED shards_of_${suite})
      set(shards ${shards_of_${suite}})
    endif()
    list(LENGTH quick tests)
    if(shards GREATER tests)
      message(FATAL_ERROR "SHARDS ${suite}: ${BINARY} has no suite of so many tests by this name")
    endif()
    foreach(shard RANGE 1 ${shards})
      if(shards EQUAL 1)
        add_entry(${suite} ${suite} "${filter}" ${LABEL} "")
      else()
        math(EXPR index "${shard} - 1")
        add_entry("${suite} ${shard} of ${shards}" ${suite} "${filter}" ${LABEL}
                  "GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}"
                  COST 100) # what takes long begins first
      endif()
    endforeach()
  endif()
  if(long)
    filter_of(filter ${suite} ${long})
    add_entry("${suite} exhaustive" ${suite} "${filter}" "${LABEL};exhaustive" "")
  endif()

  set(labels ${LABEL})
  if(NOT suite IN_LIST BACKENDS)
    list(APPEND labels exhaustive)
  endif()
  if(on_osmesa)
    add_entry("${suite} on osmesa" ${suite} "${suite}.*/osmesa" "${labels}" "")
  endif()
  if(on_glfw)
    add_entry("${suite} on glfw" ${suite} "${suite}.*/glfw" "${labels}" "" DEPENDS "[=[${entries}]=]")
  endif()
endforeach()
file(WRITE ${TO} "${text}")
