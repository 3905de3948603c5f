// What one frame sets. The layout is FrameBlock of src/render/blocks.h.
layout(std140) uniform Frame {
    // Rays, see src/scene/rays.h.
    vec4 ray_origin;
    vec4 ray_axis; // .w: 1, or 0 for parallel rays
    vec4 ray_right;
    vec4 ray_up;
    // Box: its corners. Sphere: centre in bounds_min.xyz, radius in bounds_min.w.
    vec4 bounds_min;
    vec4 bounds_max;
    vec4 picture;    // 2/width, 2/height
    vec4 thresholds; // step, near, far, horizon of Eq. 2
    vec4 refinement; // bisections, most evaluations of a ray
};

// The lower left pixel of the tile being drawn, in the whole picture.
uniform ivec2 tile_origin;

const int VERDICT_MISS = 0;
const int VERDICT_HIT = 1;
const int VERDICT_STEP_LIMIT = 2;
const int VERDICT_NAN = 3;
const int VERDICT_ZERO_GRADIENT = 4;
