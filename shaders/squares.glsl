// Places squares of pixels for fullscreen.vert, each as a point: src/gpu/squares.h.
#define SQUARES

// A word each: x, y and the side, in parts of 8 pixels, of 14, 14 and 4 bits.
uniform usamplerBuffer squares;
uniform vec2 pixel_of_viewport;

vec2 corner() {
    uint word = texelFetch(squares, gl_VertexID).x;
    vec2 low = vec2(word & 0x3fffu, word >> 14 & 0x3fffu);
    float side = float(word >> 28);
    gl_PointSize = 8.0 * side;
    return 8.0 * (low + 0.5 * side) * pixel_of_viewport - 1.0;
}
