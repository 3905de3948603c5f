# Writes the files of FOLDER as one C++ source: page/embedded_files.h.
file(GLOB files ${FOLDER}/*)
set(text "#include \"page/embedded_files.h\"\n\nnamespace isomotion::page {\n\n"
         "std::map<std::string_view, std::string_view> embedded_files() {\n    return {\n")
string(JOIN "" text ${text})
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME)
  file(READ ${file} content)
  string(APPEND text "{\"${name}\", R\"embedded(${content})embedded\"},\n")
endforeach()
string(APPEND text "    };\n}\n\n} // namespace isomotion::page\n")
file(WRITE ${TO} "${text}")
