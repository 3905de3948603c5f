# Writes ctest's entries of a GoogleTest binary: one for each of its suites, since many a binary
# takes longer to start than most tests. A suite given with a number of shards has as many entries.
# All share the driver's cache of shaders but those that are UNCACHED; so tests on the back end glfw
# have an entry of their own, which begins once EGL's, with the same driver, has ended.
#
#   cmake -D BINARY=... -D FOLDER=<where it runs> -D LSAN=<suppressions> -D CACHE=<folder>
#         -D "SHARDS=Suite=3;..." -D "UNCACHED=Suite;..." -D LABEL=... -D TO=<the file to write>
#         -P discover_suites.cmake
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
  if(line MATCHES "^  .*/glfw$")
    list(APPEND on_glfw ${suite})
  elseif(line MATCHES "^  ")
    math(EXPR tests_of_${suite} "${tests_of_${suite}} + 1")
  elseif(line MATCHES "^([A-Za-z0-9_/]+)\\.$")
    set(suite ${CMAKE_MATCH_1})
    list(APPEND suites ${suite})
    set(tests_of_${suite} 0)
    set(shards_of_${suite} 1)
  elseif(line MATCHES "\\.$")
    message(FATAL_ERROR "${BINARY}: a suite by the name of ${line}?")
  endif()
endforeach()
if(NOT suites)
  message(FATAL_ERROR "${BINARY} has no tests")
endif()

foreach(given IN LISTS SHARDS)
  string(REGEX MATCH "^(.*)=([0-9]+)$" whole "${given}")
  set(suite ${CMAKE_MATCH_1})
  if(NOT suite IN_LIST suites OR CMAKE_MATCH_2 GREATER tests_of_${suite})
    message(FATAL_ERROR "SHARDS ${given}: ${BINARY} has no suite of so many tests by this name")
  endif()
  set(shards_of_${suite} ${CMAKE_MATCH_2})
endforeach()

foreach(suite IN LISTS UNCACHED)
  if(NOT suite IN_LIST suites)
    message(FATAL_ERROR "UNCACHED ${suite}: ${BINARY} has no such suite")
  endif()
endforeach()

set(text "")
function(add_entry name filter environment)
  string(JOIN " " more ${ARGN})
  string(APPEND text
    "add_test([=[${name}]=] [=[${BINARY}]=] [=[--gtest_filter=${filter}]=])\n"
    "set_tests_properties([=[${name}]=] PROPERTIES WORKING_DIRECTORY [=[${FOLDER}]=]\n"
    "  LABELS ${LABEL} TIMEOUT 600 SKIP_RETURN_CODE 77 FIXTURES_REQUIRED shader_cache ${more}\n"
    "  ENVIRONMENT [=[${environment}]=]\n"
    "  ENVIRONMENT_MODIFICATION [=[LSAN_OPTIONS=set:suppressions=${LSAN}]=])\n")
  set(text "${text}" PARENT_SCOPE)
endfunction()

foreach(suite IN LISTS suites)
  set(environment "MESA_SHADER_CACHE_DISABLE=false;MESA_SHADER_CACHE_DIR=${CACHE}")
  if(suite IN_LIST UNCACHED)
    set(environment "MESA_SHADER_CACHE_DISABLE=true")
  endif()
  set(shards ${shards_of_${suite}})
  set(others "")
  foreach(shard RANGE 1 ${shards})
    if(tests_of_${suite} EQUAL 0)
      break() # all are on glfw
    elseif(shards EQUAL 1)
      add_entry(${suite} "${suite}.*-*/glfw" "${environment}")
      list(APPEND others ${suite})
    else()
      math(EXPR index "${shard} - 1")
      add_entry("${suite} ${shard} of ${shards}" "${suite}.*-*/glfw"
                "${environment};GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}"
                COST 100) # what takes long begins first
      list(APPEND others "${suite} ${shard} of ${shards}")
    endif()
  endforeach()
  if(suite IN_LIST on_glfw)
    add_entry("${suite} on glfw" "${suite}.*/glfw" "${environment}" DEPENDS "[=[${others}]=]")
  endif()
endforeach()
file(WRITE ${TO} "${text}")
