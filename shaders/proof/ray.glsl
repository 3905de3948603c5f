// A ray's proof: its part of the ray, its state, its numbers, and boxes around its points.

// The part of a ray that its proof covers: what beams left of it and, rounding included, the proof
// of its block.
uniform sampler2D block_texture;

vec4 load_block() {
    return IM_TEXEL(block_texture, ivec2(pixel_centre) / PROVED_BLOCK);
}

// The tau up to which the block's proof settled the ray, see block.frag.
float settled_by_block(vec4 block) {
    vec2 place = vec2(ivec2(pixel_centre) % PROVED_BLOCK) * (2.0 / float(PROVED_BLOCK - 1)) - 1.0;
    return block.x + dot(block.yz, place);
}

Ray marched_ray() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    return ray;
}

Ray ray_to_prove(Ray ray) {
#ifdef LISTS
    choose_list_of_proof(ray, load_ending(ivec2(pixel_centre)));
#endif
    ray.t_near = max(ray.t_near, settled_by_block(load_block()) * ray.to_eye) - tube.z;
    ray.t_far += tube.z;
    return ray;
}

// The state of a ray's proof: Proof of src/render/proofs.h.
const int PROOF_UNFINISHED = -1;
const int PROOF_NONE = 0;      // the march ended with neither a root nor a miss
const int PROOF_HIT = 1;
const int PROOF_MISS = 2;
const int PROOF_HIDDEN = 3;    // a root may lie before the one found, or on a ray without one
const int PROOF_SIGN = 4;      // F may not change its sign at the root, or more than once
const int PROOF_BUDGET = 5;
const int PROOF_UNBOUNDED = 6; // F or its slope has no bound somewhere

// The progress of a ray's proof. A texel keeps it between passes.
struct ProofState {
    float settled; // nothing is left to prove from here to the end of the ray's part
    float value;   // F there is at least this far from 0, with this sign; 0: unknown. At the root:
                   // how large F can be
    float piece;   // length of the next piece
    int outcome;
    bool at_root;  // the next piece, or the last one, is about the root
    int pieces;    // number so far; forgotten when the proof ends
};

vec4 packed_proof(ProofState s) {
    float first = s.outcome == PROOF_UNFINISHED ? -1.0 - float(s.pieces) : float(s.outcome);
    return vec4(first, s.settled, s.value, s.at_root ? -s.piece : s.piece);
}

ProofState unpacked_proof(vec4 kept) {
    bool goes_on = kept.x < 0.0;
    return ProofState(kept.y, kept.z, abs(kept.w), goes_on ? PROOF_UNFINISHED : int(kept.x),
                      kept.w < 0.0, goes_on ? int(-kept.x) - 1 : 0);
}

#ifdef DOUBLES
// Proofs in doubles use the exact ray of the same numbers, which float32 rounded to the marched
// one.
struct ProofRay {
    dvec3 anchor, direction;
    double t_near, t_far; // of the marched ray
    double to_eye;
};

ProofRay proof_ray(Ray marched) {
    dvec2 at = (dvec2(pixel_centre) + dvec2(picture.zw)) * dvec2(picture.xy) - 1.0;
    dvec3 across = at.x * dvec3(ray_right.xyz) + at.y * dvec3(ray_up.xyz);
    dvec3 from_eye = dvec3(ray_axis.xyz) + double(ray_axis.w) * across;
    dvec3 squares = from_eye * from_eye;
    double distance_to_eye = sqrt(squares.x + squares.y + squares.z);
    return ProofRay(dvec3(ray_origin.xyz) + across, from_eye / distance_to_eye,
                    double(marched.t_near), double(marched.t_far), distance_to_eye);
}

dvec3 ray_point(ProofRay ray, double t) {
    return ray.anchor + t * ray.direction;
}

// Rounds x to a float that is not farther from 0.
float toward_zero(double x) {
    return 0.9999998 * float(clamp(x, -double(3.4e38), double(3.4e38)));
}

// The t at which a piece is sampled: its beginning; or the root, where floats were too coarse.
const bool SAMPLES_ROOTS = true;
double sampled_at(ProofState s, double low) { return s.at_root ? double(s.settled) : low; }
double uncertain_at_root(ProofState s, dvec2 sampled) { return max(-sampled.x, sampled.y); }
#else
// Proofs in floats use the ray that is marched.
#define ProofRay Ray

ProofRay proof_ray(Ray marched) {
    return marched;
}

float toward_zero(float x) {
    return x;
}

// The t at which a piece is sampled: its beginning. The range of F at the root is known.
const bool SAMPLES_ROOTS = false;
float sampled_at(ProofState s, float low) { return low; }
float uncertain_at_root(ProofState s, vec2 sampled) { return s.value; }
#endif

// Boxes around the points of all rays that float32 may make of the pixel's ray: the one here and
// the one that was marched (src/roots/tube.h).

uniform float shortest_piece;

struct Box {
    REAL2 x, y, z;
};

// Encloses the points from t = low to high.
Box box_around(ProofRay ray, REAL low, REAL high) {
    precise REAL3 a = ray.anchor + low * ray.direction;
    precise REAL3 b = ray.anchor + high * ray.direction;
    precise REAL3 least = min(a, b) - tube.x;
    precise REAL3 most = max(a, b) + tube.x;
    return Box(REAL2(least.x, most.x), REAL2(least.y, most.y), REAL2(least.z, most.z));
}
