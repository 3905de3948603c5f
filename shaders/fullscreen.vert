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
layout(std140) uniform Shading { // shade/shading_flat.glsl
    vec4 flat_part[4];
    mat4 to_world;
    vec4 depth;
};
flat out vec4 material_color, background, light_direction[1], light_color[1];
#endif

#if !defined(RECTANGLES) && !defined(SQUARES)
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
