// Keeps the nearest of the ends on all surfaces. Needs store_surface.glsl and shared_way().
layout(location = 3) out vec4 surface_3; // shared way, evaluations so far, index of the surface

const float NO_END = 1.0e30;

// Rays that gave up end there, too: what is before that counts, what is behind it doesn't.
float way_to_end(Ray ray, SurfacePoint p) {
    bool ends = p.verdict != VERDICT_MISS || p.on_ground;
    return ends ? shared_way(ray, p.t) : NO_END;
}

void store_end(SurfacePoint p, float way, float evaluations) {
    store_surface(p, 0);
    surface_3 = vec4(way, evaluations, float(SURFACE), 0.0);
}
