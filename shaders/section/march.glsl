// Marches a ray through the parts that sections leave of it, one after the other. march_part() of
// march/march.glsl knows only one part.

#ifdef CAPS_BY_SAMPLES
// The march's own samples decide about caps: the first one of a part in turn_in_part(); the last one,
// which f_low holds when a ray leaves its part.

RayState begin(Ray ray) {
    return begin_part(ray);
}

// Marches the part that the ray is in, or that begins next. If another part may follow, the state
// returned is at the start.
RayState through_part(Ray ray, RayState s) {
    Part part = part_from(ray, s.low);
    bool marches = s.phase != PHASE_DONE, starts = s.phase == PHASE_START;
    if (starts && !(part.begin < part.end)) return finish(s, VERDICT_MISS);
    if (starts) s.low = s.high = part.begin;
    cut_ahead = starts ? part.begin_cut : -1;
    cut_at = part.begin;
    Ray in_part = ray;
    in_part.t_far = part.end;
    s = march_part(in_part, s);
    bool leaves = marches && s.phase == PHASE_DONE && s.verdict == VERDICT_MISS && part.end_cut >= 0;
    if (!leaves) return s;
    if (s.f_low.x < 0.0) return end_on_cap(s, part.end, part.end_cut);
    // A half-space leaves nothing behind it.
    if (!is_ball(part.end_cut)) return s;
    RayState fresh = state_at(part.end);
    fresh.evaluations = s.evaluations;
    return fresh;
}

RayState march(Ray ray, RayState s) {
#if SECTION_BALLS == 0
    return through_part(ray, s);
#else
    int rounds = s.phase == PHASE_DONE ? 0 : PARTS + 1; // the last one finds that no part is left
    while (rounds > 0) {
        rounds -= 1;
        s = through_part(ray, s);
        if (s.phase != PHASE_START) break;
    }
    return s;
#endif
}
#else
// Samples at the ends of parts decide about caps. Needs cross.glsl.

RayState begin(Ray ray) {
    RayState s = begin_part(ray);
    if (s.phase == PHASE_DONE) return s;
    return at_crossing(s, ray.t_near, -1);
}

RayState march(Ray ray, RayState s) {
    int rounds = s.phase == PHASE_DONE ? 0 : PARTS + 1; // the last one may only cross
    while (rounds > 0) {
        rounds -= 1;
        s = cross_sections(s, ray);
        Part part = part_from(ray, s.low);
        Ray in_part = ray;
        in_part.t_far = part.end;
        bool marches = s.phase != PHASE_DONE;
        s = march_part(in_part, s);
        bool leaves = marches && s.phase == PHASE_DONE && s.verdict == VERDICT_MISS;
        if (!leaves || part.end_cut < 0) break;
        s = at_crossing(s, part.end, part.end_cut);
    }
    return s;
}
#endif
