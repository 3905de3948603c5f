// Finds the parts of a ray that sections leave, and ends rays on caps. Needs ray.glsl, state.glsl and
// sections.glsl.

// A part of a ray. The cuts are the sections that end it at each end, or -1.
struct Part {
    float begin, end; // empty if begin >= end
    int begin_cut, end_cut;
};

// The interval of the ray inside a ball, by march/ray.glsl's method; (1, 0) if it is empty.
vec2 in_ball(Ray ray, vec4 ball) {
    vec3 from = ray.anchor - ball.xyz;
    float middle = -dot(from, ray.direction);
    vec3 foot = from + middle * ray.direction;
    float square = ball.w * ball.w - dot(foot, foot);
    float half_chord = sqrt(max(square, 0.0));
    return square > 0.0 ? vec2(middle - half_chord, middle + half_chord) : vec2(1.0, 0.0);
}

// Returns the first part from t = from on.
Part part_from(Ray ray, float from) {
    Part part = Part(from, ray.t_far, -1, -1);
    // Half-spaces leave a single interval.
    for (int k = 0; k < SECTIONS; ++k) {
        if (is_ball(k)) continue;
        float height = section_value(k, ray.anchor), slope = dot(sections[k].xyz, ray.direction);
        bool is_parallel = abs(slope) < 1.0e-12;
        float at = is_parallel ? 0.0 : -height / slope;
        if (is_parallel && height > 0.0) part.end = from - 1.0;
        if (!is_parallel && slope < 0.0 && at >= part.begin) {
            part.begin = at;
            part.begin_cut = k;
        }
        if (!is_parallel && slope > 0.0 && at <= part.end) {
            part.end = at;
            part.end_cut = k;
        }
    }
#if SECTION_BALLS != 0
    // One ball may end in the next.
    for (int turn = 0; turn < SECTIONS; ++turn) {
        for (int k = 0; k < SECTIONS; ++k) {
            if (!is_ball(k)) continue;
            vec2 within = in_ball(ray, sections[k]);
            if (within.x <= part.begin && part.begin <= within.y) {
                part.begin = within.y;
                part.begin_cut = k;
            }
        }
    }
    for (int k = 0; k < SECTIONS; ++k) {
        if (!is_ball(k)) continue;
        vec2 within = in_ball(ray, sections[k]);
        if (within.x < within.y && within.x > part.begin && within.x <= part.end) {
            part.end = within.x;
            part.end_cut = k;
        }
    }
#endif
    return part;
}

// Ends a ray on the cap of a section; cap_of() returns that section, or -1.

RayState end_on_cap(RayState s, float t, int section) {
    s.low = t;
    s.refinements = -1 - section;
    return finish(s, VERDICT_HIT);
}

int cap_of(RayState s) {
    bool is_cap = s.phase == PHASE_DONE && s.verdict == VERDICT_HIT && s.refinements < 0;
    return is_cap ? -1 - s.refinements : -1;
}
