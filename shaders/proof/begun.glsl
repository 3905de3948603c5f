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
