#pragma once

#include "gpu/name.h"

namespace isomotion::gpu {

/// A rectangle of pixels, from the lower left corner.
struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;

    bool operator==(const Rectangle&) const = default;
};

void set_viewport(Rectangle area);

/// Restricts draws and clears to a rectangle during its lifetime.
class Scissor {
public:
    explicit Scissor(Rectangle area);
    ~Scissor();
    Scissor(const Scissor&) = delete;
    Scissor& operator=(const Scissor&) = delete;
};

/// One triangle that covers the viewport. Unlike two triangles it has no diagonal along which
/// pixels are shaded twice. There are no attributes; a vertex shader places corner gl_VertexID (0,
/// 1, 2) at `vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0`.
class Fullscreen {
public:
    void draw() const;

private:
    // /< empty, but required: a core profile draws nothing without one.
    Name name_{Kind::vertex_array};
};

/// The texture unit in which textures are made and updated, so that this unbinds no texture that a
/// draw reads: bind those to lower units. (Every OpenGL 3.3 has 48.)
inline constexpr int editing_unit = 47;

/// Waits until all earlier commands are finished.
void finish();

} // namespace isomotion::gpu
