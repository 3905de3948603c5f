// Assembles a scene's passes: the files of shaders/ that the scene needs, and the generated field.
//
// A formula that a driver would compile too long is run by an interpreter instead (tape_text.h).
//
// The text depends on the formula's structure, the bounds' shape, the method, the effects named,
// the number of lights and the channels requested. It also depends on what reading the scene found
// about the formula: whether it is smooth, the power of two that it is multiplied with, and how
// crowded its elements are, which counts for more in small pictures. It depends on no other value:
// a frame changes uniforms only.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "shader/channel.h"
#include "shader/pass.h"
#include "shader/stage.h"

namespace isomotion::shader {

// Pixels across the smallest beams.
inline constexpr int usual_beam = 8;

// The compiler of the shaders. `webgl` is WebGL2: GLSL ES 3.00, in which beams keep bits instead of
// lists of elements, and lights have no beams.
enum class Platform { opengl, webgl };

// How a scene's pictures are drawn.
struct Drawing {
    Stage stage = Stage::fragment;
    Platform platform = Platform::opengl;
    bool branches = false;      // the processor skips what no ray of a group needs: graphics cards
    bool writes_buffers = true; // shaders may (OpenGL 4.3), which the lists of beams need
    int finest_beam =
        usual_beam;             // or 1, for beams of single pixels, which cost more than they save
    bool tells_endings = false; // the picture has the channel ending, as certified pictures have
    std::int64_t pixels = 0;    // of a picture, as far as is known
};

Passes assemble(const scene::OneSurface& one, const std::vector<Channel>& channels = {},
                const Drawing& drawing = {});

} // namespace isomotion::shader
