// Continues a path where it met a mirror. `is_first`: it is the eye's ray, of whose end shade() tells the
// colour. Needs behind.glsl, mirror_weight() and lit_again().
Path meet(Path path, SurfacePoint p, float way, bool is_first) {
    Hit hit = hit_of(p);
    vec3 to_viewer = -path.direction;
    vec3 mirror = mirror_weight(surface_color(hit), p.normal, to_viewer);
    if (!is_first) {
        path.rays_left -= 1;
        path.light += path.weight * beside_mirror(mirror) * lit_again(p, hit, to_viewer);
    }
    path.weight *= mirror;
    path.position = p.position + p.offset * p.normal;
    path.direction = reflect(path.direction, p.normal);
    path.off = 0.0;
    path.state = PATH_OUTSIDE;
    return unless_faint(path, path.rays_left);
}
