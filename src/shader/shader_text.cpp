#include "shader/shader_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "shader/active_lines.h"
#include "shader/shader_code.h"
#include "shader/shader_files.h"

namespace isomotion::shader {
ShaderText::ShaderText(Stage stage)
    : files_{"prelude.glsl"}
    , stage_(stage)
    , text_(read_shader("prelude.glsl")) { // #version must be the very first line
    if (stage_ == Stage::compute) {
        version(430);
        define(Feature::compute);
        define(Feature::workgroup_side, workgroup_side);
    }
    file("stage/stage.glsl");
}

void ShaderText::version(int glsl) {
    text_.replace(0, text_.find('\n'), fmt::format("#version {} core", glsl));
}

void ShaderText::file(const std::string& name) {
    if (!added_.contains(name)) file_again(name);
}

void ShaderText::file_again(const std::string& name) {
    append(name, active_lines(name, read_shader(name), features_));
}

void ShaderText::instance(const std::string& name, const std::map<std::string, std::string>& words,
                          const std::vector<Feature>& flags) {
    Features own = features_;
    for (const Feature flag : flags) own.add(flag);
    append(name, replaced(active_lines(name, read_shader(name), own), words));
}

void ShaderText::append(const std::string& name, const std::string& text) {
    added_.insert(name);
    text_ += fmt::format("\n// shaders/{}\n{}", name, text);
    if (std::find(files_.begin(), files_.end(), name) == files_.end()) files_.push_back(name);
}

void ShaderText::define(Feature flag) { features_.add(flag); }

void ShaderText::define(Feature feature, int value) { define(feature, std::to_string(value)); }

void ShaderText::define(Feature feature, std::string_view value) {
    if (features_.add(feature, std::string(value)))
        text_ += fmt::format("#define {} {}\n", traits(feature).macro, value);
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
        Features features;
        if (cover.shaded_flat) features.add(Feature::flat_shading);
        if (cover.area == Cover::Area::rectangles) features.add(Feature::rectangles);
        if (cover.area == Cover::Area::squares) features.add(Feature::squares);
        const std::string file = "fullscreen.vert";
        pass.vertex = "#version 330 core\n" + active_lines(file, read_shader(file), features);
        pass.files.insert(pass.files.begin(), file);
    }
    note_declarations(pass);
    return pass;
}

} // namespace isomotion::shader
