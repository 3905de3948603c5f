// Stores the state of a ray. Needs state.glsl.
#ifdef COMPUTE
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
#else
layout(location = 0) out vec4 state_0;
layout(location = 1) out vec4 state_1;
#ifdef THREE_SAMPLES
layout(location = 2) out vec4 state_2;
#endif

void store_state(RayState s) {
    state_0 = vec4(s.low, s.f_low, s.high);
    state_1 = vec4(float(s.phase), float(s.verdict), float(s.evaluations), float(s.refinements));
#ifdef THREE_SAMPLES
    state_2 = vec4(s.other, s.open_end);
#endif
}
#endif
