// Where a ray stands between two passes. It lives in two RGBA32F textures: a pass marches a bounded
// number of evaluations and the next goes on exactly where it stopped. llvmpipe ends every loop
// after 65535 iterations of a shader, silently, and real GPUs are reset by draw calls of seconds.

const int PHASE_START = 0;   // sample t_near next
const int PHASE_MARCH = 1;   // sample `high` next: is there a root in [low, high]?
const int PHASE_REFINE = 2;  // there is one: bisect
const int PHASE_GRADIENT = 3; // the root is in `low` and `high`: sample the gradient there
const int PHASE_DONE = 4;

struct RayState {
    float low;         // t of the last sample before the root; of the root when done
    vec2 f_low;        // F and dF/dt there
    float high;
    int phase;
    int verdict;
    int evaluations;
    int bisections;    // done so far
};

uniform sampler2D state_texture_0;
uniform sampler2D state_texture_1;

RayState load_state() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 a = texelFetch(state_texture_0, at, 0);
    vec4 b = texelFetch(state_texture_1, at, 0);
    return RayState(a.x, a.yz, a.w, int(b.x), int(b.y), int(b.z), int(b.w));
}
