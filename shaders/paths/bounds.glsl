// Where paths begin or end without a surface.

#ifdef GLASS
// Whether a place within this surface's bounds is in its matter.
bool is_in_matter(vec3 position) {
#ifdef SECTIONS
    if (sections_value(position) > 0.0) return false;
#endif
    return field(position) < 0.0;
}
#endif

#ifdef BEGINS_PATHS
// The first place on the eye's ray that is in the matter of a surface, which may be the eye's own
// place: how far it is along the way that all surfaces share, and 1 + that surface. Needs
// nearest.glsl; with GLASS also matter.glsl.
layout(location = 4) out vec4 surface_4;

void store_begin(Ray ray, vec4 others) {
    surface_4 = others;
#ifdef GLASS
    if (!(ray.t_near < ray.t_far) || !is_in_matter(ray_point(ray, ray.t_near))) return;
    float way = shared_way(ray, ray.t_near);
    // Where the eye is in the matter of several surfaces, all begin there.
    float same = 1.0e-5 * max(abs(way), surface_way.x * (ray.t_far - ray.t_near));
    bool goes_before = rank_of(SURFACE) < rank_of(int(others.y) - 1);
    if (way < others.x - same || way < others.x + same && goes_before)
        surface_4 = vec4(way, float(SURFACE + 1), 0.0, 0.0);
#endif
}
#endif
#ifdef ENDS_AT_BOUNDS
// Ends rays where matter begins or ends at the bounds of this surface, without a surface. Needs
// glass/ray.glsl.
const float AT_BOUNDS = -1.0; // steepness of such an end

SurfacePoint or_at_bounds(Ray ray, SurfacePoint p) {
    Path path = load_path();
    bool is_within = path.matter == SURFACE;
    float t = is_within ? max(ray.t_far, path.off) : ray.t_near;
    bool is_first = p.verdict == VERDICT_MISS ? !p.on_ground || t < p.t : !is_within;
    bool enters = ray.t_near > path.off && ray.t_near < ray.t_far;
    if (!may_meet(path) || !is_first || !(is_within || enters)) return p;
    vec3 position = ray_point(ray, t);
    if (!is_within && !is_in_matter(position)) return p;
    float pixel = footprint_at(position);
    return point_at(position, 0.05 * pixel, -ray.direction, VERDICT_HIT, is_within, false, AT_BOUNDS, t,
                    pixel);
}
#endif
