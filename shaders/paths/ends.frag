// Stores the ends of paths as ends of rays, where shadow rays start and seen.frag shades. Needs path.glsl
// and store_surface.glsl.
layout(location = 3) out vec4 surface_3;

void main() {
    Path path = load_path_as_it_is();
    bool on_ground = path.state == PATH_ON_GROUND, is_hit = path.state == PATH_ON_SURFACE;
    SurfacePoint p = point_at(path.position, path.off, path.normal, is_hit ? VERDICT_HIT : VERDICT_MISS,
                              path.inside, on_ground, 1.0, 0.0, 20.0 * path.off);
#ifdef SECTIONS
    p.cap = path.cap;
#endif
    store_surface(p, 0);
    surface_3 = vec4(0.0, 0.0, float(owner_of_path()), 0.0);
}
