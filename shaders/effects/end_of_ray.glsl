// Finds the point where a ray ended, and how far from it further rays must start. Needs
// surface_point.glsl.

// Largest component of g, to scale by: |g| may leave float's range long before its direction does.
float magnitude(vec3 g) {
    return max(max(abs(g.x), abs(g.y)), abs(g.z));
}

// Width of a pixel at `position`.
float footprint_at(vec3 position) {
    vec3 eye = ray_origin.xyz - ray_axis.xyz;
    float along = dot(position - eye, ray_axis.xyz) / dot(ray_axis.xyz, ray_axis.xyz);
    float width = picture.y * length(ray_up.xyz);
    return ray_axis.w > 0.0 ? width * max(abs(along), 1.0e-6) : width;
}

// Distance along the normal where F has the sign of the ray's side. The root is known to |F| /
// |grad F|, so twice that is enough but for rounding, which part of a pixel or the loop covers.
float offset_from(SurfacePoint p) {
    float offset = 0.0;
    for (int k = 0; k < 8; ++k) {
        float f = field(p.position + offset * p.normal);
        if (k == 0) {
            offset = clamp(2.0 * abs(f) / max(p.steepness, 1.0e-30), 0.05 * p.pixel, p.pixel);
        } else {
            if (p.inside ? f < 0.0 : f > 0.0) break;
            offset *= 2.0;
        }
    }
    return offset;
}

SurfacePoint end_of_ray(Ray ray, RayState s) {
    vec3 position = ray_point(ray, s.low);
    SurfacePoint p = point_at(position, 0.0, -ray.direction, s.verdict, false, false, 0.0, s.low,
                              footprint_at(position));
#ifdef SECTIONS
    p.cap = cap_of(s);
#endif
    if (s.verdict != VERDICT_HIT) return p;
    vec3 g = surface_gradient(s, position);
    // Must precede the clamp, which turns NaN into a number on some drivers.
    bool known = !(im_is_nan(g.x) || im_is_nan(g.y) || im_is_nan(g.z));
    g = clamp(g, -IM_SATURATION, IM_SATURATION);
    float scale = magnitude(g);
    if (known && scale > 0.0) {
        p.steepness = scale * length(g / scale);
        p.normal = normalize(g / scale);
        p.inside = dot(p.normal, ray.direction) > 0.0; // F rises along the ray
        if (p.inside) p.normal = -p.normal;
    } else {
        p.verdict = VERDICT_ZERO_GRADIENT; // still a hit: lit as if it faced the viewer
    }
    p.offset = offset_from(p);
#ifdef SECTIONS
    if (p.cap >= 0) p.offset = offset_from_cap(position, p.normal, p.cap, p.inside, p.pixel);
#endif
    return p;
}

#ifdef MEETS_GROUND
// The end on an infinite plane, where that comes first.
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
#endif
