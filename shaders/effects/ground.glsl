// An infinite plane. Needs surface_point.glsl and footprint_at().
uniform vec4 ground_plane; // dot(xyz, p) + w = 0, xyz the world's z axis, formula coordinates

// `begin`: of the ray.
SurfacePoint before_ground(Ray ray, SurfacePoint p, float begin) {
    float slope = dot(ground_plane.xyz, ray.direction);
    if (slope == 0.0) return p;
    float t = -(dot(ground_plane.xyz, ray.anchor) + ground_plane.w) / slope;
    bool is_first = p.verdict == VERDICT_MISS || is_on_surface(p) && t < p.t;
    if (!is_first || t <= begin) return p;
    vec3 position = ray_point(ray, t);
    vec3 normal = slope > 0.0 ? -ground_plane.xyz : ground_plane.xyz;
    float pixel = footprint_at(position);
    return point_at(position, 0.05 * pixel, normal, VERDICT_MISS, false, true, 1.0, t, pixel);
}
