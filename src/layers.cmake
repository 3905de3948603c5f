# With CMAKE_UNITY_BUILD, which the preset release sets, a build from nothing takes the least time: the headers
# that most sources include are parsed once, and the sources of a folder are compiled as one, save those
# that have names in common in their unnamed namespaces (isomotion_alone). Without it, the sources that changed
# are compiled alone, and one that forgets an include shows.
if(NOT EXISTS ${PROJECT_BINARY_DIR}/precompiled.cpp)
  file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "")
endif()
add_library(isomotion_precompiled OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/precompiled.cpp)
target_link_libraries(isomotion_precompiled PRIVATE isomotion_flags fmt::fmt glm::glm)
# Shared libraries and modules of others may hold ours. No function of ours is replaced at run time.
set_target_properties(isomotion_precompiled PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_compile_options(isomotion_precompiled PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
target_precompile_headers(isomotion_precompiled PRIVATE
  <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <mutex> <optional> <set> <span> <stdexcept>
  <string> <string_view> <unordered_map> <utility> <variant> <vector>
  <fmt/format.h> <glm/glm.hpp>)

# isomotion_library(<folder> [INNER_LOOPS] [SOURCES ...] [LINKS ...] [PRIVATE_LINKS ...] [BUILD_LINKS ...])
#
# One static library for one folder of src/, "gpu" or "scene/reading". A library sees the headers of
# the folders it links and of no other: the headers that lie in each folder itself, not those of
# folders in it, are published through links under the build tree, so that
# `#include "gpu/context.h"` does not compile in a folder that may not know gpu.
#
# INNER_LOOPS says that the time of a proof, a count or a pixel is spent here. What is called some times a
# frame, or a scene, is compiled with -O1, which takes an eighth to a third less; values don't depend on it.
#
# BUILD_LINKS are libraries of headers alone, used in no header of ours: who links an installed
# library of ours (src/package) needs them no more.
function(isomotion_library folder)
  cmake_parse_arguments(LIBRARY "INNER_LOOPS" "" "SOURCES;LINKS;PRIVATE_LINKS;BUILD_LINKS;ROOMS" ${ARGN})
  string(REPLACE "/" "_" name ${folder})
  set(view ${PROJECT_BINARY_DIR}/include/${name})
  file(REMOVE_RECURSE ${view})
  foreach(room "" ${LIBRARY_ROOMS})
    set(part ${folder})
    if(room)
      set(part ${folder}/${room})
    endif()
    file(MAKE_DIRECTORY ${view}/${part})
    file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${part}/*.h)
    foreach(header ${headers})
      get_filename_component(leaf ${header} NAME)
      file(CREATE_LINK ${header} ${view}/${part}/${leaf} SYMBOLIC)
    endforeach()
  endforeach()

  set(target isomotion_${name})
  add_library(${target} STATIC ${LIBRARY_SOURCES})
  add_library(isomotion::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  if(CMAKE_UNITY_BUILD)
    target_precompile_headers(${target} REUSE_FROM isomotion_precompiled)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE 0 POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  if(NOT LIBRARY_INNER_LOOPS)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${view}>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PUBLIC ${LIBRARY_LINKS} PRIVATE ${LIBRARY_PRIVATE_LINKS})
  foreach(link isomotion_flags ${LIBRARY_BUILD_LINKS})
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:${link}>)
  endforeach()
endfunction()

# isomotion_alone(<source> ...): these are not compiled together with others.
function(isomotion_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
