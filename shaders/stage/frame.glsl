// Defines the names of frame.glsl if no vertex shader passes them on. Each invocation reads the
// block once, before its loop. The order is that of fullscreen.vert.
layout(std140) uniform Frame {
    vec4 frame[10];
};
uniform ivec2 tile_origin;

vec4 ray_origin = frame[0];
vec4 ray_axis = frame[1];
vec4 ray_right = frame[2];
vec4 ray_up = frame[3];
vec4 bounds_min = frame[4];
vec4 bounds_max = frame[5];
vec4 picture = vec4(frame[6].xy, vec2(tile_origin));
vec4 thresholds = frame[7];
vec4 limits = frame[8];
vec4 cubics = frame[9];
