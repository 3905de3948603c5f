// Turns the end of a ray into a Hit. Needs hit.glsl and surface_point.glsl.
Hit hit_of(SurfacePoint p) {
    Hit hit = hit_at(p.position, p.normal, p.t, p.inside);
#ifdef SECTIONS
    hit.cap = p.cap;
#endif
    return hit;
}
