#pragma once

#include "gpu/buffer.h"
#include "gpu/name.h"

#include <span>

namespace isomotion::gpu {

/// A square of pixels by its lower left corner.
struct Square {
    int x = 0, y = 0, side = 0;
};

/// Squares of pixels that are drawn at once, each as a point. A rectangle takes two triangles, and
/// software renderers shade the pixels along their common side twice. There are no attributes; a
/// vertex shader places the points by gl_VertexID from words(): shaders/fullscreen.vert.
class Squares {
public:
    /// Every driver that we know draws points of 63 pixels.
    static constexpr int longest_side = 56;

    /// Replaces all. Coordinates and sides are multiples of 8; sides are at most longest_side.
    /// Throws ResourceError if there are too many.
    void set(std::span<const Square> squares);

    /// A word each: x, y and the side in parts of 8 pixels, of 14, 14 and 4 bits.
    const IntegerBuffer& words() const { return words_; }

    void draw() const;

private:
    IntegerBuffer words_{IntegerBuffer::Texel::one};
    int count_ = 0;
    Name name_{Kind::vertex_array}; ///< empty, as Fullscreen's
};

} // namespace isomotion::gpu
