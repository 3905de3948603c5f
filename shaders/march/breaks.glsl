// Where F may jump, have a pole or lack a value there is no root, whatever its sign does: methods
// that bound F pass the shortest piece around such a place, and begin anew behind it.

// (jumps, without value): the entire line where F may not be continuous; above 0 where it has no
// value anywhere.
vec4 breaks_over(Ray ray, vec2 piece) {
    vec2 x, y, z;
    box_over(ray, piece, x, y, z);
    return field_breaks(x, y, z);
}

bool may_break(Ray ray, vec2 piece) {
    return !(breaks_over(ray, piece).x > -IM_LARGEST);
}

RayState pass_break(RayState s, Ray ray) {
    float h = s.high - s.low;
    s.low = s.high;
    s.high = min(s.low + max(2.0 * h, finest_at(s.low)), ray.t_far);
    s.phase = PHASE_START;
    if (s.low >= ray.t_far) return finish(s, VERDICT_MISS);
    bool gives_up = s.evaluations >= int(limits.y) || !(s.high > s.low);
    return gives_up ? finish(s, VERDICT_STEP_LIMIT) : s;
}

// F is not a number at the piece's sample.
RayState no_value(RayState s, Ray ray) {
    float h = s.high - s.low;
    bool passes = h <= finest_at(s.low) || breaks_over(ray, vec2(s.low, s.high)).z > 0.0;
    return passes ? pass_break(s, ray) : cut(s, 0.5 * h);
}
