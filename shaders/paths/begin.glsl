// The first place on the eye's ray that is in the matter of a surface, which may be the eye's own
// place: how far it is along the way that all surfaces share, and 1 + that surface. Needs
// nearest.glsl; with GLASS also matter.glsl and in_matter.glsl.
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
