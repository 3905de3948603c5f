# Run while installing, with PUBLIC (the folder of <isomotion/NAME.h>), SOURCES (src/), STAGE and
# DESTINATION.
#
# Installs the public headers and what they include, and no other. Inside the project a header is
# "formula/field.h"; installed it is <isomotion/formula/field.h>, so that names as common as scene/
# and image/ need no place on anybody's include path.
cmake_policy(VERSION 3.25)
file(REMOVE_RECURSE ${STAGE})
file(GLOB faces ${PUBLIC}/*.h)
set(waiting)
foreach(face ${faces})
  get_filename_component(name ${face} NAME)
  list(APPEND waiting "${face}>${name}")
endforeach()

set(done)
while(waiting)
  list(POP_FRONT waiting header)
  if(header IN_LIST done)
    continue()
  endif()
  list(APPEND done ${header})
  string(REPLACE ">" ";" header ${header})
  list(GET header 0 file)
  list(GET header 1 name)
  file(READ ${file} text)
  string(REGEX MATCHALL "\n#include \"[^\"]+\"" includes "${text}")
  foreach(include ${includes})
    string(REGEX REPLACE ".*\"([^\"]+)\"" "\\1" include ${include})
    list(APPEND waiting "${SOURCES}/${include}>${include}")
  endforeach()
  string(REGEX REPLACE "\n#include \"([^\"]+)\"" "\n#include <isomotion/\\1>" text "${text}")
  file(WRITE ${STAGE}/${name} "${text}")
endwhile()

file(INSTALL ${STAGE}/ DESTINATION ${DESTINATION})
