// Replaces march/store_state.glsl in compute shaders. Needs state.glsl.
layout(rgba32f, binding = 0) writeonly uniform image2D state_image_0;
layout(rgba32f, binding = 1) writeonly uniform image2D state_image_1;
#ifdef THREE_SAMPLES
layout(rgba32f, binding = 2) writeonly uniform image2D state_image_2;
#endif

void store_state(RayState s) {
    ivec2 at = ivec2(pixel_centre);
    imageStore(state_image_0, at, vec4(s.low, s.f_low, s.high));
    imageStore(state_image_1, at, vec4(float(s.phase), float(s.verdict), float(s.evaluations),
                                       float(s.refinements)));
#ifdef THREE_SAMPLES
    imageStore(state_image_2, at, vec4(s.other, s.open_end));
#endif
}
