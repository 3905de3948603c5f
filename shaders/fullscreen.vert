// Draws one triangle over the whole viewport, or rectangles or squares in it. Passes the frame on to the
// fragments as flat values, which cost software renderers nothing; each vec4 read from a block costs every
// pixel as much as several operations.
layout(std140) uniform Frame {
    vec4 frame[10];
};
uniform ivec2 tile_origin; // the target's lower left pixel, in the whole picture

flat out vec4 ray_origin, ray_axis, ray_right, ray_up, bounds_min, bounds_max, picture, thresholds,
    limits, cubics;

#ifdef FLAT_SHADING
layout(std140) uniform Shading { // shade/shading.glsl
    vec4 flat_part[4];
    mat4 to_world;
    vec4 depth;
};
flat out vec4 material_color, background, light_direction[1], light_color[1];
#endif

#ifdef RECTANGLES
// Six corners of each rectangle, src/gpu/rectangles.h. Two words each: x and y, then width and
// height, in pixels, 16 bits a number.
uniform usamplerBuffer rectangles;
uniform vec2 pixel_of_viewport;

vec2 corner() {
    uvec2 words = texelFetch(rectangles, gl_VertexID / 6).xy;
    int k = gl_VertexID % 6; // of two triangles
    vec2 side = vec2((0x32 >> k) & 1, (0x2c >> k) & 1);
    vec2 pixel = vec2(words.x & 0xffffu, words.x >> 16) + side * vec2(words.y & 0xffffu, words.y >> 16);
    return pixel * pixel_of_viewport - 1.0;
}
#elif defined(SQUARES)
// Each square is a point, src/gpu/squares.h. A word each: x, y and the side, in parts of 8 pixels,
// of 14, 14 and 4 bits.
uniform usamplerBuffer squares;
uniform vec2 pixel_of_viewport;

vec2 corner() {
    uint word = texelFetch(squares, gl_VertexID).x;
    vec2 low = vec2(word & 0x3fffu, word >> 14 & 0x3fffu);
    float side = float(word >> 28);
    gl_PointSize = 8.0 * side;
    return 8.0 * (low + 0.5 * side) * pixel_of_viewport - 1.0;
}
#else
vec2 corner() { return vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0; }
#endif

void main() {
    gl_Position = vec4(corner(), 0.0, 1.0);
    ray_origin = frame[0];
    ray_axis = frame[1];
    ray_right = frame[2];
    ray_up = frame[3];
    bounds_min = frame[4];
    bounds_max = frame[5];
    picture = vec4(frame[6].xy, vec2(tile_origin));
    thresholds = frame[7];
    limits = frame[8];
    cubics = frame[9];
#ifdef FLAT_SHADING
    material_color = flat_part[0];
    background = flat_part[1];
    light_direction[0] = flat_part[2];
    light_color[0] = flat_part[3];
#endif
}
