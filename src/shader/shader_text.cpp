#include "shader/shader_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "shader/shader_files.h"

namespace isomotion::shader {

ShaderText::ShaderText(Stage stage)
    : files_{"prelude.glsl"}
    , stage_(stage)
    , text_(read_shader("prelude.glsl")) { // #version must be the very first line
    if (stage_ == Stage::compute) {
        version(430);
        define("WORKGROUP_SIDE", workgroup_side);
    }
    file_of_stage("stage/fragment.glsl", "stage/compute.glsl");
}

void ShaderText::version(int glsl) {
    text_.replace(0, text_.find('\n'), fmt::format("#version {} core", glsl));
}

void ShaderText::file_of_stage(const std::string& fragment, const std::string& compute) {
    file(stage_ == Stage::fragment ? fragment : compute);
}

void ShaderText::file(const std::string& name) {
    if (!added_.contains(name)) file_again(name);
}

void ShaderText::file_again(const std::string& name) {
    added_.insert(name);
    text_ += fmt::format("\n// shaders/{}\n{}", name, read_shader(name));
    if (std::find(files_.begin(), files_.end(), name) == files_.end()) files_.push_back(name);
}

void ShaderText::define(std::string_view name, int value) {
    text_ += fmt::format("#define {} {}\n", name, value);
}

void ShaderText::define(std::string_view name, std::string_view text) {
    text_ += fmt::format("#define {} {}\n", name, text);
}

void ShaderText::generated(std::string_view what, const std::string& text) {
    text_ += fmt::format("\n// {}\n{}", what, text);
}

Pass ShaderText::pass(Role role, std::string name, When when, Cover cover) && {
    Pass pass;
    pass.role = role;
    pass.name = std::move(name);
    pass.when = when;
    pass.stage = stage_;
    pass.files = std::move(files_);
    pass.text = std::move(text_);
    if (stage_ == Stage::fragment) {
        pass.vertex = "#version 330 core\n";
        if (cover.shaded_flat) pass.vertex += "#define FLAT_SHADING\n";
        std::vector<std::string> files{"fullscreen.vert"};
        if (cover.area == Cover::Area::rectangles) files.insert(files.begin(), "rectangles.glsl");
        if (cover.area == Cover::Area::squares) files.insert(files.begin(), "squares.glsl");
        for (const std::string& file : files) pass.vertex += read_shader(file);
        pass.files.insert(pass.files.begin(), files.begin(), files.end());
    }
    note_declarations(pass);
    return pass;
}

} // namespace isomotion::shader
