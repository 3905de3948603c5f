// What comes through glass, beside what its surface shows of itself. Needs path.glsl, matter.glsl and
// beside_reflection().

// `own`: of the surface that a ray ended on.
vec3 with_glass(vec3 own, Ray ray, SurfacePoint p) {
    Path path = load_path();
    if (p.on_ground) return path.weight * own; // from within
    float way = p.inside ? p.t - ray.t_near : 0.0;
    float reflected = refraction_at(p, ray.direction).reflected;
    vec3 sum = absorbed(way) * beside_reflection(reflected) * own + path.light;
    if (path.state == PATH_ON_GROUND) sum += path.weight * ground_through_glass(path);
    return sum;
}
