// Places the corners of rectangles for fullscreen.vert, six each: src/gpu/rectangles.h.
#define RECTANGLES

// Two words each: x and y, then width and height, in pixels, 16 bits a number.
uniform usamplerBuffer rectangles;
uniform vec2 pixel_of_viewport;

vec2 corner() {
    uvec2 words = texelFetch(rectangles, gl_VertexID / 6).xy;
    int k = gl_VertexID % 6; // of two triangles
    vec2 side = vec2((0x32 >> k) & 1, (0x2c >> k) & 1);
    vec2 pixel = vec2(words.x & 0xffffu, words.x >> 16) + side * vec2(words.y & 0xffffu, words.y >> 16);
    return pixel * pixel_of_viewport - 1.0;
}

