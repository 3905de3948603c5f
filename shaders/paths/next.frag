// Continues the paths whose rays ended on this surface, and on the first surface also those that
// met none. Runs for paths that go on. A path ends after MOST_CROSSINGS crossings of bounds.
void main() {
    vec4 end = IM_TEXEL(surface_texture_3, ivec2(pixel_centre));
    if (int(end.z) != SURFACE) discard;
    Path path = load_path();
    SurfacePoint p = load_surface();
    path.evaluations += int(end.y);
    bool is_hit = is_on_surface(p), is_at_bounds = is_hit && p.steepness < 0.0;
#ifdef GLASS
    // The root is the ray's first one, so F keeps its sign before it.
    if (is_hit && !is_at_bounds && p.inside) path.matter = SURFACE;
    if (is_hit && !is_at_bounds && !p.inside && path.matter == SURFACE) path.matter = NO_MATTER;
#endif
    if (is_hit || p.on_ground) path.weight *= absorbed_in(path.matter, p.t);
    bool is_lost = p.verdict != VERDICT_MISS && !is_hit;
    if (p.on_ground) {
        path.position = p.position;
        path.state = PATH_ON_GROUND;
#ifdef GLASS
    } else if (is_at_bounds) {
        path.position = p.position;
        path.off = p.offset;
        path.matter = matter_beyond();
        path.crossings += 1;
        is_lost = path.crossings > MOST_CROSSINGS;
#endif
    } else if (is_hit) {
        path = meet(path, p, p.t, false);
    } else if (!is_lost) {
        path = see_behind(path);
    }
    if (is_lost) { // no pixel lies silently
        bool nan = p.verdict == VERDICT_NAN;
        path.light += path.weight * (nan ? vec3(1.0, 0.0, 1.0) : vec3(1.0, 0.8, 0.0));
        path.state = PATH_LOST;
    }
    store_path(with_ground(path));
}
