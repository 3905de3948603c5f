// The first surface has none before it. Needs nearest.glsl.
void store_nearest(Ray ray, SurfacePoint p, int evaluations) {
    store_end(p, way_to_end(ray, p), float(evaluations));
}
