// One shader, put together from files and generated parts.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "shader/feature.h"
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
    // Adds what is active in a file (active_lines.h), once.
    void file(const std::string& name);
    // Adds a file for numbers of any type once more.
    void file_again(const std::string& name);
    // Adds a file whose words in capital letters stand for others, with flags of its own.
    void instance(const std::string& name, const std::map<std::string, std::string>& words,
                  const std::vector<Feature>& flags = {});
    // Sets a flag, or a value, before the files that ask for it.
    void define(Feature flag);
    void define(Feature feature, int value);
    void define(Feature feature, std::string_view value);
    void generated(std::string_view what, const std::string& text);

    const std::string& text() const { return text_; }
    const std::vector<std::string>& files() const { return files_; }

    // The pass with this text.
    Pass pass(Role role, std::string name, When when, Cover cover = {}) &&;

private:
    void append(const std::string& name, const std::string& text);

    std::vector<std::string> files_;
    Features features_;
    Stage stage_;
    std::string text_;
    std::set<std::string> added_;
};

} // namespace isomotion::shader
