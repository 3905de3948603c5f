// Ends rays where matter begins or ends at the bounds of this surface, without a surface. Needs may_meet.glsl
// and in_matter.glsl.
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
