// One shader, put together from files and generated parts.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/stage.h"

namespace isomotion::synthesis {

class ShaderText {
public:
    // Begins with the prelude; `files` collects the names of the files of shaders/ that are used.
    explicit ShaderText(std::vector<std::string>& files, Stage stage = Stage::fragment);

    // Of GLSL, in place of 330.
    void version(int glsl);
    // Adds a file, once.
    void file(const std::string& name);
    // Even if it is there: files that are written for numbers of any type.
    void file_again(const std::string& name);
    // The form of a file that the stage has: fragment shaders that of the first name.
    void file_of_stage(const std::string& fragment, const std::string& compute);
    void define(std::string_view name, int value);
    void generated(std::string_view what, const std::string& text);

    std::string take() { return std::move(text_); }

private:
    void record(const std::string& name);

    std::vector<std::string>& files_;
    Stage stage_;
    std::string text_;
    std::set<std::string> added_;
};

} // namespace isomotion::synthesis
