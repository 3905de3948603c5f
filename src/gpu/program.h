#pragma once

#include "gpu/error.h"
#include "gpu/name.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

namespace isomotion::gpu {

/// A linked vertex and fragment shader, or a compute shader.
///
/// A driver drops uniforms and blocks that the shader does not need. Setting one that doesn't exist
/// has no effect.
class Program {
public:
    /// `label` names the program in messages. Throws CompileError. Software drivers generate
    /// machine code at the first draw, not here.
    Program(std::string_view vertex, std::string_view fragment, std::string_view label);

    /// A compute shader, which gpu::dispatch() runs. Throws ResourceError if the context has none,
    /// see gpu/compute.h.
    static Program compute(std::string_view source, std::string_view label);

    void use() const;

    /// -1 if the program has no such uniform.
    int uniform_location(std::string_view uniform) const;

    // Each also makes the program current.
    void set(std::string_view uniform, int value) const;
    void set(std::string_view uniform, unsigned value) const;
    void set(std::string_view uniform, float value) const;
    void set(std::string_view uniform, glm::vec2 value) const;
    void set(std::string_view uniform, glm::vec3 value) const;
    void set(std::string_view uniform, glm::vec4 value) const;
    void set(std::string_view uniform, glm::ivec2 value) const;
    void set(std::string_view uniform, glm::ivec3 value) const;
    void set(std::string_view uniform, glm::ivec4 value) const;
    void set(std::string_view uniform, std::span<const float> values) const;
    void set(std::string_view uniform, std::span<const glm::vec4> values) const;

    void bind_block(std::string_view block, unsigned binding) const;
    void bind_sampler(std::string_view sampler, int unit) const { set(sampler, unit); }

private:
    Program() = default;
    void link(std::initializer_list<unsigned> shaders, std::string_view label) const;

    struct Hash : std::hash<std::string_view> {
        using is_transparent = void;
    };

    Name name_{Kind::program};
    mutable std::unordered_map<std::string, int, Hash, std::equal_to<>> locations_;
};

} // namespace isomotion::gpu
