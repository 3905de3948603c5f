// The values that a frame sets: FrameBlock of src/render/uniform_blocks.h, through fullscreen.vert.

#ifdef COMPUTE
// No vertex shader passes them on. Each invocation reads the block once, before its loop.
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
#else
// Rays, see src/scene/rays.h.
flat in vec4 ray_origin;
flat in vec4 ray_axis; // .w: 1, or 0 for parallel rays
flat in vec4 ray_right;
flat in vec4 ray_up;
// Box: its corners. Sphere: centre in bounds_min.xyz, radius in bounds_min.w.
flat in vec4 bounds_min;
flat in vec4 bounds_max;
flat in vec4 picture;    // 2/width, 2/height; the target's lower left pixel in the whole picture
// Step, near, far and horizon of Eq. 2 (march/amp_steps.glsl); for cubics the longest first step.
flat in vec4 thresholds;
// Bisections; evaluations per ray; for methods that bound F, the shortest and the first piece.
flat in vec4 limits;
// For methods by cubics: safety factor, longest step, displacement of a sample by rounding, finest
// step.
flat in vec4 cubics;
#endif
