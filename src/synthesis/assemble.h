// Scene -> GLSL: the files of shaders/ that the scene calls for, and the generated field.
//
// The text depends on the formula's structure, the bounds' shape, the method, the number of lights
// and the channels asked for. It depends on no value: a frame changes uniforms only.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "synthesis/channel.h"

namespace isomotion::synthesis {

// How an array's elements reach the shader, `texels` vec4s each.
struct ArrayStorage {
    // Every OpenGL 3.3 has uniform blocks of 16 kB, and they are faster than texture buffers,
    // which hold the longer ones.
    enum class Kind { uniform_block, texture_buffer };
    static constexpr std::size_t uniform_block_bytes = 16384;

    Kind kind = Kind::uniform_block;
    std::string name; // of the block or the sampler
    int texels = 1;
    int capacity = 0; // elements
};

struct Shaders {
    std::string vertex;
    std::string march;  // one pass of the rays
    std::string active; // asks whether rays still march
    std::string shade;  // the picture from finished rays

    int parameter_vectors = 1; // vec4s of the block Parameters, before the arrays' counts
    int count_vectors = 0;     // ivec4s of counts
    std::vector<ArrayStorage> arrays;
    // Attachments of the shade pass: 0 colour, 1 verdict and evaluations, then these.
    std::vector<Channel> attachments;
    std::vector<std::string> files; // of shaders/, as used
};

Shaders assemble(const scene::Scene& scene, const std::vector<Channel>& channels = {});

// Whether the method looks at F alone, or at F and dF/dt.
bool samples_derivative(scene::Method method);

} // namespace isomotion::synthesis
