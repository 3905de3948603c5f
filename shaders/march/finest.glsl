// Pieces of a ray that bounds are taken over, and the shortest.

// The shortest piece at t: a part of the pixel, and no fewer floats than 4.
float finest_at(float t) {
    return max(limits.z, 4.76837158e-7 * abs(t));
}

// The piece is to be shorter.
RayState cut(RayState s, float length) {
    s.high = s.low + length;
    bool gives_up = s.evaluations >= int(limits.y) || !(s.high > s.low);
    if (gives_up) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}
