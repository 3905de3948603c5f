// Stores the state of a ray. Needs state.glsl.
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
