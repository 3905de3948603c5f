// The state of a ray between two passes, kept in RGBA32F textures. A pass marches a bounded number
// of evaluations, and the next one continues exactly where it stopped. llvmpipe silently ends every
// loop after 65535 iterations of a shader, and GPUs are reset by draw calls of seconds.

const int PHASE_START = 0;   // sample t_near next
const int PHASE_MARCH = 1;   // sample `high` next: is a root in [low, high]?
const int PHASE_REFINE = 2;  // there is one: refine it
const int PHASE_GRADIENT = 3; // sample the gradient at the root, which is in `low` and `high`
const int PHASE_NEWTON = 4; // sample `high` next: the ray is settled, settled.glsl
const int PHASE_DONE = 5;
const int PHASE_SOLVE = 6; // between two samples: solve() continues; never stored

struct RayState {
    float low;         // t of the last sample before the root; when done, of the root
    vec2 f_low;        // F and dF/dt there
    float high;
    int phase;
    int verdict;
    int evaluations;
    int refinements;   // number done; while marching, see rough.glsl
#ifdef THREE_SAMPLES
    vec3 other;        // t, F and dF/dt of one more sample, see cubic.glsl
    float open_end;    // end of a piece that bounds left open, see rough.glsl; otherwise at most
                       // low; in PHASE_SOLVE, where F may touch 0, see touch_by_bounds.glsl
#endif
};

uniform sampler2D state_texture_0;
uniform sampler2D state_texture_1;
#ifdef THREE_SAMPLES
uniform sampler2D state_texture_2;
#endif

RayState load_state() {
    ivec2 at = ivec2(pixel_centre);
    vec4 a = IM_TEXEL(state_texture_0, at);
    vec4 b = IM_TEXEL(state_texture_1, at);
    RayState s;
    s.low = a.x;
    s.f_low = a.yz;
    s.high = a.w;
    s.phase = int(b.x);
    s.verdict = int(b.y);
    s.evaluations = int(b.z);
    s.refinements = int(b.w);
#ifdef THREE_SAMPLES
    vec4 c = IM_TEXEL(state_texture_2, at);
    s.other = c.xyz;
    s.open_end = c.w;
#endif
    return s;
}

RayState finish(RayState s, int verdict) {
    s.phase = PHASE_DONE;
    s.verdict = verdict;
    return s;
}

// The state before any sample; the next sample is at t.
RayState state_at(float t) {
    RayState s;
    s.low = t;
    s.f_low = vec2(0.0);
    s.high = t;
    s.phase = PHASE_START;
    s.verdict = 0;
    s.evaluations = 0;
    s.refinements = 0;
#ifdef THREE_SAMPLES
    s.other = vec3(0.0);
    s.open_end = 0.0;
#endif
    return s;
}
