// Crosses from one part of a ray that sections leave to the next. Needs parts.glsl and field_at().
//
// Between two parts a ray is in PHASE_CROSS: `low` is the end of a part or the ray's beginning, and
// `refinements` is the section that ended the part, or -1. A cap is there if F < 0: behind, if the
// part ended inside the solid, or ahead, if the next one begins inside it.
const int PHASE_CROSS = 6;

RayState at_crossing(RayState s, float t, int behind) {
    s.low = t;
    s.refinements = behind;
    s.phase = PHASE_CROSS;
    return s;
}

RayState cross_sections(RayState s, Ray ray) {
    bool crosses = s.phase == PHASE_CROSS;
    float t = s.low;
    int section = s.refinements;
    bool ahead = section < 0; // nothing is behind a ray's beginning
    while (crosses) {
        if (ahead) {
            Part next = part_from(ray, t);
            t = next.begin;
            section = next.begin_cut;
            if (!(next.begin < next.end)) {
                s = finish(s, VERDICT_MISS);
                break;
            }
        }
        bool asks = section >= 0;
#ifdef LISTS
        choose_list(t);
#endif
        float f = field_at(ray_point(ray, t), ray.direction);
        if (asks) s.evaluations += 1;
        if (asks && f < 0.0) {
            s = end_on_cap(s, t, section);
            break;
        }
        if (ahead) {
            RayState fresh = state_at(t);
            fresh.evaluations = s.evaluations;
            s = fresh;
            break;
        }
        ahead = true;
    }
    return s;
}
