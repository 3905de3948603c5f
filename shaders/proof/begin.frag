// Begins the proofs of single rays. Those end here for which the block proved all but that the root is
// close to where it was found; Newton's step decides that, see prove.glsl.
layout(location = 0) out vec4 proof;

// How the proof of a single ray begins; the misses and endings that need none have ended.
ProofState begun_proof(Ray marched, Ray ray, Ending ended) {
    float t = ended.hit ? ended.t : ray.t_far;
    vec2 f = value_at(ray, t);
    // It misses the bounds by more than rounding.
    bool misses = ended.miss && !(marched.t_near <= marched.t_far);
    int outcome = misses ? PROOF_MISS : PROOF_UNFINISHED;
    if (outcome == PROOF_UNFINISHED && t < ray.t_near) outcome = ended.hit ? PROOF_SIGN : PROOF_MISS;
    if (!ended.hit && !ended.miss) outcome = PROOF_NONE;
    return ProofState(t, ended.hit ? max(-f.x, f.y) : 0.0, max(t - ray.t_near, shortest_piece),
                      outcome, ended.hit, 0);
}

void main() {
    Ending ended = load_ending(ivec2(pixel_centre));
    vec4 block = load_block();
    Ray marched = marched_ray();
    Ray ray = ray_to_prove(marched);
    ProofState s = begun_proof(marched, ray, ended);

    precise float slope = block.w / ray.to_eye * 0.999999;
    precise float off = s.value / slope * 1.000002 + 4.76837158e-7 * abs(s.settled);
    float margin = 2.0 * tube.z;
    // F is monotone from there to 2 tube.w and the margin behind the root.
    bool isolates = slope > 0.0 && off <= tube.w &&
                    s.settled - off > settled_by_block(block) * ray.to_eye + margin &&
                    s.settled - off > margin - ray.to_eye &&
                    inside_bounds(ray_point(ray, s.settled - off)) &&
                    inside_bounds(ray_point(ray, s.settled + off));
    if (ended.hit && isolates) s.outcome = PROOF_HIT;
    proof = packed_proof(s);
}
