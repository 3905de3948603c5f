# isomotion_library(<folder> [SOURCES ...] [LINKS ...] [PRIVATE_LINKS ...])
#
# One static library for one folder of src/. A library sees the headers of the folders it links and
# of no other: each folder is published through a link of its own under the build tree, so that
# `#include "gpu/context.h"` does not compile in a folder that may not know gpu.
function(isomotion_library folder)
  cmake_parse_arguments(LIBRARY "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(view ${CMAKE_BINARY_DIR}/include/${folder})
  file(MAKE_DIRECTORY ${view})
  file(CREATE_LINK ${CMAKE_SOURCE_DIR}/src/${folder} ${view}/${folder} SYMBOLIC)

  set(target isomotion_${folder})
  add_library(${target} STATIC ${LIBRARY_SOURCES})
  add_library(isomotion::${folder} ALIAS ${target})
  target_include_directories(${target} PUBLIC ${view})
  target_link_libraries(${target} PUBLIC ${LIBRARY_LINKS}
                        PRIVATE isomotion_flags ${LIBRARY_PRIVATE_LINKS})
endfunction()
