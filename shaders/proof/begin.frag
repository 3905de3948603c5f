// Begins the proofs of single rays. Ends those for which the block proved all but that the root is
// close to where it was found; Newton's step decides that, see prove.glsl. Opens the depth gate for
// the others.
layout(location = 0) out vec4 proof;

void main() {
    Ending ended = load_ending(ivec2(pixel_centre));
    vec4 block = load_block();
    Ray marched = marched_ray();
    Ray ray = ray_to_prove(marched);
    float t = ended.hit ? ended.t : ray.t_far;
    vec2 f = value_at(ray, t);
    float uncertain = max(-f.x, f.y);

    precise float slope = block.w / ray.to_eye * 0.999999;
    precise float off = uncertain / slope * 1.000002 + 4.76837158e-7 * abs(t);
    float margin = 2.0 * tube.z;
    // F is monotone from there to 2 tube.w and the margin behind t.
    bool isolates = slope > 0.0 && off <= tube.w &&
                    t - off > settled_by_block(block) * ray.to_eye + margin &&
                    t - off > margin - ray.to_eye &&
                    inside_bounds(ray_point(ray, t - off)) && inside_bounds(ray_point(ray, t + off));
    bool hits = ended.hit && (isolates || block.w == BLOCK_HITS);
    // Beams proved a miss without a part to march, or it misses the bounds by more than rounding.
    bool misses = ended.miss && (block.w == BLOCK_MISSES || !(marched.t_near <= marched.t_far));

    int outcome = hits ? PROOF_HIT : misses ? PROOF_MISS : PROOF_UNFINISHED;
    if (outcome == PROOF_UNFINISHED && t < ray.t_near) outcome = ended.hit ? PROOF_SIGN : PROOF_MISS;
    if (!ended.hit && !ended.miss) outcome = PROOF_NONE;
    proof = packed_proof(ProofState(t, ended.hit ? uncertain : 0.0,
                                    max(t - ray.t_near, shortest_piece), outcome, ended.hit, 0));
    gl_FragDepth = outcome == PROOF_UNFINISHED ? 1.0 : 0.0;
}
