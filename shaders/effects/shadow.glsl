// Marches shadow rays from each point to every light that casts shadows, one light after the other.

// What the state of a pixel's shadow rays tells of its lights. `verdict` has a bit for each light
// that is hidden; above these it counts the lights that were begun, and the rays that stay
// undecided. When all is done, only the bits are left, and the rays undecided are in `refinements`.
const int BEGUN_LIGHT = 1 << LIGHTS, UNDECIDED_RAY = 16 * BEGUN_LIGHT;

int begun_lights(RayState s) {
    return (s.verdict >> LIGHTS) & 15;
}

RayState finish_lights(RayState s) {
    s.refinements = s.verdict / UNDECIDED_RAY;
    return finish(s, s.verdict % BEGUN_LIGHT);
}

// Whether the pixel's rays have taken so much that the present one ends: it has met no sign of F but
// that of its light, so the light is seen. What the rays of earlier lights left may be used up.
// `before`: evaluations for other surfaces.
bool is_undecided(RayState s, int before) {
    return s.evaluations - before >= most_of_a_shadow_ray() * begun_lights(s);
}

#if SURFACE > 0
// Shadow rays go on for the lights that no surface before this one hides, of which shadow_texture tells.
uniform sampler2D shadow_texture;

RayState begin_lights() {
    RayState s = state_at(0.0);
    vec4 others = IM_TEXEL(shadow_texture, ivec2(pixel_centre));
    s.verdict = int(others.y) + UNDECIDED_RAY * int(others.w);
    s.evaluations = int(others.z);
    return s;
}

int evaluations_before() {
    return int(IM_TEXEL(shadow_texture, ivec2(pixel_centre)).z);
}
#else
// Shadow rays begin with no light hidden.
RayState begin_lights() {
    return state_at(0.0);
}

int evaluations_before() {
    return 0;
}
#endif

uniform bool first_pass;
uniform int evaluations_per_pass;
#if defined(LISTS) || defined(GRID)
uniform float element_budget;
#endif

Ray shadow_ray(SurfacePoint p, int k) {
    LightRay light = light_at(k, p.position);
    Ray ray = Ray(p.position + p.offset * p.normal, light.direction, 0.0, 0.0, 0.0);
    vec2 inside = clip_to_bounds(ray.anchor, ray.direction);
    ray.t_near = max(inside.x, 0.0);
    ray.t_far = min(inside.y, light.reach);
#ifdef LIGHT_BEAMS
    if (((LIGHT_BEAMS >> k) & 1) != 0) come_from_light(ray, k);
    else come_to_light();
#endif
    return ray;
}

// Starts the next light that may be hidden. Lights behind the surface are skipped.
RayState next_light(RayState s, SurfacePoint p) {
    bool anything = is_on_surface(p) || p.on_ground;
    int begun = begun_lights(s);
    int asked = SHADOWS;
#if SURFACE > 0
    asked &= ~s.verdict; // what the surfaces before leave
#endif
    for (int k = begun; k < LIGHTS && anything; ++k) {
        if (((asked >> k) & 1) == 0) continue;
        if (dot(p.normal, light_at(k, p.position).direction) <= 0.0) continue;
        s.verdict += (k + 1 - begun) * BEGUN_LIGHT;
        s.refinements = 0;
        s.phase = PHASE_START;
#ifdef THREE_SAMPLES
        s.other = vec3(0.0);
        s.open_end = 0.0;
#endif
        return s;
    }
    return finish_lights(s);
}

void march_pixel() {
    SurfacePoint p = load_surface();
    RayState s;
    if (first_pass) {
        s = begin_lights();
    } else {
        s = load_state();
    }
    int turns = evaluations_per_pass, before = evaluations_before();
#ifdef LISTS
    // Loops must end before drivers end them. Drivers go through the longest list of some eight
    // neighbours, each with its own list; the last sample may go through all elements.
    int elements = int(0.125 * element_budget) - array_counts[0].x;
#endif
#ifdef GRID
    int most_elements = int(0.125 * element_budget);
#endif
    // The loops are nested, since software renderers skip no branch and would otherwise look for
    // the next light at every sample.
    bool begins = first_pass;
    while (true) {
        if (begins) s = next_light(s, p);
        if (s.phase == PHASE_DONE) break;
        int light = begun_lights(s) - 1;
        Ray ray = shadow_ray(p, light);
        if (begins) s.low = s.high = ray.t_near;
        int outcome = ray.t_near < ray.t_far ? RAY_GOES_ON : RAY_IS_FREE;
#ifdef SECTIONS
        if (begins) s = at_shadow_crossing(s, ray.t_near, -1);
        bool crosses = s.phase == PHASE_CROSS && outcome == RAY_GOES_ON;
        if (crosses && turns <= 0) break; // in the next pass
        RayState crossing = cross_sections(crossing_of(s, crosses), ray);
        if (crosses) {
            outcome = outcome_of(crossing);
            s = on_part(s, crossing);
            turns -= crossing.evaluations;
        }
        Part part = part_from(ray, s.low);
        bool is_part = outcome == RAY_GOES_ON && part.begin < part.end;
        ray.t_far = part.end;
#endif
        while (turns > 0 && outcome == RAY_GOES_ON) {
            s.evaluations += 1;
#ifdef PASSES_FREE
            RayState past = pass_free(s, ray);
            if (past.phase == PHASE_DONE) {
                outcome = RAY_IS_FREE;
                break;
            }
            s = past;
#endif
            outcome = any_hit(s, ray, p.offset);
            turns -= 1;
#ifdef GRID
            if (grid_entered > most_elements) turns = 0;
#endif
#ifdef LISTS
            elements -= array0_count;
            if (elements <= 0) turns = 0;
#endif
            if (outcome == RAY_GOES_ON && is_undecided(s, before)) outcome = RAY_IS_UNDECIDED;
        }
#ifdef BOUNDED_TOUCHES
        if (outcome == RAY_IS_SOLVED) outcome = any_hit_solved(s, ray);
        begins = false;
        if (outcome == RAY_GOES_ON && turns > 0) continue;
#endif
#ifdef SECTIONS
        if (outcome == RAY_IS_FREE && is_part && part.end_cut >= 0) {
            s = at_shadow_crossing(s, part.end, part.end_cut);
            begins = false;
            continue;
        }
#endif
        if (outcome == RAY_GOES_ON) break; // in the next pass
        if (outcome == RAY_IS_HIDDEN) s.verdict += 1 << light;
        if (outcome == RAY_IS_UNDECIDED) s.verdict += UNDECIDED_RAY;
        begins = true;
    }
    store_state(s);
}
