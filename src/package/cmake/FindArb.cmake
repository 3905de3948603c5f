# Ball arithmetic. Debian 12 has Arb as a library of its own; with FLINT 3 it is part of FLINT.
# Defines Arb::arb.
find_path(ARB_INCLUDE_DIR NAMES arb.h PATH_SUFFIXES flint)
find_library(FLINT_LIBRARY NAMES flint)
find_library(ARB_LIBRARY NAMES flint-arb arb flint)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb REQUIRED_VARS ARB_LIBRARY FLINT_LIBRARY ARB_INCLUDE_DIR)
mark_as_advanced(ARB_INCLUDE_DIR FLINT_LIBRARY ARB_LIBRARY)

if(Arb_FOUND AND NOT TARGET Arb::arb)
  add_library(Arb::arb INTERFACE IMPORTED)
  target_include_directories(Arb::arb SYSTEM INTERFACE ${ARB_INCLUDE_DIR})
  target_link_libraries(Arb::arb INTERFACE ${ARB_LIBRARY} ${FLINT_LIBRARY})
endif()
