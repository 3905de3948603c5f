#pragma once

#include "gpu/buffer.h"
#include "gpu/draw.h"
#include "gpu/name.h"

#include <span>

namespace isomotion::gpu {

/// Rectangles of pixels that are drawn at once, each as two triangles: for passes over parts of a
/// picture. Each pixel of one is shaded once. There are no attributes; a vertex shader places the
/// six corners of each by gl_VertexID from words(): shaders/fullscreen.vert.
class Rectangles {
public:
    /// Replaces all. Coordinates are 0 to 65535. Throws ResourceError if there are too many.
    void set(std::span<const Rectangle> rectangles);

    /// Two words each: x + 65536 y, width + 65536 height.
    const IntegerBuffer& words() const { return words_; }

    void draw() const;

private:
    IntegerBuffer words_{IntegerBuffer::Texel::two};
    int count_ = 0;
    Name name_{Kind::vertex_array}; ///< empty, as Fullscreen's
};

} // namespace isomotion::gpu
