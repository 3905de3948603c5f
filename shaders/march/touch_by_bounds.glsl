// Lets bounds decide where cubics take F for 0 without a change of sign. Bounds tell q^2 - l^3 from
// 0 beside its cuspidal edge, where q = 0 and l < 0, although samples near q = 0 are all noise.

vec2 bounds_of_value(Ray ray, vec2 piece) {
    vec2 x, y, z;
    box_over(ray, piece, x, y, z);
    return field_interval(x, y, z);
}

// Whether F may be 0 in some part of the piece of length `shortest`. False if nobody asks.
bool may_be_0(bool asks, Ray ray, vec2 piece, float shortest) {
    float begin = piece.x, length = piece.y - piece.x;
    bool found = false, searches = asks;
    int tries = 0;
    // Software renderers run the loop at least once, whoever asks.
    while (searches) {
        bool free = excludes_0(bounds_of_value(ray, vec2(begin, begin + length)));
        found = !free && length <= shortest;
        if (free) begin += length;
        length = free ? 2.0 * length : max(0.5 * length, shortest);
        tries += 1;
        found = found || tries == MOST_TRIES;
        searches = !found && begin < piece.y;
    }
    return found;
}

// Continues the state as if F were not 0 at t, where it may touch 0.
RayState doubt_touch(RayState s, float t) {
    s.open_end = t;
    s.phase = PHASE_SOLVE;
    return s;
}

// Decides, between two samples, whether F touches 0.
RayState solve(RayState s, Ray ray) {
    bool asks = s.phase == PHASE_SOLVE;
    float finest = cubics.w, rounding = cubics.z;
    vec2 around = vec2(s.open_end - finest, s.open_end + finest);
    bool touches = may_be_0(asks, ray, around, rounding);
    if (touches) return found(s, s.open_end);
    if (!asks) return s;
    s.phase = PHASE_MARCH;
    if (s.low >= ray.t_far) return finish(s, VERDICT_MISS);
    bool stands = !(s.high > s.low) || s.evaluations >= int(limits.y);
    if (stands) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}
