#include "synthesis/shader_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "synthesis/shader_files.h"

namespace isomotion::synthesis {

ShaderText::ShaderText(std::vector<std::string>& files, Stage stage)
    : files_(files)
    , stage_(stage)
    , text_(read_shader("prelude.glsl")) { // #version must be the very first line
    record("prelude.glsl");
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
    record(name);
}

void ShaderText::record(const std::string& name) {
    if (std::find(files_.begin(), files_.end(), name) == files_.end()) files_.push_back(name);
}

void ShaderText::define(std::string_view name, int value) {
    text_ += fmt::format("#define {} {}\n", name, value);
}

void ShaderText::generated(std::string_view what, const std::string& text) {
    text_ += fmt::format("\n// {}\n{}", what, text);
}

} // namespace isomotion::synthesis
