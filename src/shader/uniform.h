// A plain uniform, with name and value. Programs without a uniform of that name ignore it.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

namespace isomotion::shader {

using UniformValue = std::variant<int, float, glm::vec2, glm::vec3, glm::vec4, glm::ivec2,
                                  glm::ivec3, std::vector<glm::vec4>>;

struct Uniform {
    std::string name;
    UniformValue value;
};

using Uniforms = std::vector<Uniform>;

} // namespace isomotion::shader
