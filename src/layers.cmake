# isomotion_library(<folder> [SOURCES ...] [LINKS ...] [PRIVATE_LINKS ...] [BUILD_LINKS ...])
#
# One static library for one folder of src/. A library sees the headers of the folders it links and
# of no other: each folder is published through a link of its own under the build tree, so that
# `#include "gpu/context.h"` does not compile in a folder that may not know gpu.
#
# BUILD_LINKS are libraries of headers alone, used in no header of ours: who links an installed
# library of ours (src/package) needs them no more.
function(isomotion_library folder)
  cmake_parse_arguments(LIBRARY "" "" "SOURCES;LINKS;PRIVATE_LINKS;BUILD_LINKS" ${ARGN})
  set(view ${CMAKE_BINARY_DIR}/include/${folder})
  file(MAKE_DIRECTORY ${view})
  file(CREATE_LINK ${CMAKE_SOURCE_DIR}/src/${folder} ${view}/${folder} SYMBOLIC)

  set(target isomotion_${folder})
  add_library(${target} STATIC ${LIBRARY_SOURCES})
  add_library(isomotion::${folder} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${folder})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${view}>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PUBLIC ${LIBRARY_LINKS} PRIVATE ${LIBRARY_PRIVATE_LINKS})
  foreach(link isomotion_flags ${LIBRARY_BUILD_LINKS})
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:${link}>)
  endforeach()
endfunction()
