// Marches a ray through the parts that sections leave of it, one after the other. march_part(), the
// march of march.glsl, knows only one part. Needs cross.glsl.

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
