# Two .debs of the build tree: `cpack` there, or tools/package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The isomotion authors")
set(CPACK_PACKAGE_CONTACT "The isomotion authors <authors@isomotion.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME isomotion)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
"renderer of implicit surfaces that move
Takes a formula F(x, y, z; parameters) = 0 and how its parameters change, and
draws every frame on the GPU from the formula alone, so that the topology may
change freely. Plays animations in a window, writes them as PNG, OpenEXR and
movies, measures what accuracy costs in time, and proves when parts of a
surface merge, split, open and close. Comes with a gallery.")
# Opened while running, which dpkg-shlibdeps can't see: OpenGL back ends, and ffmpeg for movies.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "libegl1, libgl1, libgl1-mesa-dri, libosmesa6, ffmpeg")
# Labels of the window; plots of `isomotion accuracy -o`.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "fonts-dejavu-core, gnuplot-nox")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libisomotion-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"implicit surfaces that move, for C++ programs
Formulas, scene files, frames drawn with OpenGL, sequences, certified first
roots of rays and proved topology events: the library, its one header, and the
configuration by which CMake's find_package(isomotion) finds them.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "isomotion (= ${PROJECT_VERSION}), libfmt-dev, libglm-dev, libtomlplusplus-dev, libflint-dev, libflint-arb-dev, libglfw3-dev, libxxhash-dev, zlib1g-dev, pkg-config")
include(CPack)
