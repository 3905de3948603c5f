# The manual page and the shells' completions, printed by the program itself, and what Debian's
# policy wants beside them.
find_program(GZIP_PROGRAM gzip REQUIRED)

# describe(<what> <file>): what `isomotion describe <what>` prints, without a driver.
set(documents)
function(describe what file)
  file(GLOB scenes CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/animations/*.toml)
  get_filename_component(folder ${CMAKE_CURRENT_BINARY_DIR}/${file} DIRECTORY)
  add_custom_command(
    OUTPUT ${file}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ${CMAKE_COMMAND} -E env ISOMOTION_DATA=${PROJECT_SOURCE_DIR} ASAN_OPTIONS=detect_leaks=0
            $<TARGET_FILE:isomotion> describe ${what} > ${file}
    DEPENDS isomotion ${scenes}
    VERBATIM)
  set(documents ${documents} ${CMAKE_CURRENT_BINARY_DIR}/${file} PARENT_SCOPE)
endfunction()

# compressed(<source> <file>): without a time in it, so that packages can be made again to the byte.
function(compressed source file)
  add_custom_command(
    OUTPUT ${file}
    COMMAND ${GZIP_PROGRAM} -9 -n -c ${source} > ${file}
    DEPENDS ${source}
    VERBATIM)
  set(documents ${documents} ${CMAKE_CURRENT_BINARY_DIR}/${file} PARENT_SCOPE)
endfunction()

describe(man isomotion.1)
describe(bash bash/isomotion)
describe(zsh zsh/_isomotion)
describe(fish fish/isomotion.fish)
compressed(${CMAKE_CURRENT_BINARY_DIR}/isomotion.1 isomotion.1.gz)
compressed(${CMAKE_CURRENT_SOURCE_DIR}/changelog changelog.gz)
add_custom_target(isomotion_documents ALL DEPENDS ${documents})

set(made ${CMAKE_CURRENT_BINARY_DIR})
set(share ${CMAKE_INSTALL_DATADIR})
install(FILES ${made}/isomotion.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT runtime)
install(FILES ${made}/bash/isomotion DESTINATION ${share}/bash-completion/completions COMPONENT runtime)
install(FILES ${made}/zsh/_isomotion DESTINATION ${share}/zsh/vendor-completions COMPONENT runtime)
install(FILES ${made}/fish/isomotion.fish DESTINATION ${share}/fish/vendor_completions.d COMPONENT runtime)
install(FILES desktop/isomotion.desktop DESTINATION ${share}/applications COMPONENT runtime)
install(FILES desktop/invalid.isomotion.isomotion.metainfo.xml DESTINATION ${share}/metainfo COMPONENT runtime)
install(FILES desktop/isomotion.svg DESTINATION ${share}/icons/hicolor/scalable/apps COMPONENT runtime)
foreach(package isomotion=runtime libisomotion-dev=development)
  string(REGEX REPLACE "=.*" "" name ${package})
  string(REGEX REPLACE ".*=" "" component ${package})
  install(FILES ${made}/changelog.gz DESTINATION ${share}/doc/${name} COMPONENT ${component})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright DESTINATION ${share}/doc/${name} COMPONENT ${component})
endforeach()
