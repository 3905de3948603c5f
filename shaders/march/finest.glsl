// The lengths of the pieces over which a ray is bounded.

// The shortest piece at t: a part of a pixel, and at least 4 floats.
float finest_at(float t) {
    return max(limits.z, 4.76837158e-7 * abs(t));
}

// Shortens the piece to this length.
RayState cut(RayState s, float length) {
    s.high = s.low + length;
    bool gives_up = s.evaluations >= int(limits.y) || !(s.high > s.low);
    if (gives_up) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}
