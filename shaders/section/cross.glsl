// Crosses from one part of a ray that sections leave to the next. Needs parts.glsl.
//
// Between two parts a ray is in PHASE_CROSS: `low` is the end of a part or the ray's beginning, and
// `refinements` is the section that ended the part, or -1. A cap is there if F < 0: behind, if the
// part ended inside the solid, or ahead, if the next one begins inside it.
const int PHASE_CROSS = 6;

float field_at(vec3 p, vec3 direction) {
#ifdef BOUNDS_PIECES
    return field(p);
#else
    return sample_field(p, direction).x;
#endif
}

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

#ifdef SHADOWS
// Crosses sections on shadow rays. `high` holds the section behind.

RayState at_shadow_crossing(RayState s, float t, int behind) {
    s.phase = PHASE_CROSS;
    s.low = t;
    s.high = float(behind);
    return s;
}

// The crossing as an eye's ray has it; a miss if the ray doesn't cross.
RayState crossing_of(RayState s, bool crosses) {
    RayState crossing = at_crossing(state_at(s.low), s.low, int(s.high));
    if (!crosses) return finish(crossing, VERDICT_MISS);
    return crossing;
}

int outcome_of(RayState crossing) {
    if (crossing.phase != PHASE_DONE) return RAY_GOES_ON;
    return crossing.verdict == VERDICT_HIT ? RAY_IS_HIDDEN : RAY_IS_FREE; // NaN at a cut: no cap
}

// State of a shadow ray where its next part begins; keeps what is known of lights, and the count of
// evaluations.
RayState on_part(RayState s, RayState crossing) {
    RayState fresh = state_at(crossing.low);
    fresh.verdict = s.verdict;
    fresh.evaluations = s.evaluations + crossing.evaluations;
    return fresh;
}
#endif
