// Needs meet_glass.glsl, through.glsl and lit_again(). `is_first`: it is the eye's ray, of whose end
// shade() tells the colour. `way`: of the ray.
Path meet(Path path, SurfacePoint p, float way, bool is_first) {
    int beyond = matter_beyond();
    float within = index_of(p.inside ? path.matter : beyond);
    float outside = index_of(p.inside ? beyond : path.matter);
    boundary = vec4(0.0, within / outside, 0.0, 0.0);
    matter_of_ray = path.matter;
    float beside = beside_reflection(refraction_at(p, path.direction).reflected);
    if (is_first) {
        path.own = beside;
    } else {
        path.rays_left -= 1;
        if (!p.inside) path.light += path.weight * beside * lit_again(p, hit_of(p), -path.direction);
    }
    path = through(path, p, way, p.inside ? 1.0 : transmission());
    if (dot(path.direction, p.normal) < 0.0) {
        path.matter = beyond;
    } else { // back: what lies on the other side of the glass is not before it
        path.position += path.off * path.direction;
        path.off = 0.0;
    }
    return unless_faint(path, path.rays_left);
}
