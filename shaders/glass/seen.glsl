// Adds the light through glass to the light of its surface. Needs path.glsl, matter.glsl and
// beside_reflection().

// `own`: the colour of the surface on which a ray ended.
vec3 with_glass(vec3 own, Ray ray, SurfacePoint p) {
    Path path = load_path();
    if (p.on_ground) return path.weight * own; // seen from within glass
    float way = p.inside ? p.t - ray.t_near : 0.0;
    float reflected = refraction_at(p, ray.direction, glass.y).reflected;
    vec3 sum = absorbed(way) * beside_reflection(reflected) * own + path.light;
    if (path.state == PATH_ON_GROUND) sum += path.weight * ground_through_glass(path);
    return sum;
}
