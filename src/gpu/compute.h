#pragma once

#include "gpu/context.h"
#include "gpu/texture.h"

#include <glm/vec2.hpp>

#include <string_view>

namespace isomotion::gpu {

/// Whether the driver has compute shaders: OpenGL 4.3.
bool has_compute(const ContextInfo& info);

/// Throws ResourceError that begins with `what` and tells the driver's version if it has none.
void expect_compute(const ContextInfo& info, std::string_view what);

/// The texture is where `layout(rgba32f, binding = unit) writeonly uniform image2D` stores to.
/// Every driver with compute shaders has 8 units.
void bind_image(const Texture& texture, int unit);

/// Runs so many work groups of the program in use. They start once all that was asked for before
/// has read what they overwrite; fetches, draws and reads after them see what they stored.
void dispatch(glm::ivec2 groups);

} // namespace isomotion::gpu
