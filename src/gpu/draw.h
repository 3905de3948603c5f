#pragma once

#include "gpu/name.h"

namespace isomotion::gpu {

/// Pixels, from the lower left corner.
struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

void set_viewport(Rectangle area);

/// Keeps draws and clears inside a rectangle for as long as it lives.
class Scissor {
public:
    explicit Scissor(Rectangle area);
    ~Scissor();
    Scissor(const Scissor&) = delete;
    Scissor& operator=(const Scissor&) = delete;
};

/// One triangle that covers the viewport: unlike two, it has no diagonal along which pixels are
/// shaded twice. There are no attributes; a vertex shader places corner gl_VertexID (0, 1, 2) at
/// `vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0`.
class Fullscreen {
public:
    void draw() const;

private:
    Name name_{Kind::vertex_array}; ///< empty, but a core profile draws nothing without one
};

/// The texture unit in which textures are made and updated, so that doing so unbinds none that a
/// draw reads: bind to lower ones. (Every OpenGL 3.3 has 48.)
inline constexpr int editing_unit = 47;

/// Waits until everything asked for so far is done.
void finish();

} // namespace isomotion::gpu
