// One shader, put together from files and generated parts.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "shader/pass.h"
#include "shader/stage.h"

namespace isomotion::shader {

// What a pass in fragments is drawn over. `shaded_flat`: fragments get their shading inputs from
// the vertex shader.
struct Cover {
    enum class Area { whole, rectangles, squares };
    Area area = Area::whole;
    bool shaded_flat = false;
};

class ShaderText {
public:
    // Begins with the prelude.
    explicit ShaderText(Stage stage = Stage::fragment);

    // Sets the version of GLSL, instead of 330.
    void version(int glsl);
    // Adds a file, once.
    void file(const std::string& name);
    // Adds a file for numbers of any type once more.
    void file_again(const std::string& name);
    // Adds the version of a file for the stage: the first name for fragment shaders.
    void file_of_stage(const std::string& fragment, const std::string& compute);
    void define(std::string_view name, int value);
    void define(std::string_view name, std::string_view text);
    void generated(std::string_view what, const std::string& text);

    const std::string& text() const { return text_; }
    const std::vector<std::string>& files() const { return files_; }

    // The pass with this text.
    Pass pass(Role role, std::string name, When when, Cover cover = {}) &&;

private:
    std::vector<std::string> files_;
    Stage stage_;
    std::string text_;
    std::set<std::string> added_;
};

} // namespace isomotion::shader
