#pragma once

#include "gpu/context.h"
#include "gpu/texture.h"

#include <glm/vec2.hpp>

#include <string_view>

namespace isomotion::gpu {

/// Whether the driver has compute shaders: OpenGL 4.3.
bool has_compute(const ContextInfo& info);

/// Throws ResourceError that begins with `what` and states the driver's version if it has none.
void expect_compute(const ContextInfo& info, std::string_view what);

/// Makes the texture the destination of `layout(rgba32f, binding = unit) writeonly uniform
/// image2D`. Every driver with compute shaders has 8 units.
void bind_image(const Texture& texture, int unit);

/// Runs so many work groups of the program in use. They start after earlier commands have read what
/// they overwrite; later fetches, draws and reads see what they stored.
void dispatch(glm::ivec2 groups);

} // namespace isomotion::gpu
